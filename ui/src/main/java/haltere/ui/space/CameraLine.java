package haltere.ui.space;

import haltere.filters.orientation.BodyOrientationEstimator;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import java.util.Optional;

/**
 * The line of a body in the picture of one camera at one time: observed, and projected from the
 * estimated axis.
 *
 * @param camera name of the camera
 * @param observed the observation; empty without one
 * @param residualDeg angle from the expected to the observed line, degrees; NaN if there was none
 * @param isAccepted whether the observed line was used for the axis
 * @param xPx column of the estimated position; NaN if the camera does not see it
 * @param yPx row of the estimated position
 * @param headingRad direction of the estimated axis in the picture, tail to head
 */
public record CameraLine(
    String camera,
    Optional<LineObservation> observed,
    double residualDeg,
    boolean isAccepted,
    double xPx,
    double yPx,
    double headingRad) {
  /** Half length of a line whose detection has no area, pixels. */
  private static final double UNKNOWN_HALF_LENGTH_PX = 12;

  static CameraLine of(
      int index, CameraModel camera, OrientationEstimate now, BodyOrientationEstimator body) {
    double[] position = {now.xM(), now.yM(), now.zM()};
    double[] pixel = {Double.NaN, Double.NaN};
    camera.project(position, pixel);
    return new CameraLine(
        camera.id(),
        body.observation(index),
        Math.toDegrees(body.residualRad(index)),
        body.used(index),
        pixel[0],
        pixel[1],
        camera.heading(position, new double[] {now.ux(), now.uy(), now.uz()}));
  }

  /** Half the length of the body in the picture, pixels. */
  public double halfLengthPx() {
    double length =
        observed.map(seen -> Math.sqrt(seen.areaPx() / Math.PI * seen.axisRatio())).orElse(0.0);
    return length > 0 && Double.isFinite(length) ? length : UNKNOWN_HALF_LENGTH_PX;
  }
}
