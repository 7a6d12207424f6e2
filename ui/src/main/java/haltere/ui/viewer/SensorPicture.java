package haltere.ui.viewer;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.OverlayCanvas;
import haltere.ui.overlay.FontLetters;
import haltere.ui.overlay.JavaFxOverlayCanvas;
import haltere.ui.rendering.PictureScaler;
import haltere.ui.rendering.PixelOverlayCanvas;
import java.nio.IntBuffer;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;
import javafx.geometry.Rectangle2D;
import javafx.scene.Node;
import javafx.scene.canvas.Canvas;
import javafx.scene.image.ImageView;
import javafx.scene.image.PixelBuffer;
import javafx.scene.image.PixelFormat;
import javafx.scene.image.WritableImage;
import javafx.scene.text.Font;

/**
 * The pixels of the sensor on the screen, and the marks over them. With a graphics card the card
 * enlarges the pixels and a canvas takes the marks; without one all of it is drawn here, because
 * JavaFX's own software takes several milliseconds for it.
 *
 * <p>Thread rule: JavaFX thread only.
 */
final class SensorPicture {
  private final ImageView image = new ImageView();
  private final boolean scaleHere;
  private final PictureScaler scaler = new PictureScaler();
  private final Canvas canvas = new Canvas();
  private final JavaFxOverlayCanvas canvasMarks =
      new JavaFxOverlayCanvas(canvas.getGraphicsContext2D());
  private PixelOverlayCanvas pixelMarks;
  private double density;
  private SensorGeometry geometry = new SensorGeometry(1, 1);
  private int[] newest = new int[1];
  private PixelBuffer<IntBuffer> pixels;

  /**
   * An empty picture.
   *
   * @param scaleHere whether there is no graphics card to do it
   */
  SensorPicture(boolean scaleHere) {
    this.scaleHere = scaleHere;
    image.setManaged(false);
    canvas.setManaged(false);
    canvas.setMouseTransparent(true);
    canvas.setVisible(false);
  }

  /** The pixels, and what lies over them. */
  List<Node> nodes() {
    return scaleHere ? List.of(image) : List.of(image, canvas);
  }

  /** Prepares for another sensor. */
  void setGeometry(SensorGeometry newGeometry, int background) {
    geometry = newGeometry;
    newest = new int[geometry.pixels()];
    Arrays.fill(newest, background & 0xFFFFFF);
    pixels = null;
  }

  /**
   * Puts the picture where it belongs.
   *
   * @param left of the sensor's left edge in the view
   * @param top of the sensor's top edge in the view
   * @param scale units of the view per pixel of the sensor
   * @param width of the view
   * @param height of the view
   * @param newDensity pixels of the screen per unit of the view
   */
  void place(
      double left, double top, double scale, double width, double height, double newDensity) {
    // only what is in sight, so that a large zoom costs no more than a small one
    double fromX = Math.max(0, -left / scale);
    double fromY = Math.max(0, -top / scale);
    double toX = Math.min(geometry.width(), (width - left) / scale);
    double toY = Math.min(geometry.height(), (height - top) / scale);
    image.setVisible(toX > fromX && toY > fromY);
    if (!image.isVisible()) {
      return;
    }
    double imageX = left + fromX * scale;
    double imageY = top + fromY * scale;
    double bottom = top + geometry.height() * scale;
    image.setX(imageX);
    image.setY(imageY);
    if (scaleHere && density != newDensity) {
      density = newDensity;
      pixelMarks =
          new PixelOverlayCanvas(
              new FontLetters(Font.font(JavaFxOverlayCanvas.FONT_SIZE), density));
    }
    if (scaleHere) {
      int columns = Math.max(1, (int) Math.ceil((toX - fromX) * scale * density - 1e-6));
      int rows = Math.max(1, (int) Math.ceil((toY - fromY) * scale * density - 1e-6));
      allocate(columns, rows);
      scaler.configure(
          geometry.width(), geometry.height(), fromX, fromY, scale * density, columns, rows);
      image.setSmooth(false);
      image.setFitWidth(columns / density);
      image.setFitHeight(rows / density);
      pixelMarks.setView(scale, left - imageX, bottom - imageY, density);
    } else {
      allocate(geometry.width(), geometry.height());
      image.setSmooth(scale * newDensity < 1);
      image.setViewport(new Rectangle2D(fromX, fromY, toX - fromX, toY - fromY));
      image.setFitWidth((toX - fromX) * scale);
      image.setFitHeight((toY - fromY) * scale);
      // a canvas costs by its size
      canvas.relocate(imageX, imageY);
      canvas.setWidth((toX - fromX) * scale);
      canvas.setHeight((toY - fromY) * scale);
      canvasMarks.setView(scale, left - imageX, bottom - imageY);
    }
  }

  /** The pixels to be drawn next, which must stay as they are until there are others. */
  void setPixels(int[] ranked) {
    newest = ranked;
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

  /**
   * Draws all anew.
   *
   * @param marks draws what lies over the pixels
   * @param dark whether the pixels are dark
   */
  void draw(Consumer<OverlayCanvas> marks, boolean dark) {
    if (pixels == null || !image.isVisible()) {
      return;
    }
    int[] shown = pixels.getBuffer().array();
    if (scaleHere) {
      scaler.scale(newest, shown);
      pixelMarks.setTarget(shown, pixels.getWidth(), pixels.getHeight());
      pixelMarks.setDark(dark);
      marks.accept(pixelMarks);
    } else {
      PictureScaler.makeOpaque(newest, shown);
      drawOnCanvas(marks, dark);
    }
    pixels.updateBuffer(all -> null);
  }

  private void drawOnCanvas(Consumer<OverlayCanvas> marks, boolean dark) {
    if (canvas.isVisible()) {
      canvas.getGraphicsContext2D().clearRect(0, 0, canvas.getWidth(), canvas.getHeight());
    }
    canvasMarks.setDark(dark);
    long before = canvasMarks.marks();
    marks.accept(canvasMarks);
    canvas.setVisible(canvasMarks.marks() != before);
  }
}
