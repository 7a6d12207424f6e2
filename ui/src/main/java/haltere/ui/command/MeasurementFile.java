package haltere.ui.command;

import haltere.core.format.RecordingFile;
import haltere.core.format.internal.csv.CsvTable;
import haltere.filters.estimation.internal.example.Measurement;
import haltere.filters.estimation.internal.example.MeasurementSeries;
import haltere.ui.command.terminal.Quantities;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads a table of measurements: columns {@code t_s,x_m} and optionally {@code a_m_s2}, in any
 * order; other columns are ignored.
 */
final class MeasurementFile {
  /** Rows whose estimates stay below 100 MB. */
  private static final int MAX_ROWS = 20_000;

  private static final List<String> COLUMNS = List.of("t_s", "x_m", "a_m_s2");

  private final Path file;
  private final CsvTable table;
  private final List<Measurement> measurements = new ArrayList<>();

  private MeasurementFile(Path file, CsvTable table) {
    this.file = file;
    this.table = table;
  }

  /**
   * Reads a table; refuses another file by a {@link CommandProblem} that names the file and the
   * line, and measurements that never change by an {@link IllegalArgumentException}.
   */
  static MeasurementSeries read(Path file) throws IOException {
    RecordingFile.checkRegular(file);
    try (BufferedReader in = Files.newBufferedReader(file)) {
      return new MeasurementFile(file, new CsvTable(in, COLUMNS)).read();
    } catch (CharacterCodingException notText) {
      throw Failures.notText(file, notText);
    }
  }

  private MeasurementSeries read() throws IOException {
    List<String> header = table.header();
    if (header.isEmpty()) {
      throw new CommandProblem(file + ": this file is empty; its first line names the columns");
    }
    for (String column : COLUMNS.subList(0, 2)) {
      if (!header.contains(column)) {
        throw problem(
            "there is no column " + column + "; the columns are t_s,x_m or t_s,x_m,a_m_s2");
      }
    }
    while (table.next()) {
      take();
    }
    if (measurements.size() < MeasurementSeries.MIN_SIZE) {
      String form = "the table ends after %s; at least %d are needed";
      String rows = Quantities.counted(measurements.size(), "row");
      throw problem(Quantities.text(form, rows, MeasurementSeries.MIN_SIZE));
    }
    return new MeasurementSeries(measurements);
  }

  private void take() {
    int columns = table.header().size();
    if (table.size() != columns) {
      throw problem("it has " + table.size() + " fields, not " + columns);
    }
    if (measurements.size() == MAX_ROWS) {
      throw problem("there are more than " + MAX_ROWS + " rows; cut or thin the measurements");
    }
    double t = number(0);
    if (!measurements.isEmpty() && !(t > measurements.get(measurements.size() - 1).tS())) {
      throw problem("t_s is " + t + ", not after the row above; sort the rows by time");
    }
    boolean hasAcceleration = table.header().contains(COLUMNS.get(2));
    measurements.add(new Measurement(t, number(1), hasAcceleration ? number(2) : Double.NaN));
  }

  private double number(int column) {
    try {
      double value = table.number(column);
      if (Double.isFinite(value)) {
        return value;
      }
    } catch (NumberFormatException noNumber) {
      // Reported below.
    }
    throw problem(COLUMNS.get(column) + " is \"" + table.text(column) + "\", not a finite number");
  }

  private CommandProblem problem(String what) {
    return new CommandProblem(file + ": line " + table.line() + ": " + what);
  }
}
