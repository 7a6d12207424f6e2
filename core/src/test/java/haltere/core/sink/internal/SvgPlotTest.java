package haltere.core.sink.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class SvgPlotTest {
  @Test
  void aLonePointOfALineIsADot() {
    assertEquals(1, marks("<circle", 3));
    assertEquals(0, marks("<polyline", 3));
  }

  @Test
  void pointsThatAreNoNumbersAreLeftOut() {
    assertEquals(1, marks("<circle", 3, Double.NaN));
    assertEquals(1, marks("<polyline", 3, Double.NaN, 4));
    assertEquals(0, marks("<circle", Double.NaN));
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
