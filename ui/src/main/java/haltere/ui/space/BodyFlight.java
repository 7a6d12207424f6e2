package haltere.ui.space;

import haltere.filters.orientation.BodyOrientationEstimator;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.OrientationSettings;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.camera.ObservationFile;
import haltere.filters.orientation.camera.ObservationListener;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

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
   * @param estimate place and axis from what was seen up to then
   * @param residualsDeg for each camera, the angle from the expected to the observed line, degrees;
   *     NaN where it saw none
   * @param used for each camera, whether its line was used
   */
  public record Moment(
      OrientationEstimate estimate, List<Double> residualsDeg, List<Boolean> used) {
    /** Copies. */
    public Moment {
      residualsDeg = List.copyOf(residualsDeg);
      used = List.copyOf(used);
    }
  }

  /** Copies. */
  public BodyFlight {
    cameras = List.copyOf(cameras);
    moments = List.copyOf(moments);
  }

  /**
   * Follows the body that was seen first.
   *
   * @param observations a table, a {@code .braidz} file or HDF5 of Flydra
   * @param calibration the cameras; may be empty for a {@code .braidz} file
   * @return its flight; without a moment if no orientation could be found
   * @throws IOException if a file cannot be read or is another; the message names it
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
          .ifPresent(
              now -> {
                List<Double> residuals = new ArrayList<>();
                List<Boolean> used = new ArrayList<>();
                for (int i = 0; i < cameras.size(); i++) {
                  residuals.add(Math.toDegrees(body.residualRad(i)));
                  used.add(body.used(i));
                }
                moments.add(new Moment(now, residuals, used));
              });
    }
    return new BodyFlight(cameras, moments);
  }

  /** Keeps what was seen of the first body. */
  private static final class Collector implements ObservationListener {
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
