package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.decomposition.chol.CholeskyDecompositionInner_DDRM;
import org.ejml.dense.row.linsol.chol.LinearSolverChol_DDRM;

/** Solves with a symmetric positive definite matrix by its Cholesky factor; never an inverse. */
final class PositiveDefinite {
  private final CholeskyDecompositionInner_DDRM cholesky =
      new CholeskyDecompositionInner_DDRM(true);
  private final LinearSolverChol_DDRM solver = new LinearSolverChol_DDRM(cholesky);
  private final DMatrixRMaj work = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj solved = new DMatrixRMaj(1, 1);

  /** Factors A = L Lᵀ; false if A is not positive definite. A stays as it is. */
  boolean factor(DMatrixRMaj a) {
    work.setTo(a);
    if (!solver.setA(work)) {
      return false;
    }
    DMatrixRMaj l = lower();
    for (int i = 0; i < l.numRows; i++) {
      double d = l.get(i, i);
      if (!(d > 0) || Double.isInfinite(d)) {
        return false;
      }
    }
    return true;
  }

  /** L; its upper triangle is zero. */
  DMatrixRMaj lower() {
    return cholesky.getT();
  }

  /** A⁻¹ B into x. */
  void solve(DMatrixRMaj b, DMatrixRMaj x) {
    solver.solve(b, x);
  }

  /** yᵀ A⁻¹ y. */
  double quadratic(DMatrixRMaj y) {
    solved.reshape(y.numRows, 1);
    solver.solve(y, solved);
    double sum = 0;
    for (int i = 0; i < y.numRows; i++) {
      sum += y.get(i) * solved.get(i);
    }
    return sum;
  }

  /** ln det A. */
  double logDeterminant() {
    DMatrixRMaj l = lower();
    double sum = 0;
    for (int i = 0; i < l.numRows; i++) {
      sum += Math.log(l.get(i, i));
    }
    return 2 * sum;
  }
}
