package haltere.filters.estimation;

/**
 * Changes a number of a covariance so that it stays one: symmetric, without a negative variance in
 * any direction.
 *
 * <p>Thread rule: stateless.
 */
public final class CovarianceEdit {
  private static final double SLACK = 1e-9;

  private CovarianceEdit() {}

  /**
   * A covariance with another number. A variance takes its row and column along, so that the
   * correlations stay; a covariance changes its counterpart as well.
   *
   * @param p square, row by row; stays as it is
   * @param size number of rows
   * @param row from 0
   * @param column from 0
   * @param value the new number
   * @return a new covariance
   * @throws IllegalArgumentException if no covariance has such a number there
   */
  public static double[] with(double[] p, int size, int row, int column, double value) {
    double[] edited = p.clone();
    if (row == column) {
      if (!(value >= 0)) {
        throw new IllegalArgumentException("a variance cannot be negative: " + value);
      }
      double before = p[row * size + row];
      double scale = before > 0 ? Math.sqrt(value / before) : 0;
      for (int i = 0; i < size; i++) {
        edited[row * size + i] *= scale;
        edited[i * size + row] *= scale;
      }
      edited[row * size + row] = value;
    } else {
      edited[row * size + column] = value;
      edited[column * size + row] = value;
      if (!isCovariance(edited, size)) {
        throw new IllegalArgumentException(
            value + " is more than the variances of its row and its column allow");
      }
    }
    return edited;
  }

  /** By Cholesky's decomposition of the correlations, a little of which may be lost to rounding. */
  private static boolean isCovariance(double[] p, int size) {
    double[][] l = new double[size][size];
    for (int i = 0; i < size; i++) {
      for (int j = 0; j <= i; j++) {
        double scale = Math.sqrt(p[i * size + i] * p[j * size + j]);
        if (scale == 0 && i != j && p[i * size + j] != 0) {
          return false;
        }
        double sum = scale > 0 ? p[i * size + j] / scale : i == j ? 1 : p[i * size + j];
        for (int k = 0; k < j; k++) {
          sum -= l[i][k] * l[j][k];
        }
        if (i == j) {
          if (!(sum >= -SLACK)) {
            return false;
          }
          l[i][i] = Math.sqrt(Math.max(sum, SLACK));
        } else {
          l[i][j] = sum / l[j][j];
        }
      }
    }
    return true;
  }
}
