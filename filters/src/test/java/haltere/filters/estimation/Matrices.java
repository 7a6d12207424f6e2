package haltere.filters.estimation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.function.Supplier;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/** Small matrices for the tests, and comparisons that name the entry that differs. */
final class Matrices {
  private Matrices() {}

  static DMatrixRMaj column(double... values) {
    return new DMatrixRMaj(values.length, 1, true, values.clone());
  }

  static DMatrixRMaj diagonal(double... values) {
    return CommonOps_DDRM.diag(values);
  }

  static DMatrixRMaj rows(double[]... rows) {
    return new DMatrixRMaj(rows);
  }

  static DMatrixRMaj covarianceOf(KalmanFilter estimator) {
    return estimator.estimate().covariance().toMatrix();
  }

  /** F P Fᵀ + Q. */
  static DMatrixRMaj propagated(DMatrixRMaj f, DMatrixRMaj p, DMatrixRMaj q) {
    DMatrixRMaj fp = new DMatrixRMaj(f.numRows, p.numCols);
    CommonOps_DDRM.mult(f, p, fp);
    DMatrixRMaj sum = q.copy();
    CommonOps_DDRM.multAddTransB(fp, f, sum);
    return sum;
  }

  private static Supplier<String> where(int i, int j, DMatrixRMaj expected, DMatrixRMaj actual) {
    return () -> "entry (" + i + ", " + j + ") of\n" + actual + "expected\n" + expected;
  }

  /** Entries equal to a tolerance relative to the greatest. */
  static void assertClose(DMatrixRMaj expected, DMatrixRMaj actual, double relative) {
    assertEquals(expected.numRows, actual.numRows, "rows");
    assertEquals(expected.numCols, actual.numCols, "columns");
    double scale = CommonOps_DDRM.elementMaxAbs(expected);
    for (int i = 0; i < expected.numRows; i++) {
      for (int j = 0; j < expected.numCols; j++) {
        assertEquals(
            expected.get(i, j), actual.get(i, j), relative * scale, where(i, j, expected, actual));
      }
    }
  }

  /** Entries equal to a tolerance relative to the standard deviations of their row and column. */
  static void assertSameCovariance(DMatrixRMaj expected, DMatrixRMaj actual, double relative) {
    for (int i = 0; i < expected.numRows; i++) {
      for (int j = 0; j < expected.numCols; j++) {
        assertEquals(
            expected.get(i, j),
            actual.get(i, j),
            relative * Math.sqrt(expected.get(i, i) * expected.get(j, j)),
            where(i, j, expected, actual));
      }
    }
  }
}
