package haltere.filters.orientation.camera;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.csv.CsvTable;
import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads observations from a table with the columns {@code
 * t_us,camera,object,x_px,y_px,angle_rad,area_px,eccentricity}, in any order, among others. A row
 * is one body in one camera; rows ascend in time; an empty field is unknown. An invalid row is
 * reported to the listener and skipped.
 */
final class ObservationTable {
  private static final List<String> COLUMNS =
      List.of("t_us", "camera", "object", "x_px", "y_px", "angle_rad", "area_px", "eccentricity");

  private final Map<String, Integer> cameras = new HashMap<>();
  private final ObservationFile.Listener listener;
  private long lastUs = Long.MIN_VALUE;

  private ObservationTable(List<CameraModel> models, ObservationFile.Listener listener) {
    for (CameraModel camera : models) {
      cameras.put(camera.id(), cameras.size());
    }
    this.listener = listener;
  }

  /** Reads a table of UTF-8 text. */
  static void read(Path file, List<CameraModel> cameras, ObservationFile.Listener listener)
      throws IOException {
    ObservationTable observations = new ObservationTable(cameras, listener);
    RecordingFile.checkRegular(file);
    try (BufferedReader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      CsvTable table = new CsvTable(in, COLUMNS);
      if (table.header().isEmpty()) {
        throw new RecordingProblem(file, "this file is empty; its first line names the columns");
      }
      for (String column : COLUMNS) {
        if (!table.header().contains(column)) {
          throw new RecordingProblem(
              file,
              "line 1: there is no column "
                  + column
                  + "; the columns are "
                  + String.join(",", COLUMNS));
        }
      }
      while (table.next()) {
        String problem = observations.row(table);
        if (!problem.isEmpty()) {
          listener.skipped("line " + table.line(), problem);
        }
      }
    }
  }

  /** Reads a row; returns its problem, or an empty text. */
  private String row(CsvTable row) {
    if (row.size() != row.header().size()) {
      return "it has " + row.size() + " fields, not " + row.header().size();
    }
    long timeUs;
    try {
      timeUs = Long.parseLong(row.text(0));
    } catch (NumberFormatException noTime) {
      return "t_us is \"" + row.text(0) + "\", not a whole number of microseconds";
    }
    Integer camera = cameras.get(row.text(1));
    if (camera == null) {
      return "there is no camera \"" + row.text(1) + "\"";
    }
    double[] values = new double[5];
    for (int i = 0; i < 5; i++) {
      try {
        values[i] = row.number(3 + i);
      } catch (NumberFormatException noNumber) {
        return COLUMNS.get(3 + i) + " is \"" + row.text(3 + i) + "\", not a number";
      }
    }
    if (timeUs < lastUs) {
      return "its time " + timeUs + " us is before " + lastUs + " us of a row above";
    }
    lastUs = timeUs;
    listener.observed(
        timeUs,
        row.text(2),
        new LineObservation(camera, values[0], values[1], values[2], values[3], values[4]));
    return "";
  }
}
