package haltere.filters.orientation.camera;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.zip.GZIPInputStream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipException;
import java.util.zip.ZipFile;

/**
 * A {@code .braidz} file of Braid: a ZIP of gzipped tables without a folder of their own, and the
 * calibration as XML. Read are {@code cam_info} (number and name of each camera), {@code
 * data2d_distorted} (each detection: frame, time, place, area, slope, eccentricity) and {@code
 * data_association} (which detection is of which object). The angle of a line is the arc tangent of
 * its slope. Frames of all cameras with the same number are of the same time; it is that of the
 * trigger, or, where there is none, when the first of its pictures was received.
 *
 * <p>Detections that belong to no object are left out. Memory grows with the associated ones.
 *
 * @param cameras the calibration
 * @param seen what was seen, ascending in time
 */
public record BraidzFile(CameraFile cameras, List<Seen> seen) {
  /**
   * A detection of an object.
   *
   * @param timeUs microseconds since 1970
   * @param object number of the object
   * @param line what was seen
   */
  public record Seen(long timeUs, String object, LineObservation line) {}

  private record Key(long frame, int camera, int point) {}

  private record Raw(long frame, String object, LineObservation line) {}

  /** Copies. */
  public BraidzFile {
    seen = List.copyOf(seen);
  }

  /**
   * Whether a file is a ZIP, by its first bytes.
   *
   * @param file any
   * @return true for a ZIP
   * @throws IOException if it cannot be read
   */
  public static boolean isZip(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] head = in.readNBytes(4);
      return head.length == 4 && head[0] == 'P' && head[1] == 'K' && head[2] == 3 && head[3] == 4;
    }
  }

  /**
   * Reads a file.
   *
   * @param file a ZIP
   * @return what is in it
   * @throws TableProblem if something is missing or damaged; the message names the file
   * @throws IOException if it cannot be read
   */
  public static BraidzFile read(Path file) throws IOException {
    try (ZipFile zip = new ZipFile(file.toFile())) {
      ZipEntry xml = zip.getEntry("calibration.xml");
      if (xml == null) {
        throw new TableProblem(file + ": there is no calibration.xml in it, so no cameras");
      }
      CameraFile cameras;
      try (InputStream in = zip.getInputStream(xml)) {
        cameras = CameraXml.read(in, file + ": calibration.xml");
      }
      return read(file, zip, cameras);
    } catch (ZipException damaged) {
      throw new TableProblem(file + ": this ZIP is damaged: " + damaged.getMessage());
    }
  }

  private static BraidzFile read(Path file, ZipFile zip, CameraFile cameras) throws IOException {
    Map<Integer, Integer> numbers = new HashMap<>();
    table(
        file,
        zip,
        "cam_info",
        List.of("camn", "cam_id"),
        row -> {
          for (int i = 0; i < cameras.cameras().size(); i++) {
            if (sameName(cameras.cameras().get(i).id(), row[1])) {
              numbers.put(Integer.parseInt(row[0]), i);
            }
          }
        });
    Map<Key, String> objects = new HashMap<>();
    table(
        file,
        zip,
        "data_association",
        List.of("obj_id", "frame", "cam_num", "pt_idx"),
        row ->
            objects.put(
                new Key(Long.parseLong(row[1]), Integer.parseInt(row[2]), Integer.parseInt(row[3])),
                row[0]));
    List<Raw> raw = new ArrayList<>();
    Map<Long, double[]> times = new HashMap<>();
    table(
        file,
        zip,
        "data2d_distorted",
        List.of(
            "camn",
            "frame",
            "timestamp",
            "cam_received_timestamp",
            "x",
            "y",
            "area",
            "slope",
            "eccentricity",
            "frame_pt_idx"),
        row -> detection(row, numbers, objects, raw, times));
    List<Seen> seen = new ArrayList<>(raw.size());
    for (Raw each : raw) {
      double[] time = times.get(each.frame());
      double seconds = Double.isNaN(time[0]) ? time[1] : time[0];
      if (Double.isFinite(seconds)) {
        seen.add(new Seen(Math.round(seconds * 1e6), each.object(), each.line()));
      }
    }
    seen.sort(Comparator.comparingLong(Seen::timeUs));
    return new BraidzFile(cameras, seen);
  }

  private static void detection(
      String[] row,
      Map<Integer, Integer> numbers,
      Map<Key, String> objects,
      List<Raw> raw,
      Map<Long, double[]> times) {
    int number = Integer.parseInt(row[0]);
    long frame = Long.parseLong(row[1]);
    Integer camera = numbers.get(number);
    double trigger = decimal(row[2]);
    double received = decimal(row[3]);
    double x = decimal(row[4]);
    String object =
        row[9].isEmpty() ? null : objects.get(new Key(frame, number, Integer.parseInt(row[9])));
    if (camera == null || object == null || Double.isNaN(x)) {
      return;
    }
    double[] time = times.computeIfAbsent(frame, f -> new double[] {Double.NaN, Double.NaN});
    if (Double.isNaN(time[0])) {
      time[0] = trigger;
    }
    if (Double.isNaN(time[1]) || received < time[1]) {
      time[1] = received;
    }
    raw.add(
        new Raw(
            frame,
            object,
            new LineObservation(
                camera,
                x,
                decimal(row[5]),
                Math.atan(decimal(row[7])),
                decimal(row[6]),
                decimal(row[8]))));
  }

  /** Older files have underscores where a camera's name has a hyphen. */
  private static boolean sameName(String calibrated, String used) {
    return calibrated.equals(used) || calibrated.replace('-', '_').equals(used.replace('-', '_'));
  }

  private static double decimal(String text) {
    return text.isEmpty() || text.equalsIgnoreCase("nan") ? Double.NaN : Double.parseDouble(text);
  }

  private interface Row {
    void take(String[] fields);
  }

  private static void table(Path file, ZipFile zip, String name, List<String> columns, Row row)
      throws IOException {
    ZipEntry entry = zip.getEntry(name + ".csv.gz");
    if (entry == null) {
      throw new TableProblem(
          file + ": there is no " + name + ".csv.gz in it; a .braidz file has no folder inside");
    }
    long number = 0;
    try (BufferedReader in =
        new BufferedReader(
            new InputStreamReader(
                new GZIPInputStream(zip.getInputStream(entry)), StandardCharsets.UTF_8))) {
      String header = in.readLine();
      if (header == null) {
        return; // a table without rows has no header either
      }
      List<String> names = ObservationTable.fields(header);
      int[] places = columns.stream().mapToInt(names::indexOf).toArray();
      for (int i = 0; i < places.length; i++) {
        if (places[i] < 0) {
          throw new TableProblem(
              file + ": " + name + ": there is no column " + columns.get(i) + " in line 1");
        }
      }
      String[] fields = new String[places.length];
      number = 1;
      for (String line = in.readLine(); line != null; line = in.readLine()) {
        number++;
        List<String> all = ObservationTable.fields(line);
        for (int i = 0; i < places.length; i++) {
          fields[i] = places[i] < all.size() ? all.get(places[i]).strip() : "";
        }
        row.take(fields);
      }
    } catch (NumberFormatException noNumber) {
      throw new TableProblem(
          file + ": " + name + ": line " + number + ": " + noNumber.getMessage());
    } catch (java.io.EOFException | ZipException damaged) {
      throw new TableProblem(file + ": " + name + ": damaged after line " + number);
    }
  }
}
