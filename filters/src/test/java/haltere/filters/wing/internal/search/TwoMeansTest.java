package haltere.filters.wing.internal.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TwoMeansTest {
  private static final int POINTS = 400;
  private final double[] x = new double[POINTS];
  private final double[] y = new double[POINTS];

  /** Two clouds on either side of the middle, along a direction. */
  private void clouds(double direction, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    for (int i = 0; i < POINTS; i++) {
      double sign = i % 2 == 0 ? 1 : -1;
      x[i] = 64 + sign * 25 * Math.cos(direction) + 6 * random.nextGaussian();
      y[i] = 64 + sign * 25 * Math.sin(direction) + 6 * random.nextGaussian();
    }
  }

  @Test
  void bothClustersAreFoundInAllDirections() {
    for (int step = 0; step < 16; step++) {
      double direction = Math.PI * step / 16;
      clouds(direction, step);
      TwoMeans means = new TwoMeans();
      assertTrue(means.divide(x, y, POINTS, 128, 128));
      double found = Math.atan2(means.secondY - means.firstY, means.secondX - means.firstX);
      assertEquals(0, Math.sin(found - direction), 0.05, "direction " + direction);
      assertEquals(50, Math.hypot(means.secondX - means.firstX, means.secondY - means.firstY), 2);
    }
  }

  @Test
  void pointsInOneCornerGiveFiniteMeans() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < POINTS; i++) {
      x[i] = 120 + random.nextInt(3);
      y[i] = 120 + random.nextInt(3);
    }
    TwoMeans means = new TwoMeans();
    assertTrue(means.divide(x, y, POINTS, 128, 128));
    for (double mean : new double[] {means.firstX, means.firstY, means.secondX, means.secondY}) {
      assertTrue(mean >= 120 && mean <= 122, "a mean of the points: " + mean);
    }
  }

  @Test
  void identicalPointsYieldNoClasses() {
    java.util.Arrays.fill(x, 7);
    java.util.Arrays.fill(y, 9);
    assertFalse(new TwoMeans().divide(x, y, POINTS, 128, 128));
    assertFalse(new TwoMeans().divide(x, y, 0, 128, 128));
  }
}
