package haltere.filters.orientation;

import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import java.util.Optional;

/**
 * Makes measurements of observations: takes the lens out, leaves out what is small, round or not to
 * be seen, and says how sure each angle is.
 */
final class LineGate {
  private final OrientationSettings.ObservationGate gate;
  private final LineNoise noise;
  private final double[] line = new double[3];

  LineGate(OrientationSettings.ObservationGate gate, LineNoise noise) {
    this.gate = gate;
    this.noise = noise;
  }

  /**
   * Makes a measurement.
   *
   * @param camera whose observation it is
   * @param place where the body is, metres
   * @param into gets the measurement
   * @return why there is none, or empty
   */
  Optional<OrientationCount> prepare(
      LineObservation observation, CameraModel camera, double[] place, LineMeasurement into) {
    if (!Double.isFinite(observation.angleRad())) {
      return Optional.of(OrientationCount.WITHOUT_ANGLE);
    }
    if (observation.areaPx() <= gate.minAreaPx() && gate.minAreaPx() > 0) {
      return Optional.of(OrientationCount.SMALL);
    }
    double ratio = observation.axisRatio();
    if (gate.minEccentricity() > 0 && ratio <= gate.minEccentricity()) {
      return Optional.of(OrientationCount.ROUND);
    }
    line[0] = observation.xPx();
    line[1] = observation.yPx();
    line[2] = observation.angleRad();
    if (!observation.hasPlace() && !camera.project(place, line)) {
      return Optional.of(OrientationCount.WITHOUT_LINE);
    }
    if (!camera.straighten(line)) {
      return Optional.of(OrientationCount.UNUSABLE_CAMERA);
    }
    if (!camera.lineNormals(place, into.n)) {
      return Optional.of(OrientationCount.WITHOUT_LINE);
    }
    into.camera = observation.camera();
    into.setAngle(line[2]);
    noise.putInto(into, ratio);
    return Optional.empty();
  }
}
