package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PicturesTest {
  private static final MarkStyle OBJECT = MarkStyle.of(Role.OBJECT, 0);
  private static final int MARK = MarkColours.argb(OBJECT, true);
  private final SensorGeometry geometry = new SensorGeometry(128, 96);
  private final EventFrame frame = new EventFrame(geometry);
  private final FramePainter painter = new FramePainter(ColourMap.DARK, 1000);

  @Test
  void smallSensorIsEnlargedByAnInteger() {
    assertEquals(6, Pictures.defaultScale(geometry));
    assertEquals(1, Pictures.defaultScale(new SensorGeometry(1280, 720)));
    frame.packet(EventFrameTest.one(5, 127, 0, true));
    BufferedImage image = Pictures.draw(frame, painter, 6, canvas -> {});
    assertEquals(768, image.getWidth());
    assertEquals(576, image.getHeight());
    for (int y = 0; y < 576; y++) {
      for (int x = 0; x < 768; x++) {
        boolean event = x >= 762 && y >= 570;
        assertEquals(
            event ? ColourMap.DARK.on() : ColourMap.DARK.background(),
            image.getRGB(x, y),
            x + ", " + y);
      }
    }
  }

  @Test
  void marksAreDrawnOverTheirPixels() {
    BufferedImage image =
        Pictures.draw(
            frame,
            painter,
            6,
            canvas -> {
              canvas.circle(64, 48, 10, OBJECT);
              canvas.line(10, 10, 20, 10, OBJECT);
              canvas.polyline(new double[] {30, 30}, new double[] {70, 80}, 2, OBJECT);
              canvas.ellipse(100, 48, 10, 3, Math.PI / 2, OBJECT);
              canvas.rectangle(5, 60, 8, 6, OBJECT);
            });
    // the right end of the circle, whose centre is the centre of pixel (64, 48)
    assertMarked(image, 74.5, 48.5);
    assertMarked(image, 54.5, 48.5);
    assertMarked(image, 64.5, 58.5);
    assertMarked(image, 15, 10.5);
    assertMarked(image, 30.5, 75);
    // the long axis of the ellipse stands upright
    assertMarked(image, 100.5, 58.5);
    assertMarked(image, 103.5, 48.5);
    assertMarked(image, 5.5, 63);
    assertMarked(image, 9, 66.5);
    assertEquals(
        ColourMap.DARK.background(), image.getRGB(64 * 6, 576 - 48 * 6), "inside of the circle");
  }

  @Test
  void labelsAreDrawnWithinThePicture() {
    MarkStyle label = MarkStyle.of(Role.LABEL, 1);
    BufferedImage image =
        Pictures.draw(frame, painter, 6, canvas -> canvas.text(20, 20, "#12: 3.5 µs ♞", label));
    int marked = 0;
    for (int y = 576 - 21 * 6 - 14; y < 576 - 20 * 6; y++) {
      for (int x = 20 * 6; x < 20 * 6 + FontLetters.OF_PICTURES.width("#12: 3.5 µs ♞") + 4; x++) {
        marked += image.getRGB(x, y) != ColourMap.DARK.background() ? 1 : 0;
      }
    }
    assertTrue(marked > 4 * 60, marked + " pixels");
  }

  @Test
  void pictureFileAppearsCompleteWithoutOtherFiles(@TempDir Path folder) throws IOException {
    frame.packet(EventFrameTest.one(5, 3, 4, false));
    BufferedImage image = Pictures.draw(frame, painter, 2, canvas -> {});
    Path file = folder.resolve("picture.png");
    Files.writeString(file, "old");
    Pictures.write(file, image);
    BufferedImage read = ImageIO.read(new ByteArrayInputStream(Files.readAllBytes(file)));
    assertEquals(ColourMap.DARK.off(), read.getRGB(6, 192 - 9));
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(List.of(file), files.toList());
    }
  }

  /** The mark covers one of the four pixels of the picture that meet at a place. */
  private static void assertMarked(BufferedImage image, double x, double y) {
    int column = (int) Math.round(x * 6);
    int row = (int) Math.round(576 - y * 6);
    int best = Integer.MAX_VALUE;
    for (int dx = -1; dx <= 0; dx++) {
      for (int dy = -1; dy <= 0; dy++) {
        int colour = image.getRGB(column + dx, row + dy);
        int distance = 0;
        for (int shift = 0; shift <= 16; shift += 8) {
          distance += Math.abs((colour >> shift & 0xFF) - (MARK >> shift & 0xFF));
        }
        best = Math.min(best, distance);
      }
    }
    assertTrue(best < 60, "mark at " + x + ", " + y + " differs by " + best);
  }
}
