package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PixelFontTest {
  private static final String UNKNOWN = "\u2603";

  private static List<Integer> drawn(String text) {
    BufferedImage image = new BufferedImage(64, 16, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    graphics.setColor(Color.WHITE);
    PixelFont.draw(graphics, text, 2, 12, 1);
    graphics.dispose();
    return IntStream.of(image.getRGB(0, 0, 64, 16, null, 0, 64)).boxed().toList();
  }

  @Test
  void allThatOverlaysWriteHasItsShape() {
    for (String letter : "20 m: \u21913 \u21931, 54 \u00b1 2 km/h, 200 Hz, 90\u00b0".split("")) {
      assertFalse(drawn(UNKNOWN).equals(drawn(letter)), "no shape for " + letter);
    }
  }

  @Test
  void theArrowsAreOneAnotherUpsideDown() {
    List<Integer> up = drawn("\u2191");
    List<Integer> down = drawn("\u2193");
    for (int row = 0; row < PixelFont.HEIGHT; row++) {
      int upper = (12 - PixelFont.HEIGHT + row) * 64;
      int lower = (12 - 1 - row) * 64;
      assertEquals(up.subList(upper, upper + 64), down.subList(lower, lower + 64));
    }
  }
}
