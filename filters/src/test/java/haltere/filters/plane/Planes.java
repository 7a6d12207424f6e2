package haltere.filters.plane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

/** Contract of the mappings of a plane. */
final class Planes {
  private Planes() {}

  static void assertWayBackIsInverse(PlaneMapping mapping, double xPx, double yPx) {
    double x = mapping.planeX(xPx, yPx);
    double y = mapping.planeY(xPx, yPx);
    assertTrue(mapping.isSeen(x, y), x + ", " + y);
    assertEquals(xPx, mapping.pixelX(x, y), 1e-8);
    assertEquals(yPx, mapping.pixelY(x, y), 1e-8);
  }

  static void assertJacobianIsDerivative(PlaneMapping mapping, double xPx, double yPx) {
    double h = 1e-4;
    PlaneJacobian jacobian = mapping.jacobian(xPx, yPx);
    near(mapping.planeX(xPx + h, yPx) - mapping.planeX(xPx - h, yPx), 2 * h * jacobian.xu());
    near(mapping.planeX(xPx, yPx + h) - mapping.planeX(xPx, yPx - h), 2 * h * jacobian.xv());
    near(mapping.planeY(xPx + h, yPx) - mapping.planeY(xPx - h, yPx), 2 * h * jacobian.yu());
    near(mapping.planeY(xPx, yPx + h) - mapping.planeY(xPx, yPx - h), 2 * h * jacobian.yv());
    PlaneJacobian inverse = jacobian.inverse();
    assertEquals(2, inverse.x(jacobian.x(2, -3), jacobian.y(2, -3)), 1e-9);
    assertEquals(-3, inverse.y(jacobian.x(2, -3), jacobian.y(2, -3)), 1e-9);
  }

  private static void near(double expected, double actual) {
    assertEquals(expected, actual, 2e-10 + 1e-6 * Math.abs(expected));
  }
}
