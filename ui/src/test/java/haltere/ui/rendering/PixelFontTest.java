package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class PixelFontTest {
  private static final String UNKNOWN = "\u2603";

  private static List<Boolean> drawn(String text) {
    boolean[] dots = new boolean[64 * 32];
    PixelFont.LETTERS.draw(text, 2, 24, (column, row, share) -> dots[row * 64 + column] = true);
    return IntStream.range(0, dots.length).mapToObj(i -> dots[i]).toList();
  }

  @Test
  void allThatOverlaysWriteHasItsShape() {
    for (String letter : "20 m: \u21913 \u21931, 54 \u00b1 2 km/h, 200 Hz, 90\u00b0".split("")) {
      assertFalse(drawn(UNKNOWN).equals(drawn(letter)), "no shape for " + letter);
    }
  }

  @Test
  void theArrowsAreOneAnotherUpsideDown() {
    List<Boolean> up = drawn("\u2191");
    List<Boolean> down = drawn("\u2193");
    for (int row = 0; row < PixelFont.HEIGHT; row++) {
      int upper = (24 - PixelFont.HEIGHT + row) * 64;
      int lower = (24 - 1 - row) * 64;
      assertEquals(up.subList(upper, upper + 64), down.subList(lower, lower + 64));
    }
  }
}
