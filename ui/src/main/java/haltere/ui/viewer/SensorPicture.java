package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.ui.rendering.PictureScaler;
import java.nio.IntBuffer;
import java.util.Arrays;
import javafx.geometry.Rectangle2D;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;

/**
 * The pixels of the sensor on the screen. With a graphics card the card enlarges them; without one
 * they are enlarged here, because JavaFX's own software takes several milliseconds for it.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class SensorPicture {
  private final ImageView image = new ImageView();
  private final boolean scaleHere;
  private final PictureScaler scaler = new PictureScaler();
  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private int[] newest = new int[1];
  private int background;
  private PixelBuffer<IntBuffer> pixels;

  /**
   * An empty picture.
   *
   * @param scaleHere whether there is no graphics card to do it
   */
  SensorPicture(boolean scaleHere) {
    this.scaleHere = scaleHere;
    image.setManaged(false);
  }

  ImageView node() {
    return image;
  }

  /** Prepares for another sensor. */
  void setGeometry(SensorGeometry newGeometry, int newBackground) {
    geometry = newGeometry;
    background = newBackground;
    newest = new int[geometry.pixels()];
    Arrays.fill(newest, background);
    pixels = null;
  }

  void setBackground(int newBackground) {
    background = newBackground;
  }

  /**
   * Puts the picture where it belongs.
   *
   * @param left of the sensor's left edge in the view
   * @param top of the sensor's top edge in the view
   * @param scale units of the view per pixel of the sensor
   * @param width of the view
   * @param height of the view
   * @param density pixels of the screen per unit of the view
   */
  void place(double left, double top, double scale, double width, double height, double density) {
    // only what is in sight, so that a large zoom costs no more than a small one
    double fromX = Math.max(0, -left / scale);
    double fromY = Math.max(0, -top / scale);
    double toX = Math.min(geometry.width(), (width - left) / scale);
    double toY = Math.min(geometry.height(), (height - top) / scale);
    if (toX <= fromX || toY <= fromY) {
      image.setVisible(false);
      return;
    }
    image.setVisible(true);
    image.setX(left + fromX * scale);
    image.setY(top + fromY * scale);
    if (scaleHere) {
      int columns = Math.max(1, (int) Math.ceil((toX - fromX) * scale * density - 1e-6));
      int rows = Math.max(1, (int) Math.ceil((toY - fromY) * scale * density - 1e-6));
      allocate(columns, rows);
      scaler.configure(
          geometry.width(), geometry.height(), fromX, fromY, scale * density, columns, rows);
      image.setSmooth(false);
      image.setFitWidth(columns / density);
      image.setFitHeight(rows / density);
    } else {
      allocate(geometry.width(), geometry.height());
      image.setSmooth(scale * density < 1);
      image.setViewport(new Rectangle2D(fromX, fromY, toX - fromX, toY - fromY));
      image.setFitWidth((toX - fromX) * scale);
      image.setFitHeight((toY - fromY) * scale);
    }
    draw();
  }

  /** Shows pixels; they are copied. */
  void show(int[] argb) {
    System.arraycopy(argb, 0, newest, 0, newest.length);
    if (pixels != null) {
      draw();
    }
  }

  private void allocate(int width, int height) {
    if (pixels == null || pixels.getWidth() != width || pixels.getHeight() != height) {
      pixels =
          new PixelBuffer<>(
              width,
              height,
              IntBuffer.allocate(width * height),
              PixelFormat.getIntArgbPreInstance());
      image.setImage(new WritableImage(pixels));
    }
  }

  private void draw() {
    pixels.updateBuffer(
        buffer -> {
          int[] shown = buffer.getBuffer().array();
          if (scaleHere) {
            scaler.scale(newest, background, shown);
          } else {
            System.arraycopy(newest, 0, shown, 0, newest.length);
          }
          return null;
        });
  }
}
