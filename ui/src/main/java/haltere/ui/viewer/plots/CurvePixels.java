package haltere.ui.viewer.plots;

import haltere.ui.rendering.LinePainter;
import java.nio.IntBuffer;
import java.util.Arrays;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/**
 * Pixels that the curves of a lane are drawn into, transparent but for the curves. JavaFX's own
 * shapes take several times as long for a curve that goes up and down a hundred times, and keep the
 * whole window waiting.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class CurvePixels {
  private final ImageView view = new ImageView();
  private final LinePainter painter = new LinePainter();
  private PixelBuffer<IntBuffer> pixels;
  private double density;

  CurvePixels() {
    view.setManaged(false);
    view.setMouseTransparent(true);
  }

  /** What shows them. */
  ImageView view() {
    return view;
  }

  /**
   * Makes all pixels of the curves transparent; the density is pixels of the screen per unit of the
   * lane.
   */
  void begin(double left, double width, double height, double newDensity) {
    density = newDensity;
    int columns = Math.max(1, (int) Math.ceil(width * density));
    int rows = Math.max(1, (int) Math.ceil(height * density));
    if (pixels == null || pixels.getWidth() != columns || pixels.getHeight() != rows) {
      pixels =
          new PixelBuffer<>(
              columns,
              rows,
              IntBuffer.allocate(columns * rows),
              PixelFormat.getIntArgbPreInstance());
      view.setImage(new WritableImage(pixels));
      painter.setTarget(pixels.getBuffer().array(), columns, rows);
    } else {
      Arrays.fill(pixels.getBuffer().array(), 0);
    }
    view.setX(left);
    view.setFitWidth(columns / density);
    view.setFitHeight(rows / density);
  }

  /** A straight line; units of the lane from the top left corner of the curves. */
  void line(double x1, double y1, double x2, double y2, double thickness, int argb) {
    painter.line(
        x1 * density,
        y1 * density,
        x2 * density,
        y2 * density,
        thickness * density,
        argb,
        x1 == x2 && y1 == y2);
  }

  /** Shows what was drawn. */
  void end() {
    pixels.updateBuffer(all -> null);
  }
}
