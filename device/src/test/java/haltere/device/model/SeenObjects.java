package haltere.device.model;

import java.util.Random;

/**
 * Where a camera of 128 x 128 pixels that gives an event each microsecond sees them: eight objects
 * on a circle that turns once a second, and noise all over the sensor, a ninth of the events.
 *
 * <p>Thread rule: immutable.
 */
final class SeenObjects {
  private static final int SIZE = 128;
  private static final int OBJECTS = 8;
  private static final double RADIUS_PX = 45;
  private static final double SPREAD_PX = 2.5;
  private static final int PERIOD_US = 1_000_000;

  private final short[] pixels = new short[PERIOD_US];

  SeenObjects() {
    Random random = new Random(7);
    for (int us = 0; us < PERIOD_US; us++) {
      int object = random.nextInt(OBJECTS + 1);
      double angle = 2 * Math.PI * ((double) us / PERIOD_US + (double) object / OBJECTS);
      boolean noise = object == OBJECTS;
      int x = noise ? random.nextInt(SIZE) : around(RADIUS_PX * Math.cos(angle), random);
      int y = noise ? random.nextInt(SIZE) : around(RADIUS_PX * Math.sin(angle), random);
      pixels[us] = (short) (y * SIZE + x);
    }
  }

  private static int around(double fromCentre, Random random) {
    double position = SIZE / 2.0 + fromCentre + SPREAD_PX * random.nextGaussian();
    return (int) Math.max(0, Math.min(SIZE - 1, Math.round(position)));
  }

  int x(long timeUs) {
    return pixels[(int) (timeUs % PERIOD_US)] % SIZE;
  }

  int y(long timeUs) {
    return pixels[(int) (timeUs % PERIOD_US)] / SIZE;
  }
}
