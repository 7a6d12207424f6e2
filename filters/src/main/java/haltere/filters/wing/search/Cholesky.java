package haltere.filters.wing.search;

/** Solves the normal equations of a least squares fit. */
final class Cholesky {
  private Cholesky() {}

  /**
   * Solves by Cholesky's decomposition; overwrites the matrix.
   *
   * @param m symmetric; its lower triangle is taken
   * @param rhs right hand side
   * @param out the solution
   * @param n how many unknowns
   * @return false if the matrix is not positive definite
   */
  static boolean solve(double[][] m, double[] rhs, double[] out, int n) {
    for (int j = 0; j < n; j++) {
      for (int i = j; i < n; i++) {
        double sum = m[i][j];
        for (int k = 0; k < j; k++) {
          sum -= m[i][k] * m[j][k];
        }
        if (i == j) {
          if (!(sum > 0)) {
            return false;
          }
          m[j][j] = Math.sqrt(sum);
        } else {
          m[i][j] = sum / m[j][j];
        }
      }
    }
    for (int i = 0; i < n; i++) {
      double sum = rhs[i];
      for (int k = 0; k < i; k++) {
        sum -= m[i][k] * out[k];
      }
      out[i] = sum / m[i][i];
    }
    for (int i = n - 1; i >= 0; i--) {
      double sum = out[i];
      for (int k = i + 1; k < n; k++) {
        sum -= m[k][i] * out[k];
      }
      out[i] = sum / m[i][i];
    }
    return true;
  }
}
