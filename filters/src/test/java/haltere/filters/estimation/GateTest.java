package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.AxisMotion;
import org.apache.commons.statistics.distribution.ChiSquaredDistribution;
import org.junit.jupiter.api.Test;

class GateTest {
  @Test
  void scalarPassesUpToGStandardDeviations() {
    Gate gate = Gate.sigmas(3);
    assertTrue(gate.passes(9, 1));
    assertFalse(gate.passes(Math.nextUp(9.0), 1));
    assertFalse(gate.passes(Double.NaN, 1));
    assertTrue(Gate.OPEN.passes(1e300, 1));
  }

  @Test
  void vectorPassesWithTheProbabilityOfAScalar() {
    Gate gate = Gate.sigmas(3);
    for (int m = 1; m <= 12; m++) {
      assertEquals(exceedance(9, 1), exceedance(gate.threshold(m), m), 1e-14);
    }
    assertEquals(5.991, Gate.probability(0.95).threshold(2), 5e-4);
  }

  private static double exceedance(double x, int degrees) {
    return ChiSquaredDistribution.of(degrees).survivalProbability(x);
  }

  @Test
  void invalidGatesAreRejected() {
    for (double g : new double[] {0, -1, 31, Double.NaN}) {
      assertThrows(IllegalArgumentException.class, () -> Gate.sigmas(g));
    }
    assertThrows(IllegalArgumentException.class, () -> Gate.probability(1));
  }

  @Test
  void shareOfRejectedMeasurementsEqualsThatOfTheGate() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 1), column(0, 0), diagonal(1, 1));
    LinearMeasurement position =
        new LinearMeasurement(
            Matrices.rows(new double[] {1, 0}), diagonal(0.5), Gate.probability(0.9));
    Draws draws = new Draws(5);
    int n = 20_000;
    int refused = 0;
    for (int i = 0; i < n; i++) {
      filter.launch(column(0, 0), diagonal(1, 1));
      UpdateOutcome outcome = filter.update(position, draws.normal(Math.sqrt(1.5)));
      refused += outcome == UpdateOutcome.GATED ? 1 : 0;
    }
    assertEquals(0.1, refused / (double) n, 4 * Math.sqrt(0.09 / n));
  }

  @Test
  void rejectedMeasurementsChangeNothing() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 0), column(0, 0), diagonal(1, 1));
    LinearMeasurement position =
        new LinearMeasurement(Matrices.rows(new double[] {1, 0}), diagonal(1), Gate.sigmas(3));
    Estimate before = filter.estimate();
    for (int k = 0; k < 20; k++) {
      assertEquals(UpdateOutcome.GATED, filter.update(position, k % 2 == 0 ? 100 : -100));
    }
    assertEquals(UpdateOutcome.UNUSABLE, filter.update(position, Double.NaN));
    assertEquals(before, filter.estimate(), "gated measurements change nothing");
    assertEquals(UpdateOutcome.APPLIED, filter.update(position, 1));
  }
}
