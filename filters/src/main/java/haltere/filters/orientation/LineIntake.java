package haltere.filters.orientation;

import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import haltere.filters.orientation.internal.axis.LineMeasurement;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.ObjLongConsumer;

/**
 * Selects the usable observations of a time, converts them to measurements, and keeps the last one
 * of each camera.
 */
final class LineIntake {
  private final List<CameraModel> cameras;
  private final OrientationSettings.ObservationGate gate;
  private final LineNoise noise;
  private final double maxIntervalUs;
  private final LineObservation[] latest;
  private final long[] latestUs;
  private final List<LineObservation> usable = new ArrayList<>();
  private final List<LineObservation> views = new ArrayList<>();
  private boolean hasSeveral;

  LineIntake(List<CameraModel> cameras, OrientationSettings settings, LineNoise noise) {
    this.cameras = cameras;
    this.noise = noise;
    gate = settings.gate();
    maxIntervalUs = settings.position().maxViewIntervalS() * 1e6;
    latest = new LineObservation[cameras.size()];
    latestUs = new long[cameras.size()];
  }

  /** Accepts observations of a time, except repeated ones and those of unusable cameras. */
  void accept(long timeUs, List<LineObservation> seen, ObjLongConsumer<OrientationCount> counter) {
    usable.clear();
    for (LineObservation observation : seen) {
      int camera = observation.camera();
      if (camera >= cameras.size()) {
        throw new IllegalArgumentException(
            "there is no camera " + camera + ", there are " + cameras.size());
      }
      if (cameras.get(camera).problem().isPresent()) {
        counter.accept(OrientationCount.UNUSABLE_CAMERA, 1);
      } else if (latestUs[camera] == timeUs && usable.contains(latest[camera])) {
        counter.accept(OrientationCount.DUPLICATE, 1);
      } else {
        usable.add(observation);
        latest[camera] = observation;
        latestUs[camera] = timeUs;
      }
    }
    hasSeveral |= usable.size() > 1;
  }

  /** Usable observations of the last time; valid until the next one. */
  List<LineObservation> usable() {
    return usable;
  }

  /**
   * The last recent observation of each camera if cameras expose at different times, or the usable
   * ones of the last time if they expose together.
   */
  List<LineObservation> recent(long timeUs) {
    if (hasSeveral) {
      return usable;
    }
    views.clear();
    for (int i = 0; i < latest.length; i++) {
      if (latest[i] != null && timeUs - latestUs[i] <= maxIntervalUs) {
        views.add(latest[i]);
      }
    }
    return views;
  }

  /**
   * Converts the lines of a body at a position in metres; counts the other observations; returns
   * the number of measurements.
   */
  int measure(
      List<LineObservation> seen,
      double[] positionM,
      LineMeasurement[] into,
      ObjLongConsumer<OrientationCount> counter) {
    int count = 0;
    for (LineObservation each : seen) {
      Optional<OrientationCount> problem = measure(each, positionM, into[count]);
      problem.ifPresent(reason -> counter.accept(reason, 1));
      count += problem.isEmpty() ? 1 : 0;
    }
    return count;
  }

  private Optional<OrientationCount> measure(
      LineObservation seen, double[] positionM, LineMeasurement into) {
    CameraModel camera = cameras.get(seen.camera());
    double[] line = seen.line();
    OrientationCount problem = null;
    if (!Double.isFinite(seen.angleRad())) {
      problem = OrientationCount.WITHOUT_ANGLE;
    } else if (seen.areaPx() <= gate.minAreaPx() && gate.minAreaPx() > 0) {
      problem = OrientationCount.SMALL;
    } else if (gate.minEccentricity() > 0 && seen.axisRatio() <= gate.minEccentricity()) {
      problem = OrientationCount.ROUND;
    } else if (!seen.hasPosition() && !camera.project(positionM, line)) {
      problem = OrientationCount.WITHOUT_LINE;
    } else if (!camera.undistort(line)) {
      problem = OrientationCount.UNUSABLE_CAMERA;
    } else if (!camera.lineNormals(positionM, into.n)) {
      problem = OrientationCount.WITHOUT_LINE;
    } else {
      into.camera = seen.camera();
      into.setAngle(line[2]);
      into.varianceRad2 = noise.variances[into.camera];
    }
    return Optional.ofNullable(problem);
  }
}
