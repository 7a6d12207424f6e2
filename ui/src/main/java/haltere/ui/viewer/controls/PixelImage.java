package haltere.ui.viewer.controls;

import java.nio.IntBuffer;
import javafx.scene.Node;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.stage.Window;

/** An image whose pixels a program paints. */
public final class PixelImage extends ImageView {
  private PixelBuffer<IntBuffer> buffer;

  /** An image without pixels, which no layout moves. */
  public PixelImage() {
    setManaged(false);
  }

  /**
   * Has pixels of a number, row by row from the top; those that are there stay if they are as many.
   */
  public void allocate(int width, int height) {
    if (buffer == null || buffer.getWidth() != width || buffer.getHeight() != height) {
      IntBuffer pixels = IntBuffer.allocate(width * height);
      buffer = new PixelBuffer<>(width, height, pixels, PixelFormat.getIntArgbPreInstance());
      setImage(new WritableImage(buffer));
    }
  }

  /** Has so many pixels of the screen and is as large as they are, at pixels per unit. */
  public void fit(int columns, int rows, double density) {
    allocate(columns, rows);
    setFitWidth(columns / density);
    setFitHeight(rows / density);
  }

  /** Pixels of the screen per unit where a node is shown; 1 while it is not. */
  public static double density(Node node) {
    Window window = node.getScene() == null ? null : node.getScene().getWindow();
    return window == null ? 1 : window.getRenderScaleX();
  }

  /** The pixels, premultiplied ARGB; empty before {@link #allocate}. */
  public int[] pixels() {
    return buffer == null ? new int[0] : buffer.getBuffer().array();
  }

  /** Shows the pixels as they are now. */
  public void repaint() {
    buffer.updateBuffer(all -> null);
  }
}
