package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.covarianceOf;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.AxisMotion;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Covariances stay positive definite over ten million updates for any ratio of noises. */
class PositiveCovarianceTest {
  private static final int STEPS = 10_000_000;
  private static final double DT_S = 1e-3;

  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1, 1e8})
  void kernelKeepsCovariancesPositiveUnderScalarUpdates(double ratio) {
    GaussianState belief = new GaussianState(4);
    belief.setVariances(1e4, 1e4, 1e4, 1e6);
    double[] row = {1, 0, 0, 0};
    double q = ratio * DT_S;
    double phase = 0;
    for (int k = 0; k < STEPS; k++) {
      belief.shear(2, 3, DT_S);
      for (int i = 0; i < 4; i++) {
        belief.addNoise(i, q);
      }
      phase += 0.3;
      if (phase > Math.PI) {
        phase -= 2 * Math.PI;
      }
      // a cheap stand-in for sine and cosine: any Jacobian must do
      row[1] = phase * (1 - Math.abs(phase) / Math.PI);
      row[2] = 1 - Math.abs(row[1]);
      belief.project(row);
      belief.correct(0, 1);
    }
    assertPositive(belief.covariance());
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1e8})
  void filterKeepsCovariancesPositive(double ratio) {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, ratio), column(0, 0), diagonal(1e6, 1e6));
    LinearMeasurement position = LinearMeasurement.ofEntries(2, 1, 0);
    DMatrixRMaj z = column(0);
    for (int k = 0; k < STEPS / 20; k++) {
      filter.predict(DT_S);
      filter.update(position, z);
    }
    assertPositive(covarianceOf(filter));
  }

  /** Measurements so good, after a launch so bad, that the plain form P − K S Kᵀ turns negative. */
  @Test
  void perfectMeasurementOfAnUnknownStateKeepsCovariancesPositive() {
    KalmanFilter filter =
        new KalmanFilter(AxisMotion.constantVelocity(1, 1e-8), column(0, 0), diagonal(1e12, 1e12));
    LinearMeasurement position = LinearMeasurement.ofEntries(2, 1e-8, 0);
    for (int k = 0; k < 1000; k++) {
      filter.predict(DT_S);
      filter.update(position, 0);
      assertTrue(filter.covariance(0, 0) > 0 && filter.covariance(1, 1) > 0, "at step " + k);
    }
    assertPositive(covarianceOf(filter));
  }

  /** Rows in any direction of eleven states, as precise as doubles allow. */
  @Test
  void preciseRowsInAnyDirectionKeepCovariancesPositiveAndCorrect() {
    for (int seed = 0; seed < 50; seed++) {
      Draws draws = new Draws(seed);
      int n = 11;
      GaussianState belief = new GaussianState(n);
      double[] variances = new double[n];
      for (int i = 0; i < n; i++) {
        variances[i] = Math.exp(draws.uniform(-12, 12));
      }
      belief.setVariances(variances);
      for (int k = 0; k < 200; k++) {
        double[] row = new double[n];
        for (int i = 0; i < n; i++) {
          row[i] = draws.normal(1) / Math.sqrt(variances[i]);
        }
        double variance = belief.project(row) * Math.exp(draws.uniform(-25, 5));
        belief.correct(0, variance);
        assertPositive(belief.covariance());
        double posterior = belief.project(row);
        assertTrue(posterior <= 1.01 * variance && posterior > 0, posterior + " of " + variance);
        for (int i = 0; i < n; i++) {
          belief.addNoise(i, 1e-6 * variances[i]);
        }
      }
    }
  }

  private static void assertPositive(DMatrixRMaj p) {
    for (int i = 0; i < p.numRows; i++) {
      for (int j = 0; j < i; j++) {
        assertEquals(p.get(i, j), p.get(j, i), "symmetric");
      }
    }
    assertTrue(MatrixFeatures_DDRM.isPositiveDefinite(p), () -> "positive definite:\n" + p);
  }
}
