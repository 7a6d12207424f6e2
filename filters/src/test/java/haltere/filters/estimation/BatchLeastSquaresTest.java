package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.internal.example.Oscillations;
import haltere.filters.estimation.motion.AxisMotion;
import haltere.filters.estimation.motion.DampedOscillator;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

class BatchLeastSquaresTest {
  private static final DMatrixRMaj START = Matrices.column(0, 0.6, 0.1, 3);

  private static BatchLeastSquares oscillation(double noise) {
    BatchLeastSquares fit =
        new BatchLeastSquares(
            new DampedOscillator(Double.POSITIVE_INFINITY),
            LinearMeasurement.ofEntries(4, 1e-6, 0),
            START,
            Matrices.diagonal(1, 100, 100, 1000));
    Draws draws = new Draws(1);
    for (int k = 0; k < 300; k++) {
      double s = Oscillations.exact(0.1, 0, 0.07, 4.37, k * 0.01)[0];
      fit.add(k == 0 ? 0 : 0.01, s + draws.normal(noise));
    }
    return fit;
  }

  @Test
  void fitOfALinearProcessEqualsTheKalmanFilter() {
    DMatrixRMaj x = Matrices.column(1, 2, 3);
    DMatrixRMaj p = Matrices.diagonal(4, 25, 100);
    AxisMotion motion = AxisMotion.constantAcceleration(1, 0);
    LinearMeasurement position = LinearMeasurement.ofEntries(3, 0.5, 0);
    KalmanFilter filter = new KalmanFilter(motion, x, p);
    BatchLeastSquares batch = new BatchLeastSquares(motion, position, x, p);
    Draws draws = new Draws(3);
    for (int k = 0; k < 50; k++) {
      double dtS = draws.uniform(0, 0.2);
      double z = draws.normal(3);
      filter.predict(dtS);
      filter.update(position, z);
      batch.add(dtS, z);
    }
    Estimate last = batch.fit(Matrices.column(-50, 0, 7)).orElseThrow().last();
    assertEquals(filter.estimate().timeS(), last.timeS(), 1e-12);
    Matrices.assertClose(filter.estimate().state().toMatrix(), last.state().toMatrix(), 1e-3);
    Matrices.assertSameCovariance(
        filter.estimate().covariance().toMatrix(), last.covariance().toMatrix(), 1e-9);
  }

  @Test
  void noiselessOscillationIsIdentifiedExactly() {
    BatchLeastSquares.Solution found = oscillation(0).fit(START).orElseThrow();
    double[] end = Oscillations.exact(0.1, 0, 0.07, 4.37, 2.99);
    double[] first = {0.1, 0, 0.07, 4.37};
    double[] last = {end[0], end[1], 0.07, 4.37};
    for (int i = 0; i < 4; i++) {
      assertEquals(first[i], found.first().value(i), 0.01 * found.first().standardDeviation(i));
      assertEquals(last[i], found.last().value(i), 0.01 * found.last().standardDeviation(i));
    }
  }

  @Test
  void costDistinguishesNoiseFromModelErrors() {
    Interval band = Consistency.meanBand(1, 300, 0.999);
    assertTrue(band.contains(oscillation(0.001).fit(START).orElseThrow().cost() / 300));
    assertTrue(oscillation(0.003).fit(START).orElseThrow().cost() / 300 > 5);
  }

  @Test
  void startWithADivergingTrajectoryIsNoSolution() {
    assertTrue(oscillation(0.001).fit(Matrices.column(0.1, 0, -30, 100)).isEmpty());
  }

  @Test
  void nonFiniteMeasurementsAndDescendingTimesAreRejected() {
    BatchLeastSquares fit = oscillation(0.001);
    assertThrows(IllegalArgumentException.class, () -> fit.add(0.01, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> fit.add(-0.01, 1));
    assertThrows(IllegalArgumentException.class, () -> fit.add(0.01, 1, 2));
  }
}
