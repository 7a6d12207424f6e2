package haltere.core.format.internal.csv;

import haltere.core.format.internal.table.RecordingTables;
import java.io.BufferedReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/**
 * A table of text whose first line names the columns, read row by row: fields between commas, with
 * or without quotes; blank lines are skipped.
 *
 * <p>Thread rule: one thread.
 */
public final class CsvTable implements RecordingTables.Row {
  private final BufferedReader in;
  private final List<String> header;
  private final int[] indexes;
  private List<String> fields = List.of();
  private long line;

  /**
   * Reads the first line.
   *
   * @param in the table; stays open
   * @param names requested columns
   * @throws IOException if it cannot be read
   */
  public CsvTable(BufferedReader in, List<String> names) throws IOException {
    this.in = in;
    String first = in.readLine();
    line = first == null ? 0 : 1;
    header =
        first == null
            ? List.of()
            : fields(first.replace("\ufeff", "")).stream().map(String::strip).toList();
    indexes = names.stream().mapToInt(header::indexOf).toArray();
  }

  /**
   * Names of the columns.
   *
   * @return as in the first line; empty for an empty file
   */
  public List<String> header() {
    return header;
  }

  /**
   * Advances to the next row.
   *
   * @return false at the end
   * @throws IOException if it cannot be read
   */
  public boolean next() throws IOException {
    String text;
    do {
      text = in.readLine();
      line += text == null ? 0 : 1;
    } while (text != null && text.isBlank());
    fields = text == null ? List.of() : fields(text);
    return text != null;
  }

  /**
   * Number of the line read last.
   *
   * @return from 1; 0 for an empty file
   */
  public long line() {
    return line;
  }

  /**
   * Fields of the row.
   *
   * @return at least 1
   */
  public int size() {
    return fields.size();
  }

  @Override
  public long index() {
    return line - 2;
  }

  @Override
  public String text(int column) {
    int index = indexes[column];
    return index >= 0 && index < fields.size() ? fields.get(index).strip() : "";
  }

  /**
   * {@inheritDoc} Parsed as by Java, with the forms of not-a-number of other programs.
   *
   * @throws NumberFormatException if it is not a number
   */
  @Override
  public double number(int column) {
    String text = text(column);
    return switch (text.toLowerCase(Locale.ROOT)) {
      case "", "nan", "-nan" -> Double.NaN;
      case "inf", "+inf", "infinity" -> Double.POSITIVE_INFINITY;
      case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
      default -> {
        if (Character.isLetter(text.charAt(text.length() - 1))) {
          throw new NumberFormatException(text); // Java would accept 1d and 1f
        }
        yield Double.parseDouble(text);
      }
    };
  }

  @Override
  public long[] list(int column) {
    return new long[0];
  }

  /** The fields of a line; quoted ones without their quotes. */
  private static List<String> fields(String line) {
    if (line.indexOf('"') < 0) {
      return Arrays.asList(line.split(",", -1));
    }
    List<String> fields = new ArrayList<>();
    StringBuilder field = new StringBuilder();
    boolean quoted = false;
    for (int i = 0; i < line.length(); i++) {
      char c = line.charAt(i);
      if (c == '"' && quoted && i + 1 < line.length() && line.charAt(i + 1) == '"') {
        field.append('"');
        i++;
      } else if (c == '"') {
        quoted = !quoted;
      } else if (c == ',' && !quoted) {
        fields.add(field.toString());
        field.setLength(0);
      } else {
        field.append(c);
      }
    }
    fields.add(field.toString());
    return fields;
  }
}
