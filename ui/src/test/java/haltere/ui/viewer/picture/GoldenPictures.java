package haltere.ui.viewer.picture;

import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;

/**
 * Compares pictures with those that a person has looked at. A pixel is as it should be if one like
 * it is within two pixels, so that marks may lie somewhat elsewhere, but neither be missing nor be
 * somewhere else.
 *
 * <p>With {@code -Dhaltere.golden=FOLDER} the pictures are written there instead, to be looked at
 * and put into the resources.
 */
final class GoldenPictures {
  private static final int REACH = 2;
  private static final int LIKE = 60;
  private static final double MAX_UNLIKE = 0.004;

  private GoldenPictures() {}

  /** Checks a picture, or writes it. */
  static void check(String name, BufferedImage image) throws IOException {
    String folder = System.getProperty("haltere.golden", "");
    if (!folder.isEmpty()) {
      Files.createDirectories(Path.of(folder));
      ImageIO.write(image, "png", Path.of(folder, name + ".png").toFile());
      return;
    }
    try (InputStream stream = GoldenPictures.class.getResourceAsStream("golden/" + name + ".png")) {
      assertNotNull(stream, "there is no golden picture of " + name);
      BufferedImage golden = ImageIO.read(stream);
      assertTrue(
          golden.getWidth() == image.getWidth() && golden.getHeight() == image.getHeight(),
          name + " has another size");
      double unlike = Math.max(unlike(golden, image), unlike(image, golden));
      assertTrue(
          unlike <= MAX_UNLIKE,
          name + ": " + Math.round(1e4 * unlike) / 100.0 + " % of the pixels are not as they were");
    }
  }

  /** Share of the pixels of one picture that have none like them near their place in the other. */
  static double unlike(BufferedImage image, BufferedImage other) {
    int unlike = 0;
    for (int y = 0; y < image.getHeight(); y++) {
      for (int x = 0; x < image.getWidth(); x++) {
        if (!isNear(image.getRGB(x, y), other, x, y)) {
          unlike++;
        }
      }
    }
    return (double) unlike / (image.getWidth() * image.getHeight());
  }

  private static boolean isNear(int rgb, BufferedImage other, int x, int y) {
    if (isLike(rgb, other.getRGB(x, y))) {
      return true;
    }
    for (int row = Math.max(0, y - REACH);
        row <= Math.min(other.getHeight() - 1, y + REACH);
        row++) {
      for (int column = Math.max(0, x - REACH);
          column <= Math.min(other.getWidth() - 1, x + REACH);
          column++) {
        if (isLike(rgb, other.getRGB(column, row))) {
          return true;
        }
      }
    }
    return false;
  }

  private static boolean isLike(int a, int b) {
    return Math.abs((a >> 16 & 0xFF) - (b >> 16 & 0xFF)) <= LIKE
        && Math.abs((a >> 8 & 0xFF) - (b >> 8 & 0xFF)) <= LIKE
        && Math.abs((a & 0xFF) - (b & 0xFF)) <= LIKE;
  }
}
