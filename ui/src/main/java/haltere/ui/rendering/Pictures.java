package haltere.ui.rendering;

import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.overlay.OverlayCanvas;
import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import javax.imageio.ImageIO;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Pictures of events with marks, as PNG files, without a display.
 *
 * <p>Thread rule: all methods may be called from any thread; what they are given is used by one
 * thread at a time.
 */
public final class Pictures {
  /** Length of a picture's longer side that small sensors are scaled up to, as nearly as may be. */
  public static final int DEFAULT_SIDE = 768;

  private Pictures() {}

  /**
   * The whole number by which a sensor is scaled up for a picture of usual size, at least 1: 6 for
   * 128x128.
   */
  public static int defaultScale(SensorGeometry geometry) {
    return Math.max(1, DEFAULT_SIDE / geometry.longerSide());
  }

  /**
   * Draws a picture.
   *
   * @param frame the events
   * @param painter how they look
   * @param scale pixels of the picture per pixel of the sensor, at least 1
   * @param marks draws over the picture
   * @return a picture without transparency
   */
  public static BufferedImage draw(
      EventFrame frame, FramePainter painter, int scale, Consumer<OverlayCanvas> marks) {
    int[] argb = new int[frame.geometry().pixels()];
    painter.paint(frame, argb);
    return draw(frame.geometry(), argb, painter.colours().dark(), scale, marks);
  }

  /**
   * Draws a picture that has been painted.
   *
   * @param geometry the sensor
   * @param argb one pixel for each of the sensor's, row by row from the top
   * @param dark whether marks should be light
   * @param scale pixels of the picture per pixel of the sensor, at least 1
   * @param marks draws over the picture
   * @return a picture without transparency
   */
  public static BufferedImage draw(
      SensorGeometry geometry, int[] argb, boolean dark, int scale, Consumer<OverlayCanvas> marks) {
    int width = geometry.width() * scale;
    BufferedImage image =
        new BufferedImage(width, geometry.height() * scale, BufferedImage.TYPE_INT_RGB);
    int[] pixels = pixels(image);
    for (int y = 0; y < image.getHeight(); y++) {
      int row = y / scale * geometry.width();
      for (int x = 0; x < width; x++) {
        pixels[y * width + x] = argb[row + x / scale];
      }
    }
    marks.accept(canvas(image, scale, dark));
    return image;
  }

  /** A canvas over a picture of the whole sensor, with its scale in pixels. */
  static OverlayCanvas canvas(BufferedImage image, double scale, boolean dark) {
    PixelOverlayCanvas canvas = new PixelOverlayCanvas(FontLetters.OF_PICTURES);
    canvas.setTarget(pixels(image), image.getWidth(), image.getHeight());
    canvas.setView(scale, 0, image.getHeight(), 1);
    canvas.setDark(dark);
    return canvas;
  }

  /** The pixels of a picture of the type INT_RGB or INT_ARGB, to be drawn into. */
  public static int[] pixels(BufferedImage image) {
    return ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
  }

  /** A picture as a PNG file in memory. */
  public static byte[] png(BufferedImage image) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    // own stream: ImageIO's creates a file in the temporary folder
    try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
      if (!ImageIO.write(image, "png", stream)) {
        throw new IllegalStateException("this Java runtime cannot write PNG");
      }
    } catch (IOException inMemory) {
      throw new UncheckedIOException(inMemory);
    }
    return bytes.toByteArray();
  }

  /** The reason why a name is not one of a picture. */
  public static Optional<String> problem(Path file) {
    boolean isPng = file.toString().toLowerCase(Locale.ROOT).endsWith(".png");
    return isPng ? Optional.empty() : Optional.of(file + ": a picture's name ends in .png");
  }

  /**
   * Writes a picture as a PNG file, which appears whole or not at all and replaces one that exists.
   */
  public static void write(Path file, BufferedImage image) throws IOException {
    Optional<String> problem = problem(file);
    if (problem.isPresent()) {
      throw new IOException(problem.get());
    }
    AtomicFile.write(file, png(image), true);
  }
}
