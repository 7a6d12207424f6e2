package haltere.ui.viewer.picture;

import haltere.core.overlay.OverlayCanvas;

/**
 * A mouse tool on the picture: sets a point, draws a region, measures. Positions are in sensor
 * coordinates: x to the right, y up, (0, 0) the centre of the bottom left pixel.
 */
public interface ViewTool {
  /** One line of instructions, while the tool is selected. */
  String hint();

  /** The mouse button went down. */
  default void pressed(double x, double y) {}

  /** The mouse moved with the button down. */
  default void dragged(double x, double y) {}

  /** The mouse button was released. */
  default void released(double x, double y) {}

  /** Takes the last click back; false if there is none that can be. */
  default boolean takeBack() {
    return false;
  }

  /** The tool was put aside. */
  default void dismiss() {}

  /** Draws its present state. */
  default void draw(OverlayCanvas canvas) {}
}
