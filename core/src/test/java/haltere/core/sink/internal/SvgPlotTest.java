package haltere.core.sink.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class SvgPlotTest {
  @Test
  void singlePointOfALineIsDrawnAsADot() {
    assertEquals(1, marks("<circle", 3));
    assertEquals(0, marks("<polyline", 3));
  }

  @Test
  void nonFinitePointsAreSkipped() {
    assertEquals(1, marks("<circle", 3, Double.NaN));
    assertEquals(1, marks("<polyline", 3, Double.NaN, 4));
    assertEquals(0, marks("<circle", Double.NaN));
  }

  @Test
  void epochTimesAreRelativeToARoundTimeInTheLabel() {
    String svg = plot(1_605_116_853.9, 1_605_116_855.4);
    assertTrue(svg.contains(">4.0<"), svg);
    assertTrue(svg.contains(">5.4<"), svg);
    assertTrue(svg.contains(">time (s) after 1605116850<"), svg);
  }

  @Test
  void namesOfLinesStandAboveThePlot() {
    double[] x = {0, 1};
    String svg =
        SvgPlot.around(x, x).line("a", "red", x, x).line("b & c", "blue", x, x).draw("t", "x", "y");
    assertTrue(svg.contains("fill=\"red\">a</tspan>"), svg);
    assertTrue(svg.contains("fill=\"blue\">b &amp; c</tspan>"), svg);
    assertTrue(svg.contains("viewBox=\"0 -16 640 316\""), svg);
  }

  @Test
  void shortNumbersAreUnchanged() {
    String svg = plot(100, 101.5);
    assertTrue(svg.contains(">100.2<"), svg);
    assertTrue(svg.contains(">time (s)<"), svg);
  }

  private static String plot(double fromX, double toX) {
    return new SvgPlot(fromX, toX, 0, 1).draw("title", "time (s)", "y");
  }

  private static int marks(String kind, double... y) {
    double[] x = new double[y.length];
    for (int i = 0; i < x.length; i++) {
      x[i] = i;
    }
    String svg = SvgPlot.around(x, y).line("a", "red", x, y).draw("title", "x", "y");
    return svg.split(kind, -1).length - 1;
  }
}
