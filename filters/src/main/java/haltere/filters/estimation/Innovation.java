package haltere.filters.estimation;

import org.ejml.LinearSolverSafe;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * One measurement against a prediction: y, H, R, S, K. A reused workspace; it allocates only for a
 * larger measurement than before.
 */
final class Innovation {
  final DMatrixRMaj y = new DMatrixRMaj(1, 1);
  final DMatrixRMaj h = new DMatrixRMaj(1, 1);
  final DMatrixRMaj r = new DMatrixRMaj(1, 1);
  final DMatrixRMaj s = new DMatrixRMaj(1, 1);
  final DMatrixRMaj gain = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj expected = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj hp = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj gainTransposed = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj weighted = new DMatrixRMaj(1, 1);

  /** solver of S, of which it keeps a copy */
  private final LinearSolverDense<DMatrixRMaj> solver =
      new LinearSolverSafe<>(LinearSolverFactory_DDRM.chol(1));

  /** yᵀ S⁻¹ y. */
  double nis;

  /**
   * Compares a measurement with the expectation by x and P; false if it is unusable. S = H P Hᵀ +
   * R, K = P Hᵀ S⁻¹.
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
    if (!solver.setA(s)) {
      return false;
    }
    solver.solve(y, weighted);
    nis = CommonOps_DDRM.dot(y, weighted);
    // S Kᵀ = H P, as P is symmetric.
    solver.solve(hp, gainTransposed);
    CommonOps_DDRM.transpose(gainTransposed, gain);
    return Double.isFinite(nis) && !MatrixFeatures_DDRM.hasUncountable(s);
  }

  int size() {
    return y.numRows;
  }

  private void reshape(int m, int n) {
    y.reshape(m, 1);
    expected.reshape(m, 1);
    weighted.reshape(m, 1);
    h.reshape(m, n);
    r.reshape(m, m);
    s.reshape(m, m);
    hp.reshape(m, n);
    gain.reshape(n, m);
    gainTransposed.reshape(m, n);
  }
}
