package haltere.filters.orientation.line;

import haltere.core.sink.Column;
import haltere.filters.orientation.camera.LineObservation;

/**
 * Line of an elongated body in the picture of one camera at one time, from events before that time
 * only.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param xPx column of its middle
 * @param yPx row of its middle
 * @param angleRad angle of its long axis, counterclockwise from +x, modulo pi, in (−pi/2, pi/2]
 * @param areaPx area of its outline, an ellipse, square pixels
 * @param eccentricity long axis over short axis, at least 1
 * @param vxPxS velocity to the right, pixels a second
 * @param vyPxS velocity upwards, pixels a second
 * @param events events of the body since the last report
 */
public record BodyLine(
    @Column("t_us") long timeUs,
    @Column(decimals = 3) double xPx,
    @Column(decimals = 3) double yPx,
    @Column(decimals = 5) double angleRad,
    @Column(decimals = 2) double areaPx,
    @Column(decimals = 3) double eccentricity,
    @Column(decimals = 2) double vxPxS,
    @Column(decimals = 2) double vyPxS,
    int events) {
  /**
   * The observation for {@link haltere.filters.orientation.BodyOrientationEstimator}.
   *
   * @param camera index of the camera
   * @return the same without the time
   */
  public LineObservation observation(int camera) {
    return new LineObservation(camera, xPx, yPx, angleRad, areaPx, eccentricity);
  }

  double halfLengthPx() {
    return Math.sqrt(areaPx / Math.PI * eccentricity);
  }

  double halfWidthPx() {
    return Math.sqrt(areaPx / Math.PI / eccentricity);
  }
}
