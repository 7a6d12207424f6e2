package haltere.ui.rendering;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.overlay.MarkStyle;
import haltere.core.overlay.MarkStyle.Role;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PixelOverlayCanvasTest {
  private static final int WIDTH = 200;
  private static final int HEIGHT = 150;
  private static final int WHITE = 0xFFFFFFFF;

  private final int[] pixels = new int[WIDTH * HEIGHT];
  private final LinePainter painter = new LinePainter();

  /** Letters of solid blocks, each 6 wide and 8 high. */
  private static final class Blocks implements Letters {
    @Override
    public double width(String line) {
      return 6.0 * line.length();
    }

    @Override
    public double ascent() {
      return 8;
    }

    @Override
    public double descent() {
      return 2;
    }

    @Override
    public void draw(String line, int left, int base, Dots dots) {
      for (int column = 0; column < width(line); column++) {
        for (int row = 0; row < 8; row++) {
          dots.dot(left + column, base - 8 + row, 1);
        }
      }
    }
  }

  @BeforeEach
  void makeBlack() {
    Arrays.fill(pixels, 0xFF000000);
    painter.setTarget(pixels, WIDTH, HEIGHT);
  }

  /** How much is covered, in pixels. */
  private double covered() {
    return Arrays.stream(pixels).map(argb -> argb & 0xFF).sum() / 255.0;
  }

  @ParameterizedTest
  @CsvSource({"20,20,120,20", "20,20,20,110", "30,20,130,110", "150,30,40,60.7", "10.3,9.8,60,100"})
  void lineCoversLengthTimesThickness(double x1, double y1, double x2, double y2) {
    painter.line(x1, y1, x2, y2, 2, WHITE, false);
    double expected = 2 * Math.hypot(x2 - x1, y2 - y1);
    assertEquals(expected, covered(), 0.02 * expected);
  }

  @ParameterizedTest
  @ValueSource(doubles = {3, 10.4, 47, 70})
  void ringCoversCircumferenceTimesThickness(double radius) {
    painter.ring(99.6, 75.2, radius, 2, WHITE);
    double expected = 2 * Math.PI * radius * 2;
    assertEquals(expected, covered(), 0.03 * expected);
    assertEquals(0xFF000000, pixels[75 * WIDTH + 99], "its middle is left alone");
  }

  @Test
  void translucentShapesDoNotOverlapThemselves() {
    painter.ring(100, 75, 40, 3, 0x80FFFFFF);
    assertTrue(Arrays.stream(pixels).allMatch(argb -> (argb & 0xFF) <= 0x81));
    makeBlack();
    painter.line(20, 20, 100, 75, 3, 0x80FFFFFF, true);
    assertTrue(Arrays.stream(pixels).allMatch(argb -> (argb & 0xFF) <= 0x81));
  }

  @Test
  void coloursAreBlendedPerChannel() {
    Arrays.fill(pixels, 0xFF204060);
    painter.dot(3, 4, 0xFFE08010, 0.5);
    int mixed = pixels[4 * WIDTH + 3];
    assertEquals(0x80, mixed >> 16 & 0xFF, 1);
    assertEquals(0x60, mixed >> 8 & 0xFF, 1);
    assertEquals(0x38, mixed & 0xFF, 1);
    assertEquals(0xFF, mixed >>> 24);
  }

  @Test
  void shapesOutsideThePictureAreClipped() {
    PixelOverlayCanvas canvas = new PixelOverlayCanvas(new Blocks());
    canvas.setTarget(pixels, WIDTH, HEIGHT);
    canvas.setView(2, -30, 190, 1.5);
    SplittableRandom random = new SplittableRandom(2);
    MarkStyle style = MarkStyle.of(Role.OBJECT);
    for (int i = 0; i < 2000; i++) {
      double x = random.nextDouble(-500, 500);
      double y = random.nextDouble(-500, 500);
      double size = random.nextDouble(0, 400);
      canvas.circle(x, y, size, style);
      canvas.line(x, y, y, x + size, style);
      canvas.rectangle(x, y, size, size / 2, style);
      canvas.ellipse(x, y, size, size / 3, size, style);
      canvas.polyline(new double[] {x, y, size}, new double[] {y, size, x}, 3, style);
      canvas.text(x, y, "words", style);
    }
    for (double bad : new double[] {Double.NaN, Double.POSITIVE_INFINITY, 1e300}) {
      canvas.circle(bad, 3, 4, style);
      canvas.circle(3, 3, bad, style);
      canvas.line(0, bad, 10, 10, style);
      canvas.ellipse(bad, 0, 3, bad, 1, style);
    }
    assertTrue(Arrays.stream(pixels).allMatch(argb -> argb >>> 24 == 0xFF));
  }

  @ParameterizedTest
  @CsvSource({"0,0", "99,74", "-50,40", "200,-20", "50,300"})
  void textIsNotClippedAtTheEdges(double x, double y) {
    PixelOverlayCanvas canvas = new PixelOverlayCanvas(new Blocks());
    canvas.setTarget(pixels, WIDTH, HEIGHT);
    canvas.setView(2, 0, HEIGHT, 1);
    canvas.text(x, y, "words", MarkStyle.of(Role.LABEL));
    int ink = MarkColours.argb(MarkStyle.of(Role.LABEL), true);
    assertEquals(5 * 6 * 8, Arrays.stream(pixels).filter(argb -> argb == ink).count());
  }
}
