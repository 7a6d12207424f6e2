package haltere.ui.viewer;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import java.util.Locale;

/**
 * Measures lengths and angles: drag from one place to another.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class MeasuringTape implements ViewTool {
  private static final double TICK = 2;

  private boolean laid;
  private double fromX;
  private double fromY;
  private double toX;
  private double toY;

  @Override
  public String hint() {
    return "Drag over the picture to measure a length and an angle.";
  }

  @Override
  public void pressed(double x, double y) {
    laid = false;
    fromX = x;
    fromY = y;
  }

  @Override
  public void dragged(double x, double y) {
    laid = true;
    toX = x;
    toY = y;
  }

  @Override
  public void putAside() {
    laid = false;
  }

  /** What was measured, in words; empty if nothing. */
  String words() {
    if (!laid) {
      return "";
    }
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

  @Override
  public void draw(OverlayCanvas canvas) {
    if (!laid) {
      return;
    }
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
