package haltere.filters.orientation;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;

/**
 * Draws the body's outline as an ellipse, its line, and where it would be in a tenth of a second.
 */
final class BodyLineOverlay implements Overlay<BodyLine> {
  private static final double VELOCITY_S = 0.1;

  @Override
  public void draw(BodyLine line, OverlayCanvas canvas) {
    double length = line.halfLengthPx();
    double cos = length * Math.cos(line.angleRad());
    double sin = length * Math.sin(line.angleRad());
    canvas.ellipse(
        line.xPx(),
        line.yPx(),
        length,
        line.halfWidthPx(),
        line.angleRad(),
        MarkStyle.of(Role.OBJECT));
    canvas.line(
        line.xPx() - 1.5 * cos,
        line.yPx() - 1.5 * sin,
        line.xPx() + 1.5 * cos,
        line.yPx() + 1.5 * sin,
        MarkStyle.of(Role.ESTIMATE));
    canvas.line(
        line.xPx(),
        line.yPx(),
        line.xPx() + VELOCITY_S * line.vxPxS(),
        line.yPx() + VELOCITY_S * line.vyPxS(),
        MarkStyle.of(Role.VELOCITY));
  }
}
