package haltere.filters.estimation.internal.example;

import haltere.filters.estimation.Estimate;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.IntToDoubleFunction;

/** Columns of numbers by name, all of the same length; immutable after construction. */
public final class ExampleTable {
  private final Map<String, double[]> columns = new LinkedHashMap<>();
  private final int rows;

  /** The measurements, with their finite differences. */
  ExampleTable(MeasurementSeries series) {
    rows = series.size();
    add("t_s", k -> series.get(k).tS());
    add("x_m", k -> series.get(k).xM());
    add("difference_v_m_s", series::velocity);
    add("difference_a_m_s2", series::acceleration);
  }

  ExampleTable add(String name, IntToDoubleFunction value) {
    double[] values = new double[rows];
    Arrays.setAll(values, value);
    columns.put(name, values);
    return this;
  }

  /** An entry of the state with its standard deviation. */
  ExampleTable add(String name, List<Estimate> estimates, int entry) {
    add(name, k -> estimates.get(k).value(entry));
    return add("sd_" + name, k -> estimates.get(k).standardDeviation(entry));
  }

  /** An entry of the gain of the displacement, the first entry: P Hᵀ R⁻¹, P after the update. */
  ExampleTable addGain(String name, List<Estimate> estimates, int entry, double noise) {
    return add(name, k -> estimates.get(k).covariance().get(entry, 0) / (noise * noise));
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
   * {@return the table as comma-separated text: a header, {@code .} as decimal point, unknown is
   * empty}
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
