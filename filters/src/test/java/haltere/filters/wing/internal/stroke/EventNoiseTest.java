package haltere.filters.wing.internal.stroke;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class EventNoiseTest {
  private static final double FAR_SQUARE = 50 * 50;

  @Test
  void noiseIsSeparatedIntoWingShapeAndTiming() {
    SplittableRandom random = new SplittableRandom(1);
    EventNoise noise = new EventNoise(4, 0);
    double full = 1500;
    for (int i = 0; i < 40_000; i++) {
      double speed = i % 2 == 0 ? 0 : full;
      noise.variance(FAR_SQUARE, speed);
      double sd = speed == 0 ? 0.03 : Math.hypot(0.03, speed * 40e-6);
      noise.judge(sd * random.nextGaussian(), 0, speed, full);
    }
    assertEquals(0.03, Math.sqrt(noise.variance(FAR_SQUARE, 0)), 0.006);
    assertEquals(Math.hypot(0.03, 0.06), Math.sqrt(noise.variance(FAR_SQUARE, full)), 0.012);
    assertEquals(1, noise.nis(), 0.1);
  }

  @Test
  void eventNearTheHingeHasALargerVariance() {
    EventNoise noise = new EventNoise(4, 0);
    double near = noise.variance(10 * 10, 0);
    double far = noise.variance(40 * 40, 0);
    assertEquals(0.12 / 100 - 0.12 / 1600, near - far, 1e-9);
  }

  @Test
  void eventBeyondTheGateIsRejectedAndOutliersReduceWeights() {
    EventNoise noise = new EventNoise(4, 0);
    double sd = Math.sqrt(noise.variance(FAR_SQUARE, 0));
    assertEquals(0, noise.judge(4.1 * sd, 0, 0, 1500));
    assertEquals(0, noise.judge(Double.NaN, 0, 0, 1500));
    double clean = noise.judge(3 * sd, 0, 0, 1500);
    assertTrue(clean > 0 && clean < 1);
    for (int i = 0; i < 2000; i++) {
      noise.variance(FAR_SQUARE, 0);
      noise.judge(0.5 + 0.7 * (i % 2), 0, 0, 1500);
    }
    noise.variance(FAR_SQUARE, 0);
    assertTrue(noise.judge(3 * sd, 0, 0, 1500) < clean, "with outliers all around");
  }
}
