package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;

/** Changes a number of a covariance so that it stays symmetric and positive semidefinite. */
final class CovarianceEdit {
  /** What rounding may take from an eigenvalue of the correlation matrix. */
  private static final double SLACK = 1e-9;

  private CovarianceEdit() {}

  /**
   * A covariance with another number. A variance takes its row and column along, so that the
   * correlations stay; a covariance changes its counterpart as well.
   *
   * @return a new covariance; p stays as it is
   * @throws IllegalArgumentException if no covariance has such a number there
   */
  static DMatrixRMaj with(DMatrixRMaj p, int row, int column, double value) {
    DMatrixRMaj edited = p.copy();
    if (row == column) {
      if (!(value >= 0)) {
        throw new IllegalArgumentException("a variance cannot be negative: " + value);
      }
      double before = p.get(row, row);
      double scale = before > 0 ? Math.sqrt(value / before) : 0;
      for (int i = 0; i < p.numRows; i++) {
        edited.set(row, i, scale * p.get(row, i));
        edited.set(i, row, scale * p.get(i, row));
      }
      edited.set(row, row, value);
      return edited;
    }
    edited.set(row, column, value);
    edited.set(column, row, value);
    if (!isCovariance(edited)) {
      throw new IllegalArgumentException(
          value + " is more than the variances of its row and its column allow");
    }
    return edited;
  }

  /** By Cholesky's decomposition of the correlations. */
  private static boolean isCovariance(DMatrixRMaj p) {
    int n = p.numRows;
    DMatrixRMaj correlations = new DMatrixRMaj(n, n);
    for (int i = 0; i < n; i++) {
      for (int j = 0; j < n; j++) {
        double scale = Math.sqrt(p.get(i, i) * p.get(j, j));
        if (scale == 0 && i != j && p.get(i, j) != 0) {
          return false;
        }
        correlations.set(i, j, i == j ? 1 + SLACK : scale == 0 ? 0 : p.get(i, j) / scale);
      }
    }
    return new PositiveDefinite().factor(correlations);
  }
}
