package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * One measurement against a prediction: y, H, R, S, K, and how likely it was. A workspace that is
 * used again for each measurement; it allocates only when a larger measurement comes than ever.
 */
final class Innovation {
  private static final double LOG_TWO_PI = Math.log(2 * Math.PI);

  final DMatrixRMaj y = new DMatrixRMaj(1, 1);
  final DMatrixRMaj h = new DMatrixRMaj(1, 1);
  final DMatrixRMaj r = new DMatrixRMaj(1, 1);
  final DMatrixRMaj s = new DMatrixRMaj(1, 1);
  final DMatrixRMaj gain = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj expected = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj hp = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj gainTransposed = new DMatrixRMaj(1, 1);
  private final PositiveDefinite factored = new PositiveDefinite();
  private double nis;
  private double logLikelihood;

  /**
   * Compares a measurement with what x and P lead one to expect; false if it cannot be used. S = H
   * P Hᵀ + R, K = P Hᵀ S⁻¹.
   */
  boolean compute(MeasurementModel model, DMatrixRMaj z, DMatrixRMaj x, DMatrixRMaj p) {
    Require.size("measurement", z, model.size(), 1);
    reshape(model.size(), x.numRows);
    model.expected(x, expected);
    model.jacobian(x, h);
    model.noise(x, r);
    model.residual(z, expected, y);
    CommonOps_DDRM.mult(h, p, hp);
    CommonOps_DDRM.multTransB(hp, h, s);
    CommonOps_DDRM.addEquals(s, r);
    double logDeterminant;
    if (size() == 1) {
      // S is a number: no factor, no inverse.
      double variance = s.get(0);
      nis = y.get(0) * y.get(0) / variance;
      logDeterminant = Math.log(variance);
      for (int i = 0; i < hp.numCols; i++) {
        gain.set(i, hp.get(i) / variance);
      }
      if (!(variance > 0)) {
        return false;
      }
    } else {
      if (!factored.factor(s)) {
        return false;
      }
      nis = factored.quadratic(y);
      logDeterminant = factored.logDeterminant();
      // S Kᵀ = H P, as P is symmetric.
      factored.solve(hp, gainTransposed);
      CommonOps_DDRM.transpose(gainTransposed, gain);
    }
    logLikelihood = -0.5 * (nis + logDeterminant + size() * LOG_TWO_PI);
    return Double.isFinite(logLikelihood);
  }

  int size() {
    return y.numRows;
  }

  /** yᵀ S⁻¹ y. */
  double nis() {
    return nis;
  }

  /** ln N(y; 0, S). */
  double logLikelihood() {
    return logLikelihood;
  }

  private void reshape(int m, int n) {
    y.reshape(m, 1);
    expected.reshape(m, 1);
    h.reshape(m, n);
    r.reshape(m, m);
    s.reshape(m, m);
    hp.reshape(m, n);
    gain.reshape(n, m);
    gainTransposed.reshape(m, n);
  }
}
