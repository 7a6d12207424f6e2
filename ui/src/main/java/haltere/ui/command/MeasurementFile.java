package haltere.ui.command;

import haltere.filters.estimation.example.Measurement;
import haltere.filters.estimation.example.MeasurementSeries;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Reads a table of measurements with the columns {@code t_s,x_m} and, where accelerations were
 * measured, {@code a_m_s2}, in any order and with others beside them.
 */
final class MeasurementFile {
  /** Rows whose estimates stay below 100 MB. */
  private static final int MAX_ROWS = 20_000;

  private static final List<String> COLUMNS = List.of("t_s", "x_m", "a_m_s2");

  private final Path file;
  private final int[] places = new int[COLUMNS.size()];
  private final List<Measurement> measurements = new ArrayList<>();
  private int columns;
  private int line;

  private MeasurementFile(Path file) {
    this.file = file;
  }

  /**
   * Reads a table.
   *
   * @throws CommandProblem if it is no such table; the message names the file and the line
   * @throws IllegalArgumentException if its measurements never change
   */
  static MeasurementSeries read(Path file) throws IOException {
    try (BufferedReader in = Files.newBufferedReader(file)) {
      MeasurementFile table = new MeasurementFile(file);
      for (String text = in.readLine(); text != null; text = in.readLine()) {
        table.take(text);
      }
      if (table.line == 0) {
        throw new CommandProblem(file + ": this file is empty; its first line names the columns");
      }
      if (table.measurements.size() < MeasurementSeries.MIN_SIZE) {
        throw table.problem(
            "the table ends after "
                + table.measurements.size()
                + " rows; at least "
                + MeasurementSeries.MIN_SIZE
                + " are needed");
      }
      return new MeasurementSeries(table.measurements);
    } catch (CharacterCodingException notText) {
      throw Failures.notText(file, notText);
    }
  }

  private void take(String text) {
    line++;
    if (line > 1 && text.isBlank()) {
      return;
    }
    List<String> fields =
        Arrays.stream(text.replace("\ufeff", "").split(",", -1)).map(String::strip).toList();
    if (line == 1) {
      columns = fields.size();
      Arrays.setAll(places, i -> fields.indexOf(COLUMNS.get(i)));
      for (int i = 0; i < 2; i++) {
        if (places[i] < 0) {
          throw problem(
              "there is no column "
                  + COLUMNS.get(i)
                  + "; the columns are t_s,x_m or t_s,x_m,a_m_s2");
        }
      }
      return;
    }
    if (fields.size() != columns) {
      throw problem("it has " + fields.size() + " fields, not " + columns);
    }
    if (measurements.size() == MAX_ROWS) {
      throw problem("there are more than " + MAX_ROWS + " rows; cut or thin the measurements");
    }
    double t = number(fields, 0);
    if (!measurements.isEmpty() && !(t > measurements.get(measurements.size() - 1).tS())) {
      throw problem("t_s is " + t + ", not after the row above; sort the rows by time");
    }
    measurements.add(
        new Measurement(t, number(fields, 1), places[2] < 0 ? Double.NaN : number(fields, 2)));
  }

  private double number(List<String> fields, int column) {
    String text = fields.get(places[column]);
    try {
      double value = Double.parseDouble(text);
      if (Double.isFinite(value) && !Character.isLetter(text.charAt(text.length() - 1))) {
        return value;
      }
    } catch (NumberFormatException noNumber) {
      // Told below.
    }
    throw problem(COLUMNS.get(column) + " is \"" + text + "\", not a finite number");
  }

  private CommandProblem problem(String what) {
    return new CommandProblem(file + ": line " + line + ": " + what);
  }
}
