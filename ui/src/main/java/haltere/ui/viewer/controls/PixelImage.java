package haltere.ui.viewer.controls;

import java.nio.IntBuffer;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/**
 * An image whose pixels a program paints.
 *
 * <p>Thread rule: JavaFX thread only.
 */
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

  /** The pixels, premultiplied ARGB; empty before {@link #allocate}. */
  public int[] pixels() {
    return buffer == null ? new int[0] : buffer.getBuffer().array();
  }

  /** Shows the pixels as they are now. */
  public void repaint() {
    buffer.updateBuffer(all -> null);
  }
}
