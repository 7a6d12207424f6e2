package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class WingEventNoiseTest {
  private static final double FAR_SQUARE = 40 * 40;
  private static final double FULL = 1500;
  private final WingEventNoise noise = new WingEventNoise(4, 0);
  private final SplittableRandom random = new SplittableRandom(3);

  private boolean event(int edge, double y) {
    EventNoise worth = noise.of(edge);
    worth.variance(FAR_SQUARE, FULL);
    boolean taken = worth.judge(y, 0, FULL, FULL) > 0;
    noise.count(edge, y, taken);
    return taken;
  }

  @Test
  void onEventsOfSlowPixelsDoNotReduceTheWeightOfOffEvents() {
    for (int i = 0; i < 30_000; i++) {
      event(0, 0.04 * random.nextGaussian());
      event(1, 0.15 * random.nextGaussian());
    }
    assertEquals(0.04, Math.sqrt(noise.of(0).variance(FAR_SQUARE, FULL)), 0.006);
    assertEquals(0.15, Math.sqrt(noise.of(1).variance(FAR_SQUARE, FULL)), 0.03);
    assertEquals(1, noise.nis(), 0.1);
  }

  @Test
  void uniformOutliersAreNoExcess() {
    for (int i = 0; i < 20_000; i++) {
      event(i % 2, i % 5 < 2 ? random.nextDouble(-1.3, 1.3) : 0.02 * random.nextGaussian());
    }
    assertFalse(noise.isExcessRejection(0.3));
  }

  @Test
  void rejectedEventsOfADisplacedWingAreDetected() {
    for (int i = 0; i < 10_000; i++) {
      event(i % 2, 0.02 * random.nextGaussian());
    }
    int refused = 0;
    while (!noise.isExcessRejection(0.3) && refused < 1000) {
      refused += event(0, 0.35 + 0.02 * random.nextGaussian()) ? 0 : 1;
      event(1, 0.02 * random.nextGaussian());
    }
    assertTrue(refused < 100, "after " + refused);
    assertFalse(noise.isExcessRejection(0.6), "that is not near the wing");
  }
}
