package haltere.ui.space;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;
import haltere.filters.orientation.camera.LineObservation;
import java.util.Locale;

/**
 * Draws a body's line over the picture of a camera: the estimated axis with its head, and the
 * observed line beyond its ends: solid and green if accepted, broken and red if gated.
 */
public final class CameraLineOverlay implements Overlay<CameraLine> {
  private static final MarkStyle ACCEPTED = MarkStyle.of(Role.MEASUREMENT, 1);
  private static final MarkStyle GATED = MarkStyle.of(Role.WARNING);
  private static final MarkStyle AXIS = MarkStyle.of(Role.ESTIMATE);

  /** Start of the observed line, half lengths of the body. */
  private static final double FROM = 1.2;

  /** Length of the observed line beyond each end of the body: half lengths, and pixels at least. */
  private static final double BEYOND = 2;

  private static final double MIN_BEYOND_PX = 24;

  private static final int DASHES = 3;

  @Override
  public void draw(CameraLine line, OverlayCanvas canvas) {
    line.observed()
        .filter(LineObservation::hasPosition)
        .ifPresent(seen -> drawObserved(line, seen, canvas));
    if (Double.isFinite(line.xPx() + line.yPx() + line.headingRad())) {
      double dx = line.halfLengthPx() * Math.cos(line.headingRad());
      double dy = line.halfLengthPx() * Math.sin(line.headingRad());
      double x = line.xPx();
      double y = line.yPx();
      canvas.line(x - dx, y - dy, x + dx, y + dy, AXIS);
      canvas.circle(x + dx, y + dy, 0.2 * line.halfLengthPx(), AXIS);
    }
  }

  private static void drawObserved(CameraLine line, LineObservation seen, OverlayCanvas canvas) {
    double half = line.halfLengthPx();
    String text = line.camera();
    MarkStyle style = MarkStyle.of(Role.LABEL);
    if (Double.isFinite(seen.angleRad())) {
      style = line.isAccepted() ? ACCEPTED : GATED;
      double dx = Math.cos(seen.angleRad());
      double dy = Math.sin(seen.angleRad());
      double beyond = Math.max(MIN_BEYOND_PX, BEYOND * half);
      int pieces = line.isAccepted() ? 1 : DASHES;
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
      if (Double.isFinite(line.residualDeg())) {
        text =
            String.format(
                Locale.ROOT,
                "%s %+.1f\u00b0%s",
                line.camera(),
                line.residualDeg(),
                line.isAccepted() ? "" : " gated");
      }
    }
    canvas.text(seen.xPx() + half, seen.yPx() + MIN_BEYOND_PX, text, style);
  }
}
