package haltere.ui.viewer.picture;

import haltere.core.overlay.OverlayCanvas;

/**
 * What the mouse does on the picture of the events instead of moving it: sets a point, draws a
 * region, measures. Places are in sensor coordinates: x to the right, y up, (0, 0) the centre of
 * the bottom left pixel.
 */
public interface ViewTool {
  /** One line that says what to do, while the tool is in hand. */
  String hint();

  /** The mouse button went down. */
  default void pressed(double x, double y) {}

  /** The mouse moved with the button down. */
  default void dragged(double x, double y) {}

  /** The mouse button came up. */
  default void released(double x, double y) {}

  /** The tool was put aside. */
  default void putAside() {}

  /** Draws what it has set so far. */
  default void draw(OverlayCanvas canvas) {}
}
