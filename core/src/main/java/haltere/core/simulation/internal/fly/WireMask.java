package haltere.core.simulation.internal.fly;

import haltere.core.simulation.internal.sensor.SensorSettings;

/**
 * The pixels that a straight wire hides.
 *
 * <p>Thread rule: immutable.
 */
final class WireMask {
  private final boolean[] hidden;

  WireMask(WireSettings wire, SensorSettings sensor) {
    int width = sensor.widthPx();
    hidden = new boolean[width * sensor.heightPx()];
    double cos = StrictMath.cos(wire.angleRad());
    double sin = StrictMath.sin(wire.angleRad());
    for (int pixel = 0; pixel < hidden.length; pixel++) {
      double x = pixel % width - (width - 1) / 2.0;
      double y = pixel / width - (sensor.heightPx() - 1) / 2.0;
      double left = y * cos - x * sin;
      hidden[pixel] = Math.abs(left - wire.offsetPx()) < wire.widthPx() / 2;
    }
  }

  /** Whether a pixel sees the wire and nothing else. */
  boolean hides(int pixel) {
    return hidden[pixel];
  }
}
