package haltere.filters.estimation.example;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntToDoubleFunction;

/** Columns of numbers by name, all of the same length. Immutable once it is handed out. */
public final class ExampleTable {
  private final Map<String, double[]> columns = new LinkedHashMap<>();
  private final int rows;

  ExampleTable(int rows) {
    this.rows = rows;
  }

  ExampleTable add(String name, IntToDoubleFunction value) {
    double[] values = new double[rows];
    Arrays.setAll(values, value);
    columns.put(name, values);
    return this;
  }

  /**
   * A column.
   *
   * @param name as in the header
   * @return a copy, an entry for each row; NaN is unknown
   */
  public double[] column(String name) {
    return columns.get(name).clone();
  }

  /**
   * The table as text: comma separated, a header, {@code .} as decimal point, unknown is empty.
   *
   * @return lines that end in a line feed
   */
  public String csv() {
    StringBuilder csv = new StringBuilder(String.join(",", columns.keySet())).append('\n');
    for (int k = 0; k < rows; k++) {
      String separator = "";
      for (double[] column : columns.values()) {
        csv.append(separator).append(Double.isNaN(column[k]) ? "" : Double.toString(column[k]));
        separator = ",";
      }
      csv.append('\n');
    }
    return csv.toString();
  }
}
