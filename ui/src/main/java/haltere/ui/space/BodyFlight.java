package haltere.ui.space;

import haltere.filters.orientation.BodyOrientationEstimator;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.ObservationFile;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * Where a body was and which way it pointed, time by time, with what each camera saw otherwise.
 *
 * @param cameras those that can be used
 * @param moments in order of time
 */
public record BodyFlight(List<CameraModel> cameras, List<Moment> moments) {
  /**
   * One time.
   *
   * @param estimate position and axis from what was seen up to then
   * @param lines for each camera, what it observed and what was expected
   */
  public record Moment(OrientationEstimate estimate, List<CameraLine> lines) {
    /** Copies. */
    public Moment {
      lines = List.copyOf(lines);
    }

    static Moment of(
        OrientationEstimate now, BodyOrientationEstimator body, List<CameraModel> cameras) {
      return new Moment(
          now,
          IntStream.range(0, cameras.size())
              .mapToObj(i -> CameraLine.of(i, cameras.get(i), now, body))
              .toList());
    }
  }

  /** Copies. */
  public BodyFlight {
    cameras = List.copyOf(cameras);
    moments = List.copyOf(moments);
  }

  /**
   * Follows the body that was seen first in a table, a {@code .braidz} file (which needs no
   * calibration) or HDF5 of Flydra; without a moment if no orientation could be found.
   */
  public static BodyFlight load(Path observations, Optional<Path> calibration) throws IOException {
    Map<Long, List<LineObservation>> seen = new LinkedHashMap<>();
    ObservationFile file = ObservationFile.open(observations, calibration);
    file.read(new Collector(seen));
    return follow(file.cameras().cameras(), seen);
  }

  private static BodyFlight follow(
      List<CameraModel> cameras, Map<Long, List<LineObservation>> seen) {
    BodyOrientationEstimator body =
        new BodyOrientationEstimator(cameras, OrientationSettings.defaults());
    List<Moment> moments = new ArrayList<>();
    for (Map.Entry<Long, List<LineObservation>> each : seen.entrySet()) {
      body.update(each.getKey(), each.getValue())
          .ifPresent(now -> moments.add(Moment.of(now, body, cameras)));
    }
    return new BodyFlight(cameras, moments);
  }

  /** Keeps what was seen of the first body. */
  private static final class Collector implements ObservationFile.Listener {
    private final Map<Long, List<LineObservation>> seen;
    private String first;

    Collector(Map<Long, List<LineObservation>> seen) {
      this.seen = seen;
    }

    @Override
    public void seen(long timeUs, String object, LineObservation line) {
      first = first == null ? object : first;
      if (first.equals(object)) {
        seen.computeIfAbsent(timeUs, time -> new ArrayList<>()).add(line);
      }
    }

    @Override
    public void bad(String where, String why) {
      // the command line tells of each; here the rest is shown
    }
  }
}
