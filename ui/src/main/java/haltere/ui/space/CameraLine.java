package haltere.ui.space;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.orientation.BodyOrientationEstimator;
import haltere.filters.orientation.OrientationEstimate;
import haltere.filters.orientation.camera.CameraModel;
import haltere.filters.orientation.camera.LineObservation;
import java.util.Locale;
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

  private static final MarkStyle ACCEPTED = MarkStyle.of(Role.MEASUREMENT, 1);
  private static final MarkStyle GATED = MarkStyle.of(Role.WARNING);
  private static final MarkStyle AXIS = MarkStyle.of(Role.ESTIMATE);

  /** Start of the observed line, half lengths of the body. */
  private static final double FROM = 1.2;

  /** Length of the observed line beyond each end of the body: half lengths, and pixels at least. */
  private static final double BEYOND = 2;

  private static final double MIN_BEYOND_PX = 24;

  private static final int DASHES = 3;

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
  double halfLengthPx() {
    double length =
        observed.map(seen -> Math.sqrt(seen.areaPx() / Math.PI * seen.axisRatio())).orElse(0.0);
    return length > 0 && Double.isFinite(length) ? length : UNKNOWN_HALF_LENGTH_PX;
  }

  /**
   * Draws it over the picture of the camera: the estimated axis with its head, and the observed
   * line beyond its ends: solid and green if accepted, broken and red if gated.
   */
  public void draw(OverlayCanvas canvas) {
    observed.filter(LineObservation::hasPosition).ifPresent(seen -> drawObserved(seen, canvas));
    if (Double.isFinite(xPx + yPx + headingRad)) {
      double dx = halfLengthPx() * Math.cos(headingRad);
      double dy = halfLengthPx() * Math.sin(headingRad);
      canvas.line(xPx - dx, yPx - dy, xPx + dx, yPx + dy, AXIS);
      canvas.circle(xPx + dx, yPx + dy, 0.2 * halfLengthPx(), AXIS);
    }
  }

  private void drawObserved(LineObservation seen, OverlayCanvas canvas) {
    double half = halfLengthPx();
    String text = camera;
    MarkStyle style = MarkStyle.of(Role.LABEL);
    if (Double.isFinite(seen.angleRad())) {
      style = isAccepted ? ACCEPTED : GATED;
      double dx = Math.cos(seen.angleRad());
      double dy = Math.sin(seen.angleRad());
      double beyond = Math.max(MIN_BEYOND_PX, BEYOND * half);
      int pieces = isAccepted ? 1 : DASHES;
      for (int piece = 0; piece < pieces; piece++) {
        double from = FROM * half + beyond * piece / pieces;
        double to = from + (pieces == 1 ? beyond : 0.5 * beyond / pieces);
        for (int side = -1; side <= 1; side += 2) {
          canvas.line(
              seen.xPx() + side * from * dx,
              seen.yPx() + side * from * dy,
              seen.xPx() + side * to * dx,
              seen.yPx() + side * to * dy,
              style);
        }
      }
      if (Double.isFinite(residualDeg)) {
        text =
            String.format(
                Locale.ROOT, "%s %+.1f\u00b0%s", camera, residualDeg, isAccepted ? "" : " gated");
      }
    }
    canvas.text(seen.xPx() + half, seen.yPx() + MIN_BEYOND_PX, text, style);
  }
}
