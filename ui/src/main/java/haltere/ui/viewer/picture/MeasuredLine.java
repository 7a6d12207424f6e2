package haltere.ui.viewer.picture;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.command.terminal.Quantities;

/**
 * A measured length and angle between two positions on the sensor, in pixels.
 *
 * @param fromX column of its start, 0 at the centre of the first one
 * @param fromY row of its start, upwards
 * @param toX column where it ends
 * @param toY row where it ends
 */
public record MeasuredLine(double fromX, double fromY, double toX, double toY) {
  private static final double TICK = 2;

  /** The measurement as text. */
  public String label() {
    double right = toX - fromX;
    double up = toY - fromY;
    return Quantities.text(
        "%.1f px   %.1f\u00b0   x %.1f   y %.1f",
        Math.hypot(right, up), Math.toDegrees(Math.atan2(up, right)), right, up);
  }

  void draw(OverlayCanvas canvas) {
    MarkStyle line = MarkStyle.of(Role.REGION);
    double length = Math.max(1e-9, Math.hypot(toX - fromX, toY - fromY));
    double acrossX = -(toY - fromY) / length * TICK;
    double acrossY = (toX - fromX) / length * TICK;
    canvas.line(fromX, fromY, toX, toY, line);
    canvas.line(fromX - acrossX, fromY - acrossY, fromX + acrossX, fromY + acrossY, line);
    canvas.line(toX - acrossX, toY - acrossY, toX + acrossX, toY + acrossY, line);
    canvas.text(toX + 2, toY + 2, label(), MarkStyle.of(Role.LABEL));
  }
}
