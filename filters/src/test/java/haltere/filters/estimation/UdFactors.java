package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;

/** M = U D Uᵀ of a symmetric positive semidefinite matrix: Bierman (1977), section III.3. */
final class UdFactors {
  private UdFactors() {}

  /** Fills u, unit upper triangular, and d; a pivot that is not positive gives a zero column. */
  static void of(DMatrixRMaj m, DMatrixRMaj u, double[] d) {
    int n = m.numRows;
    u.setTo(m);
    for (int j = n - 1; j >= 0; j--) {
      d[j] = Math.max(0, u.get(j, j));
      for (int i = 0; i < j; i++) {
        u.set(i, j, d[j] > 0 ? u.get(i, j) / d[j] : 0);
      }
      // What is left for the columns before: M − d_j u_j u_jᵀ.
      for (int k = 0; k < j; k++) {
        for (int i = 0; i <= k; i++) {
          u.add(i, k, -u.get(i, j) * d[j] * u.get(k, j));
        }
      }
    }
    for (int i = 0; i < n; i++) {
      u.set(i, i, 1);
      for (int j = 0; j < i; j++) {
        u.set(i, j, 0);
      }
    }
  }
}
