package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import org.junit.jupiter.api.Test;

/** A line that goes a quarter of a pixel above the middle of its row. */
class LinePainterTest {
  private static final int ORANGE = 0xFFFF8040;
  private final int[] pixels = new int[9 * 3];

  private void draw() {
    LinePainter painter = new LinePainter();
    painter.setTarget(pixels, 9, 3);
    painter.line(0, 1.25, 9, 1.25, 1, ORANGE, false);
  }

  private int row(int row) {
    return pixels[row * 9 + 4];
  }

  @Test
  void lineOnTransparentPixelsIsAsOpaqueAsItsCoverage() {
    draw();
    // premultiplied: a quarter, and three quarters, of 0xFF, 0xFF, 0x80, 0x40
    assertEquals(0x3F3F2010, row(0));
    assertEquals(0xBFBF6030, row(1));
    assertEquals(0, row(2));
  }

  @Test
  void opaquePixelsStayOpaque() {
    Arrays.fill(pixels, 0xFF000000);
    draw();
    assertEquals(0xFF3F2010, row(0));
    assertEquals(0xFFBF6030, row(1));
    assertEquals(0xFF000000, row(2));
  }
}
