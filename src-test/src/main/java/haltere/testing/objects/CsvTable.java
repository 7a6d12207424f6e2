package haltere.testing.objects;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.Reader;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/** Reads tables of plain numbers and words: a header line, commas, no quotes. */
final class CsvTable {
  private CsvTable() {}

  /** A line of the table, borrowed for the length of a call. */
  static final class Row {
    private final List<String> names;
    private String[] fields;

    private Row(List<String> names) {
      this.names = names;
    }

    /** A field's text, or empty if the table has no such column. */
    String text(String column) {
      int index = names.indexOf(column);
      return index < 0 || index >= fields.length ? "" : fields[index];
    }

    /** A field's number, or NaN if it is empty or the table has no such column. */
    double number(String column) {
      String text = text(column);
      return text.isEmpty() ? Double.NaN : Double.parseDouble(text);
    }
  }

  /**
   * Reads all lines.
   *
   * @throws IOException if the text cannot be read, or a required column is missing
   */
  static void read(Reader text, List<String> required, Consumer<Row> each) throws IOException {
    BufferedReader lines = new BufferedReader(text);
    String header = lines.readLine();
    Row row = new Row(Arrays.asList(header == null ? new String[0] : header.strip().split(",")));
    if (!row.names.containsAll(required)) {
      throw new IOException("the table needs the columns " + required + ", it has " + row.names);
    }
    for (String line = lines.readLine(); line != null; line = lines.readLine()) {
      if (!line.isBlank()) {
        row.fields = line.strip().split(",", -1);
        each.accept(row);
      }
    }
  }
}
