package haltere.core.simulation.internal.road;

import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The upright box around the projected outline of a vehicle, unclipped.
 *
 * <p>Thread rule: one thread at a time.
 */
final class RoadView {
  double fromX;
  double toX;
  double fromY;
  double toY;

  /** Computes the box of a vehicle from the positions of its middle and its nearer end. */
  void see(RoadCamera camera, Vehicle vehicle, double x, double near) {
    fromX = Double.POSITIVE_INFINITY;
    toX = Double.NEGATIVE_INFINITY;
    fromY = Double.POSITIVE_INFINITY;
    toY = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < vehicle.parts.size(); i++) {
      PaintedBox part = vehicle.parts.get(i);
      for (int corner = 0; corner < 4; corner++) {
        double d = near + ((corner & 1) == 0 ? part.near : part.far);
        double z = (corner & 2) == 0 ? part.bottom : part.top;
        double row = camera.row(d, z);
        fromY = Math.min(fromY, row);
        toY = Math.max(toY, row);
        fromX = Math.min(fromX, camera.column(x + part.left, d, z));
        toX = Math.max(toX, camera.column(x + part.right, d, z));
      }
      if (near + part.near < 0 && near + part.far > 0) {
        // Straight below the camera a point is nearest, so the sides bulge.
        fromX = Math.min(fromX, camera.column(x + part.left, 0, part.top));
        toX = Math.max(toX, camera.column(x + part.right, 0, part.top));
      }
    }
  }

  boolean touches(SensorSettings sensor) {
    return toX > -0.5
        && fromX < sensor.widthPx() - 0.5
        && toY > -0.5
        && fromY < sensor.heightPx() - 0.5;
  }
}
