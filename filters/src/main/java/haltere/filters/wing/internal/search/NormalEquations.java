package haltere.filters.wing.internal.search;

import haltere.filters.estimation.Require;
import java.util.Arrays;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;
import org.ejml.dense.row.MatrixFeatures_DDRM;
import org.ejml.dense.row.factory.LinearSolverFactory_DDRM;
import org.ejml.interfaces.linsol.LinearSolverDense;

/**
 * Normal equations A s = b of a weighted least-squares step with priors: A is the information
 * matrix and b the information vector. Adding allocates nothing.
 */
final class NormalEquations {
  private final int n;
  private final DMatrixRMaj a;
  private final double[] b;
  private final DMatrixRMaj leading = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj right = new DMatrixRMaj(1, 1);
  private final DMatrixRMaj solution = new DMatrixRMaj(1, 1);
  private final LinearSolverDense<DMatrixRMaj> solver = LinearSolverFactory_DDRM.chol(1);

  /** Equations without information. */
  NormalEquations(int unknowns) {
    n = Require.atLeast("unknowns", 1, unknowns);
    a = new DMatrixRMaj(n, n);
    b = new double[n];
  }

  void clear() {
    Arrays.fill(a.data, 0);
    Arrays.fill(b, 0);
  }

  /**
   * Adds a measurement.
   *
   * @param weight one over its variance
   * @param row its derivatives by the first {@code length} unknowns; not kept
   * @param length how many entries of the row count
   * @param residual measured minus expected
   */
  void add(double weight, double[] row, int length, double residual) {
    double[] d = a.data;
    for (int i = 0; i < length; i++) {
      double scaled = weight * row[i];
      if (scaled != 0) {
        b[i] += scaled * residual;
        int at = i * n;
        for (int j = 0; j <= i; j++) {
          d[at + j] += scaled * row[j];
        }
      }
    }
  }

  /** Adds a prior of one unknown: its mean minus the present value, and its standard deviation. */
  void addPrior(int index, double difference, double sd) {
    double weight = 1 / (sd * sd);
    a.data[index * n + index] += weight;
    b[index] += weight * difference;
  }

  /**
   * Adds the information matrix of other equations.
   *
   * @param other of fewer unknowns
   * @param from the unknown here that is the first one there
   * @param scale factor of their information
   */
  void addInformation(NormalEquations other, int from, double scale) {
    for (int i = 0; i < other.n; i++) {
      for (int j = 0; j <= i; j++) {
        a.data[(from + i) * n + from + j] += scale * other.a.data[i * other.n + j];
      }
    }
  }

  /**
   * Solves for the first unknowns, with the others at 0.
   *
   * @param unknowns how many
   * @param out gets the step, {@code unknowns} entries
   * @return false if A is not positive definite
   */
  boolean solve(int unknowns, double[] out) {
    CommonOps_DDRM.extract(a, 0, unknowns, 0, unknowns, leading);
    CommonOps_DDRM.symmLowerToFull(leading);
    right.reshape(unknowns, 1);
    solution.reshape(unknowns, 1);
    System.arraycopy(b, 0, right.data, 0, unknowns);
    if (!solver.setA(leading)) {
      return false;
    }
    solver.solve(right, solution);
    System.arraycopy(solution.data, 0, out, 0, unknowns);
    return !MatrixFeatures_DDRM.hasUncountable(solution);
  }
}
