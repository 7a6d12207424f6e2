package haltere.filters.orientation.camera;

import haltere.core.format.RecordingProblem;
import haltere.core.format.internal.table.RecordingTables;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Detections of a Flydra (HDF5) or Braid ({@code .braidz}) recording, joined from its tables:
 *
 * <ul>
 *   <li>{@code data2d_distorted}: each detection with {@code camn}, {@code frame}, {@code x},
 *       {@code y} or {@code intercept}, {@code slope} and {@code timestamp} (of the trigger,
 *       seconds since 1970); optionally {@code cam_received_timestamp}, {@code area}, {@code
 *       eccentricity}, {@code frame_pt_idx}, {@code obj_id}.
 *   <li>{@code cam_info}: the name {@code cam_id} of each {@code camn}; without it, {@code camn} is
 *       the number at the end of a camera's name.
 *   <li>assignment of detections to bodies: {@code data_association} (Braid), {@code ML_estimates}
 *       or {@code kalman_observations} with the lists {@code …_2d_idxs} (Flydra), or {@code obj_id}
 *       of the detection.
 * </ul>
 *
 * <p>The angle of a line is the arc tangent of its slope; an infinite slope is a vertical line.
 * Frames of all cameras with the same number are of the same time: that of the trigger, or else of
 * the first received picture. A detection of no body and a frame without a detection (Flydra writes
 * NaN) are skipped. Memory grows with the associated detections.
 */
final class FlydraDetections {
  private static final String DETECTIONS = "data2d_distorted";
  private static final List<String> COLUMNS =
      List.of(
          "camn",
          "frame",
          "slope",
          "x",
          "timestamp",
          "y",
          "intercept",
          "cam_received_timestamp",
          "area",
          "eccentricity",
          "frame_pt_idx",
          "obj_id");
  private static final Pattern NUMBER_AT_END = Pattern.compile("\\d{1,9}$");
  private static final int REQUIRED = 5;
  private static final long UNKNOWN_US = Long.MIN_VALUE;

  private record Key(long frame, long camera, long point) {}

  private record Detection(long frame, String object, LineObservation line) {}

  private final Path file;
  private final RecordingTables tables;
  private final List<CameraModel> cameras;
  private final ObservationFile.Listener listener;
  private final Map<Long, String> names = new HashMap<>();
  private final Map<Long, Integer> numbers = new HashMap<>();
  private final Map<Key, String> objects = new HashMap<>();
  private final List<Detection> detections = new ArrayList<>();

  /** By frame: time of the trigger, time of the first reception, seconds; NaN if unknown. */
  private final Map<Long, double[]> times = new HashMap<>();

  private boolean isAssociated;

  FlydraDetections(
      Path file,
      RecordingTables tables,
      List<CameraModel> cameras,
      ObservationFile.Listener listener) {
    this.file = file;
    this.tables = tables;
    this.cameras = cameras;
    this.listener = listener;
  }

  /** Reads all; returns the frame of each time. */
  Map<Long, Long> read() throws IOException {
    readCameras();
    readAssociation();
    readDetections();
    Map<Long, Long> frames = new HashMap<>();
    times.forEach((frame, time) -> frames.put(timeUs(time), frame));
    return frames;
  }

  /** Passes on the detections, in order of time. */
  void handOut() {
    detections.sort(Comparator.comparingLong(each -> timeUs(times.get(each.frame()))));
    for (Detection each : detections) {
      long timeUs = timeUs(times.get(each.frame()));
      if (timeUs == UNKNOWN_US) {
        listener.skipped("frame " + each.frame(), "no camera has a time for it");
      } else {
        listener.observed(timeUs, each.object(), each.line());
      }
    }
  }

  private static long timeUs(double[] time) {
    double seconds = Double.isNaN(time[0]) ? time[1] : time[0];
    return Double.isFinite(seconds) ? Math.round(seconds * 1e6) : UNKNOWN_US;
  }

