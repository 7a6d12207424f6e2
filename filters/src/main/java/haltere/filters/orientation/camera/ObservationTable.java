package haltere.filters.orientation.camera;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * Reads what cameras saw from a table with the columns {@code
 * t_us,camera,object,x_px,y_px,angle_rad,area_px,eccentricity}, in any order, others beside them. A
 * row is one body in one camera; rows ascend in time; an empty field is unknown. A row that cannot
 * be understood is told to the listener and left out.
 */
final class ObservationTable {
  private static final List<String> COLUMNS =
      List.of("t_us", "camera", "object", "x_px", "y_px", "angle_rad", "area_px", "eccentricity");

  private final Map<String, Integer> cameras = new HashMap<>();
  private final int[] places = new int[COLUMNS.size()];
  private final ObservationListener listener;
  private boolean hasTime;
  private long lastUs;

  private ObservationTable(List<CameraModel> models, ObservationListener listener) {
    for (CameraModel camera : models) {
      cameras.put(camera.id(), cameras.size());
    }
    this.listener = listener;
  }

  /** Reads a table of UTF-8 text. */
  static void read(Path file, List<CameraModel> cameras, ObservationListener listener)
      throws IOException {
    try (BufferedReader in = Files.newBufferedReader(file, StandardCharsets.UTF_8)) {
      new ObservationTable(cameras, listener).read(file, in);
    }
  }

  private void read(Path file, BufferedReader in) throws IOException {
    String header = in.readLine();
    if (header == null) {
      throw new TableProblem(file + ": this file is empty; its first line names the columns");
    }
    List<String> names = fields(header.replace("\ufeff", "")).stream().map(String::strip).toList();
    for (int i = 0; i < places.length; i++) {
      places[i] = names.indexOf(COLUMNS.get(i));
      if (places[i] < 0) {
        throw new TableProblem(
            file
                + ": line 1: there is no column "
                + COLUMNS.get(i)
                + "; the columns are "
                + String.join(",", COLUMNS));
      }
    }
    long number = 1;
    for (String text = in.readLine(); text != null; text = in.readLine()) {
      number++;
      if (!text.isBlank()) {
        row(number, fields(text), names.size());
      }
    }
  }

  private void row(long number, List<String> fields, int columns) {
    if (fields.size() != columns) {
      bad(number, "it has " + fields.size() + " fields, not " + columns);
      return;
    }
    String time = fields.get(places[0]).strip();
    long timeUs;
    try {
      timeUs = Long.parseLong(time);
    } catch (NumberFormatException noTime) {
      bad(number, "t_us is \"" + time + "\", not a whole number of microseconds");
      return;
    }
    Integer camera = cameras.get(fields.get(places[1]).strip());
    if (camera == null) {
      bad(number, "there is no camera \"" + fields.get(places[1]) + "\"");
      return;
    }
    double[] values = new double[5];
    for (int i = 0; i < 5; i++) {
      String text = fields.get(places[3 + i]).strip();
      try {
        values[i] = text.isEmpty() ? Double.NaN : number(text);
      } catch (NumberFormatException noNumber) {
        bad(number, COLUMNS.get(3 + i) + " is \"" + text + "\", not a number");
        return;
      }
    }
    if (hasTime && timeUs < lastUs) {
      bad(number, "its time " + timeUs + " us is before " + lastUs + " us of a row above");
      return;
    }
    hasTime = true;
    lastUs = timeUs;
    listener.seen(
        timeUs,
        fields.get(places[2]).strip(),
        new LineObservation(camera, values[0], values[1], values[2], values[3], values[4]));
  }

  private void bad(long number, String why) {
    listener.bad("line " + number, why);
  }

  /** As Java reads it, and in the ways in which other programs write what is no number. */
  private static double number(String text) {
    return switch (text.toLowerCase(java.util.Locale.ROOT)) {
      case "nan", "-nan" -> Double.NaN;
      case "inf", "+inf", "infinity" -> Double.POSITIVE_INFINITY;
      case "-inf", "-infinity" -> Double.NEGATIVE_INFINITY;
      default -> {
        char last = text.charAt(text.length() - 1);
        if (Character.isLetter(last)) {
          throw new NumberFormatException(text); // Java would take 1d and 1f
        }
        yield Double.parseDouble(text);
      }
    };
  }

  /** The fields of a line; quoted ones without their quotes. */
  static List<String> fields(String line) {
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
