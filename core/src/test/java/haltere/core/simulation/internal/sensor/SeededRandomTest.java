package haltere.core.simulation.internal.sensor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** Random numbers of scenes, and tabulated functions. */
class SeededRandomTest {
  @Test
  void numbersAreReproducibleForSeedAndPurpose() {
    SeededRandom random = new SeededRandom(1, "noise");

    assertEquals(-1559538142592218250L, random.nextLong());
  }

  @Test
  void numbersDifferBetweenPurposes() {
    assertNotEquals(
        new SeededRandom(1, "noise").nextLong(), new SeededRandom(1, "jitter").nextLong());
    assertNotEquals(
        new SeededRandom(1, "noise").nextLong(), new SeededRandom(2, "noise").nextLong());
    assertNotEquals(
        SeededRandom.of(1, "turn", 3).nextLong(), SeededRandom.of(1, "turn", 4).nextLong());
  }

  @Test
  void normalNumbersHaveTheMomentsOfTheNormalDistribution() {
    SeededRandom random = new SeededRandom(3, "test");
    int n = 1_000_000;
    double[] moment = new double[5];
    for (int i = 0; i < n; i++) {
      double z = random.gaussian();
      for (int k = 1; k <= 4; k++) {
        moment[k] += Math.pow(z, k) / n;
      }
      assertTrue(Math.abs(z) < 4.1);
    }

    assertEquals(0, moment[1], 0.005);
    assertEquals(1, moment[2], 0.007);
    assertEquals(0, moment[3], 0.015);
    assertEquals(3, moment[4], 0.06);
  }

  @Test
  void waitingTimesAreExponential() {
    SeededRandom random = new SeededRandom(4, "test");
    int n = 1_000_000;
    double mean = 0;
    int beyondOne = 0;
    for (int i = 0; i < n; i++) {
      double wait = random.exponential();
      mean += wait / n;
      beyondOne += wait > 1 ? 1 : 0;
    }

    assertEquals(1, mean, 0.005);
    assertEquals(Math.exp(-1), beyondOne / (double) n, 0.003);
  }

  @Test
  void integersAreUniformBelowTheirBound() {
    SeededRandom random = new SeededRandom(5, "test");
    int[] counts = new int[7];
    for (int i = 0; i < 70_000; i++) {
      counts[random.below(7)]++;
    }

    for (int count : counts) {
      assertEquals(10_000, count, 500);
    }
  }

  @Test
  void decayTableIsTheExponential() {
    for (double x = 0; x < 40; x += 0.001237) {
      assertEquals(Math.exp(-x), Exponential.decay(x), 2e-11 * Math.exp(-x) + 1e-17);
    }
    assertEquals(0, Exponential.decay(40));
    assertEquals(0, Exponential.decay(1e300));
  }

  @Test
  void logarithmTableIsTheLogarithm() {
    for (double x = 1e-300; x < 1e300; x *= 1.37) {
      assertEquals(Math.log(x), Exponential.log(x), 1e-13 * Math.max(1, Math.abs(Math.log(x))));
    }
    for (double x = 1e-6; x < 3; x += 0.00077) {
      assertEquals(Math.log(x), Exponential.log(x), 1e-13 * Math.max(1, Math.abs(Math.log(x))));
    }
  }
}
