package haltere.filters.estimation;

import static haltere.filters.estimation.Matrices.column;
import static haltere.filters.estimation.Matrices.covarianceOf;
import static haltere.filters.estimation.Matrices.diagonal;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.motion.ConstantVelocity;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** After ten million updates a covariance is still one, whatever the ratio of the noises. */
class PositiveCovarianceTest {
  private static final int STEPS = 10_000_000;
  private static final double DT_S = 1e-3;

  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1, 1e8})
  void theFilterOfOneAxisKeepsItsPositive(double ratio) {
    ConstantVelocityAxis filter = new ConstantVelocityAxis(ratio);
    filter.launch(0, 0, 1e6, 1e6);
    for (int k = 0; k < STEPS; k++) {
      filter.predict(DT_S);
      filter.update(0, 1);
    }
    assertPositive(
        Matrices.rows(
            new double[] {filter.positionVariance(), filter.crossCovariance()},
            new double[] {filter.crossCovariance(), filter.velocityVariance()}));
  }

  @ParameterizedTest
  @ValueSource(doubles = {1e-8, 1, 1e8})
  void theFilterOfFourStatesKeepsItsPositive(double ratio) {
    FourStateEkf filter = new FourStateEkf(Gate.OPEN, 20);
    filter.setState(1.5, 1, 0, 1000);
    filter.setVariances(1e4, 1e4, 1e4, 1e6);
    double q = ratio * DT_S;
    double phase = 0;
    for (int k = 0; k < STEPS; k++) {
      filter.predict(0, 0, 0, 0, 0, DT_S);
      filter.addNoise(q, q, q, q);
      phase += 0.3;
      if (phase > Math.PI) {
        phase -= 2 * Math.PI;
      }
      // A cheap stand-in for sine and cosine: any Jacobian must do.
      double wave = phase * (1 - Math.abs(phase) / Math.PI);
      filter.update(0, 1, wave, 1 - Math.abs(wave), 0, 1);
    }
    DMatrixRMaj p = new DMatrixRMaj(4, 4);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        p.set(i, j, filter.covariance(i, j));
      }
    }
    assertPositive(p);
    assertEquals(STEPS, filter.monitor().applied());
  }

  @ParameterizedTest
  @CsvSource({"JOSEPH, 1e-8", "JOSEPH, 1e8", "UD, 1e-8", "UD, 1e8"})
  void theClearFiltersKeepTheirs(CovarianceForm form, double ratio) {
    KalmanFilter filter =
        new KalmanFilter(
            new ConstantVelocity(1, ratio),
            column(0, 0),
            diagonal(1e6, 1e6),
            FilterOptions.DEFAULT.withForm(form));
    LinearMeasurement position = LinearMeasurement.ofEntries(2, 1, 0);
    DMatrixRMaj z = column(0);
    for (int k = 0; k < STEPS / 20; k++) {
      filter.predict(DT_S);
      filter.update(position, z);
    }
    assertPositive(covarianceOf(filter));
  }

  /** Measurements so good, after a launch so bad, that the plain form P − K S Kᵀ turns negative. */
  @ParameterizedTest
  @EnumSource(CovarianceForm.class)
  void aPerfectMeasurementAfterNoKnowledgeLeavesItPositive(CovarianceForm form) {
    KalmanFilter clear =
        new KalmanFilter(
            new ConstantVelocity(1, 1e-8),
            column(0, 0),
            diagonal(1e12, 1e12),
            FilterOptions.DEFAULT.withForm(form));
    ConstantVelocityAxis fast = new ConstantVelocityAxis(1e-8);
    fast.launch(0, 0, 1e12, 1e12);
    LinearMeasurement position = LinearMeasurement.ofEntries(2, 1e-8, 0);
    for (int k = 0; k < 1000; k++) {
      clear.predict(DT_S);
      fast.predict(DT_S);
      clear.update(position, 0);
      fast.update(0, 1e-8);
      assertTrue(clear.covariance(0, 0) > 0 && clear.covariance(1, 1) > 0, "at step " + k);
      assertTrue(fast.positionVariance() > 0 && fast.velocityVariance() > 0, "at step " + k);
    }
    assertPositive(covarianceOf(clear));
  }

  private static void assertPositive(DMatrixRMaj p) {
    for (int i = 0; i < p.numRows; i++) {
      for (int j = 0; j < i; j++) {
        assertEquals(p.get(i, j), p.get(j, i), "symmetric");
      }
    }
    assertTrue(new PositiveDefinite().factor(p), "positive definite:\n" + p);
  }
}
