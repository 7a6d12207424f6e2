package haltere.testing.wings;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Errors over the phase of a stroke are separated by cause. */
class PhaseErrorsTest {
  @Test
  void constantAmplitudeDelayAndRemainderErrorsAreSeparated() {
    SplittableRandom random = new SplittableRandom(1);
    PhaseErrors errors = new PhaseErrors();
    for (int i = 0; i < 100_000; i++) {
      double phase = random.nextDouble(0, 2 * Math.PI);
      double repeating =
          0.03 * Math.sin(phase) - 0.05 * Math.cos(phase) + 0.02 * Math.cos(3 * phase);
      errors.add(phase, 0.01 + repeating + random.nextDouble(-0.03, 0.03));
    }

    assertEquals(0.01, errors.constantRad(), 5e-4);
    assertEquals(0.03, errors.withAngleRad(), 1e-3);
    assertEquals(-0.05, errors.withSpeedRad(), 1e-3);
    double squares = (0.03 * 0.03 + 0.05 * 0.05 + 0.02 * 0.02) / 2;
    assertEquals(Math.sqrt(squares), errors.repeatingRad(), 1e-3);
    assertEquals(0.03 / Math.sqrt(3), errors.remainderRad(), 1e-3);
    assertEquals(0.01 - 0.05 + 0.02, errors.meanRad(0), 0.01);
  }
}