  private void readCameras() throws IOException {
    if (tables.has("cam_info")) {
      tables.read(
          "cam_info",
          List.of("camn", "cam_id"),
          2,
          row -> names.put((long) row.number(0), row.text(1)));
      List<String> ids = cameras.stream().map(camera -> plain(camera.id())).toList();
      names.forEach((number, name) -> numbers.put(number, ids.indexOf(plain(name))));
      return;
    }
    for (int i = 0; i < cameras.size(); i++) {
      Matcher end = NUMBER_AT_END.matcher(cameras.get(i).id());
      if (end.find() && numbers.put(Long.parseLong(end.group()), i) != null) {
        throw new RecordingProblem(
            file, "it has no table cam_info, and two cameras end in the number " + end.group());
      }
    }
  }

  /** Older files have underscores where a camera's name has a hyphen. */
  private static String plain(String name) {
    return name.replace('-', '_');
  }

  private void readAssociation() throws IOException {
    if (tables.has("data_association")) {
      isAssociated = true;
      tables.read(
          "data_association",
          List.of("obj_id", "frame", "cam_num", "pt_idx"),
          4,
          row ->
              objects.put(
                  new Key((long) row.number(1), (long) row.number(2), (long) row.number(3)),
                  row.text(0)));
      return;
    }
    for (String estimates : List.of("ML_estimates", "kalman_observations")) {
      String lists = estimates + "_2d_idxs";
      if (!isAssociated && tables.has(estimates) && tables.has(lists)) {
        isAssociated = true;
        List<long[]> points = new ArrayList<>();
        tables.read(lists, List.of(lists), 1, row -> points.add(row.list(0)));
        tables.read(
            estimates,
            List.of("obj_id", "frame", "obs_2d_idx"),
            3,
            row -> associate(row.text(0), (long) row.number(1), row.number(2), points));
      }
    }
  }

  /** Assigns the pairs of camera and point of an estimate to its body. */
  private void associate(String object, long frame, double index, List<long[]> points) {
    if (index >= 0 && index < points.size()) {
      long[] pairs = points.get((int) index);
      for (int i = 0; i + 1 < pairs.length; i += 2) {
        objects.put(new Key(frame, pairs[i], pairs[i + 1]), object);
      }
    }
  }

  private void readDetections() throws IOException {
    Set<String> there = tables.columns(DETECTIONS);
    if (!there.isEmpty() && !there.contains("y") && !there.contains("intercept")) {
      throw new RecordingProblem(file, "the table " + DETECTIONS + " has no column y or intercept");
    }
    if (!isAssociated && !there.isEmpty() && !there.contains("obj_id")) {
      listener.remark("no table assigns detections to bodies; all are taken for one");
    }
    tables.read(DETECTIONS, COLUMNS, REQUIRED, this::detection);
  }

  private void detection(RecordingTables.Row row) throws IOException {
    double number = row.number(0);
    double frame = row.number(1);
    double slope = row.number(2);
    double x = row.number(3);
    double y = row.number(5);
    double intercept = row.number(6);
    double point = row.number(10);
    y = Double.isNaN(y) ? slope * x + intercept : y;
    String object =
        isAssociated
            ? objects.get(new Key((long) frame, (long) number, (long) point))
            : row.text(11).isEmpty() ? "0" : row.text(11);
    if (object == null || Double.isNaN(x)) {
      return;
    }
    String where = "row " + row.index() + " of " + DETECTIONS;
    int camera = numbers.getOrDefault((long) number, -1);
    if (camera < 0) {
      String name = names.containsKey((long) number) ? " \"" + names.get((long) number) + '"' : "";
      listener.skipped(where, "there is no camera number " + (long) number + name);
    } else if (Double.isNaN(frame)) {
      listener.skipped(where, "it has no frame");
    } else {
      double[] time =
          times.computeIfAbsent((long) frame, f -> new double[] {Double.NaN, Double.NaN});
      time[0] = Double.isNaN(time[0]) ? row.number(4) : time[0];
      double received = row.number(7);
      time[1] = Double.isNaN(time[1]) || received < time[1] ? received : time[1];
      detections.add(
          new Detection(
              (long) frame,
              object,
              new LineObservation(camera, x, y, Math.atan(slope), row.number(8), row.number(9))));
    }
  }
}
