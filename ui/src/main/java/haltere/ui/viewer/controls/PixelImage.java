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

  /** Allocates pixels, row by row from the top; present ones are kept if the number is equal. */
  public void allocate(int width, int height) {
    if (buffer == null || buffer.getWidth() != width || buffer.getHeight() != height) {
      IntBuffer pixels = IntBuffer.allocate(width * height);
      buffer = new PixelBuffer<>(width, height, pixels, PixelFormat.getIntArgbPreInstance());
      setImage(new WritableImage(buffer));
    }
  }

  /** Sets its size in pixels of the screen, at a number of pixels per unit. */
  public void fit(int columns, int rows, double density) {
    allocate(columns, rows);
    setFitWidth(columns / density);
    setFitHeight(rows / density);
  }

  /** Pixels of the screen per unit at a node; 1 while it is not shown. */
  public static double density(Node node) {
    Window window = node.getScene() == null ? null : node.getScene().getWindow();
    return window == null ? 1 : window.getRenderScaleX();
  }

  /** The pixels, premultiplied ARGB; empty before {@link #allocate}. */
  public int[] pixels() {
    return buffer == null ? new int[0] : buffer.getBuffer().array();
  }

  /** Shows the present pixels. */
  public void repaint() {
    buffer.updateBuffer(all -> null);
  }
}
