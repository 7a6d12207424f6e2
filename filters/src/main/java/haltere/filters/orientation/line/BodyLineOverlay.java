package haltere.filters.orientation.line;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.Overlay;
import haltere.core.overlay.OverlayCanvas;

/** Draws the body's outline as an ellipse, its line, and its position predicted by 0.1 s. */
final class BodyLineOverlay implements Overlay<BodyLine> {
  private static final double VELOCITY_S = 0.1;

  @Override
  public void draw(BodyLine line, OverlayCanvas canvas) {
    drawAt(line, line.timeUs(), canvas);
  }

  /** {@inheritDoc} The body moves on with its velocity. */
  @Override
  public void drawAt(BodyLine line, long timeUs, OverlayCanvas canvas) {
    double aheadS = Overlay.aheadS(line.timeUs(), timeUs);
    double x = line.xPx() + aheadS * line.vxPxS();
    double y = line.yPx() + aheadS * line.vyPxS();
    double length = line.halfLengthPx();
    double cos = length * Math.cos(line.angleRad());
    double sin = length * Math.sin(line.angleRad());
    canvas.ellipse(x, y, length, line.halfWidthPx(), line.angleRad(), MarkStyle.of(Role.OBJECT));
    canvas.line(
        x - 1.5 * cos, y - 1.5 * sin, x + 1.5 * cos, y + 1.5 * sin, MarkStyle.of(Role.ESTIMATE));
    canvas.line(
        x,
        y,
        x + VELOCITY_S * line.vxPxS(),
        y + VELOCITY_S * line.vyPxS(),
        MarkStyle.of(Role.VELOCITY));
  }
}
