package haltere.ui.viewer.picture;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import java.util.Locale;

/**
 * A length and an angle that were measured, from one place of the sensor to another, in pixels.
 *
 * @param fromX column where it begins, 0 at the middle of the first one
 * @param fromY row where it begins, upwards
 * @param toX column where it ends
 * @param toY row where it ends
 */
public record MeasuredLine(double fromX, double fromY, double toX, double toY) {
  private static final double TICK = 2;

  /** What was measured, in words. */
  public String words() {
    double right = toX - fromX;
    double up = toY - fromY;
    return String.format(
        Locale.ROOT,
        "%.1f px   %.1f\u00b0   x %.1f   y %.1f",
        Math.hypot(right, up),
        Math.toDegrees(Math.atan2(up, right)),
        right,
        up);
  }

  void draw(OverlayCanvas canvas) {
    MarkStyle line = MarkStyle.of(Role.REGION);
    double length = Math.max(1e-9, Math.hypot(toX - fromX, toY - fromY));
    double acrossX = -(toY - fromY) / length * TICK;
    double acrossY = (toX - fromX) / length * TICK;
    canvas.line(fromX, fromY, toX, toY, line);
    canvas.line(fromX - acrossX, fromY - acrossY, fromX + acrossX, fromY + acrossY, line);
    canvas.line(toX - acrossX, toY - acrossY, toX + acrossX, toY + acrossY, line);
    canvas.text(toX + 2, toY + 2, words(), MarkStyle.of(Role.LABEL));
  }
}
