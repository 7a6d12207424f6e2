package haltere.ui.viewer.picture;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import haltere.core.overlay.OverlayCanvas;
import javafx.scene.input.KeyCode;

/**
 * Operates a tool by keys: arrow keys move a cross over the picture, by ten pixels with Shift;
 * Enter presses the tool at the cross and releases it.
 */
final class KeyPointer {
  private static final int STRIDE = 10;
  private static final double GAP_PX = 2;
  private static final double ARM_PX = 6;

  private boolean shown;
  private boolean down;
  private int x;
  private int y;

  /** Column of the cross. */
  int x() {
    return x;
  }

  /** Row of the cross, upwards. */
  int y() {
    return y;
  }

  boolean isShown() {
    return shown;
  }

  /** Shows the cross at a position if it is not shown. */
  void begin(int startX, int startY) {
    if (!shown) {
      shown = true;
      x = startX;
      y = startY;
    }
  }

  /** Hides the cross: the mouse is used, or the tool was dismissed. */
  void end() {
    shown = false;
    down = false;
  }

  /** Whether a key has a function here. */
  static boolean takes(KeyCode code) {
    return code.isArrowKey() || code == KeyCode.ENTER;
  }

  /** Applies a key that is {@link #takes accepted}; far moves the cross by more than one pixel. */
  void press(KeyCode code, boolean far, ViewTool tool, SensorGeometry sensor) {
    int step = far ? STRIDE : 1;
    switch (code) {
      case LEFT, KP_LEFT -> x = Math.max(0, x - step);
      case RIGHT, KP_RIGHT -> x = Math.min(sensor.width() - 1, x + step);
      case UP, KP_UP -> y = Math.min(sensor.height() - 1, y + step);
      case DOWN, KP_DOWN -> y = Math.max(0, y - step);
      default -> {
        down = !down;
        if (down) {
          tool.pressed(x, y);
        } else {
          tool.released(x, y);
        }
      }
    }
    if (down && code != KeyCode.ENTER) {
      tool.dragged(x, y);
    }
  }

  void draw(OverlayCanvas canvas) {
    if (shown) {
      MarkStyle style = MarkStyle.of(Role.LABEL);
      canvas.line(x - ARM_PX, y, x - GAP_PX, y, style);
      canvas.line(x + GAP_PX, y, x + ARM_PX, y, style);
      canvas.line(x, y - ARM_PX, x, y - GAP_PX, style);
      canvas.line(x, y + GAP_PX, x, y + ARM_PX, style);
    }
  }
}
