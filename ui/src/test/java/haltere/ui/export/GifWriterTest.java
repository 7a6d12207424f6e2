package haltere.ui.export;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Random;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Colours of animated pictures. */
class GifWriterTest {
  private static final int SIDE = 64;

  @TempDir Path folder;

  @Test
  void pictureOf256ColoursIsWrittenExactly() throws IOException {
    int[] colours = new Random(1).ints(256, 0, 1 << 24).toArray();
    int[] pixels = new int[SIDE * SIDE];
    Arrays.setAll(pixels, i -> colours[i % colours.length]);
    assertArrayEquals(pixels, written(pixels));
  }

  @Test
  void pictureOfOneColourIsWrittenExactly() throws IOException {
    int[] pixels = new int[SIDE * SIDE];
    Arrays.fill(pixels, 0x336699);
    assertArrayEquals(pixels, written(pixels));
  }

  @Test
  void shadesThatDifferByOneAreMergedWhereAPictureHasTooManyColours() throws IOException {
    int[] pixels = new int[SIDE * SIDE];
    Arrays.setAll(pixels, i -> i < 400 ? 0x400000 + i % 200 : i % 100 * 0x020202);
    int[] read = written(pixels);
    for (int i = 0; i < pixels.length; i++) {
      for (int shift = 0; shift <= 16; shift += 8) {
        int difference = (read[i] >> shift & 0xff) - (pixels[i] >> shift & 0xff);
        assertTrue(Math.abs(difference) <= 1, Integer.toHexString(pixels[i]));
      }
    }
    assertArrayEquals(
        Arrays.copyOfRange(pixels, 400, pixels.length),
        Arrays.copyOfRange(read, 400, pixels.length));
    assertEquals(200, Arrays.stream(read).distinct().count());
  }

  private int[] written(int... pixels) throws IOException {
    BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
    image.setRGB(0, 0, SIDE, SIDE, pixels, 0, SIDE);
    Path file = folder.resolve("film.gif");
    try (GifWriter writer = new GifWriter(file, 25)) {
      writer.add(image);
      writer.finish();
    }
    int[] read = ImageIO.read(file.toFile()).getRGB(0, 0, SIDE, SIDE, null, 0, SIDE);
    return Arrays.stream(read).map(pixel -> pixel & 0xffffff).toArray();
  }
}
