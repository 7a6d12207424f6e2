package haltere.filters.estimation;

import org.apache.commons.statistics.distribution.ChiSquaredDistribution;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;

/**
 * Tells whether an estimator is as sure as it says, by its normalised errors (NEES) and innovations
 * (NIS) squared: Bar-Shalom, Li and Kirubarajan (2001), "Estimation with Applications to Tracking
 * and Navigation", section 5.4.
 */
public final class Consistency {
  private Consistency() {}

  /**
   * Normalised estimation error squared, eᵀ P⁻¹ e. Its mean over runs is the state's dimension.
   *
   * @param error estimate minus truth
   * @param covariance of the estimate, positive definite
   * @return at least 0
   */
  public static double nees(DMatrixRMaj error, DMatrixRMaj covariance) {
    DMatrixRMaj weighted = new DMatrixRMaj(error.numRows, 1);
    if (!MatrixFeatures_DDRM.isPositiveDefinite(covariance)
        || !CommonOps_DDRM.solveSPD(covariance, error, weighted)) {
      throw new IllegalArgumentException("covariance is not positive definite");
    }
    return CommonOps_DDRM.dot(error, weighted);
  }

  /**
   * Normalised estimation error squared of an estimate.
   *
   * @param estimate state and covariance
   * @param truth the true state
   * @return at least 0; its mean over runs is the state's dimension
   */
  public static double nees(Estimate estimate, double... truth) {
    DMatrixRMaj error = estimate.state().toMatrix();
    if (truth.length != error.numRows) {
      throw new IllegalArgumentException(
          "truth has " + truth.length + " entries, the state " + error.numRows);
    }
    for (int i = 0; i < truth.length; i++) {
      error.add(i, 0, -truth[i]);
    }
    return nees(error, estimate.covariance().toMatrix());
  }

  /**
   * The band in which the mean of independent NEES or NIS values lies when the estimator is
   * consistent.
   *
   * @param dimension of the state (NEES) or of the measurement (NIS)
   * @param samples independent values that the mean is taken of
   * @param confidence such as 0.95
   * @return around the dimension
   */
  public static Interval meanBand(int dimension, int samples, double confidence) {
    Require.atLeast("dimension", 1, dimension);
    Require.atLeast("samples", 1, samples);
    double tail = (1 - confidence) / 2;
    ChiSquaredDistribution sum = ChiSquaredDistribution.of((double) dimension * samples);
    return new Interval(
        sum.inverseCumulativeProbability(tail) / samples,
        sum.inverseSurvivalProbability(tail) / samples);
  }
}
