package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class AnglesTest {
  @Test
  void angleIsWrappedIntoTheHalfOpenCircle() {
    assertEquals(Math.PI, Angles.wrapPi(Math.PI));
    assertEquals(Math.PI, Angles.wrapPi(-Math.PI));
    assertEquals(0, Angles.wrapPi(0));
    assertEquals(-0.5, Angles.wrapPi(2 * Math.PI - 0.5), 1e-15);
    assertEquals(0.5, Angles.wrapPi(-2 * Math.PI + 0.5), 1e-15);
    Draws draws = new Draws(1);
    for (int i = 0; i < 10_000; i++) {
      double angle = draws.uniform(-1e4, 1e4);
      double wrapped = Angles.wrapPi(angle);
      assertTrue(wrapped > -Math.PI && wrapped <= Math.PI);
      assertEquals(Math.sin(angle), Math.sin(wrapped), 1e-11);
      assertEquals(Math.cos(angle), Math.cos(wrapped), 1e-11);
    }
  }

  @Test
  void directionsAreWrappedIntoZeroToTwoPi() {
    assertEquals(0, Angles.wrapTwoPi(2 * Math.PI));
    assertEquals(2 * Math.PI - 0.5, Angles.wrapTwoPi(-0.5), 1e-15);
    assertEquals(0.5, Angles.wrapTwoPi(4 * Math.PI + 0.5), 1e-14);
    // so little below zero that the sum is the whole circle
    assertEquals(0, Angles.wrapTwoPi(-1e-20));
  }

  @Test
  void lineAngleIsWrappedIntoHalfACircle() {
    assertEquals(Math.PI / 2, Angles.wrapHalfPi(-Math.PI / 2));
    assertEquals(-0.1, Angles.wrapHalfPi(Math.PI - 0.1), 1e-15);
    assertEquals(0.1, Angles.wrapHalfPi(5 * Math.PI + 0.1), 1e-14);
  }

  @Test
  void nanRemainsNan() {
    assertTrue(Double.isNaN(Angles.wrapPi(Double.NaN)));
    assertTrue(Double.isNaN(Angles.wrapPi(Double.POSITIVE_INFINITY)));
    assertTrue(Double.isNaN(Angles.wrapTwoPi(Double.NaN)));
    assertTrue(Double.isNaN(Angles.wrapTwoPi(Double.NEGATIVE_INFINITY)));
  }
}
