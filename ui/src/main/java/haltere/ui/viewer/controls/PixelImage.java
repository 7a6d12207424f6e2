package haltere.ui.viewer.controls;

import java.nio.IntBuffer;
import javafx.scene.Node;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.stage.Window;

/** An image with pixels painted by the program. */
public final class PixelImage extends ImageView {
  private PixelBuffer<IntBuffer> buffer;

  /** An image without pixels, which no layout moves. */
  public PixelImage() {
    setManaged(false);
  }

  /**
   * Sets its size in pixels of the screen, at a number of pixels per unit; present pixels are kept
   * if their numbers are equal.
   */
  public void fit(int columns, int rows, double density) {
    if (buffer == null || buffer.getWidth() != columns || buffer.getHeight() != rows) {
      IntBuffer pixels = IntBuffer.allocate(columns * rows);
      buffer = new PixelBuffer<>(columns, rows, pixels, PixelFormat.getIntArgbPreInstance());
      setImage(new WritableImage(buffer));
    }
    setFitWidth(columns / density);
    setFitHeight(rows / density);
  }

  /** Pixels of the screen per unit at a node; 1 while it is not shown. */
  public static double density(Node node) {
    Window window = node.getScene() == null ? null : node.getScene().getWindow();
    return window == null ? 1 : window.getRenderScaleX();
  }

  /** The pixels, premultiplied ARGB, row by row from the top; empty before {@link #fit}. */
  public int[] pixels() {
    return buffer == null ? new int[0] : buffer.getBuffer().array();
  }

  /** Shows the present pixels. */
  public void repaint() {
    buffer.updateBuffer(all -> null);
  }
}
