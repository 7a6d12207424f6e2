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
 * Position and axis of a body over time, with the observations of each camera.
 *
 * @param cameras those that can be used
 * @param moments in order of time
 */
public record BodyFlight(List<CameraModel> cameras, List<Moment> moments) {
  /**
   * One time.
   *
   * @param estimate position and axis from observations up to then
   * @param lines observed and expected line of each camera
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
    file.read(new ObservationCollector(seen));
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

  /** Collects the observations of the first body. */
  private static final class ObservationCollector implements ObservationFile.Listener {
    private final Map<Long, List<LineObservation>> seen;
    private String first;

    ObservationCollector(Map<Long, List<LineObservation>> seen) {
      this.seen = seen;
    }

    @Override
    public void observed(long timeUs, String object, LineObservation line) {
      first = first == null ? object : first;
      if (first.equals(object)) {
        seen.computeIfAbsent(timeUs, time -> new ArrayList<>()).add(line);
      }
    }

    @Override
    public void skipped(String where, String why) {
      // the command line reports each; here the rest is shown
    }
  }
}
