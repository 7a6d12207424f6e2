package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.MatrixFeatures_DDRM;

/** Rejects invalid numbers with uniform messages. Any thread. */
public final class Require {
  private Require() {}

  static double positive(String name, double value) {
    if (!(value > 0) || Double.isInfinite(value)) {
      throw new IllegalArgumentException(name + " must be positive and finite: " + value);
    }
    return value;
  }

  /**
   * Rejects negative, infinite and NaN numbers.
   *
   * @param name name of the number
   * @param value the number
   * @return the number
   * @throws IllegalArgumentException if it is invalid
   */
  public static double notNegative(String name, double value) {
    if (!(value >= 0) || Double.isInfinite(value)) {
      throw new IllegalArgumentException(name + " must be finite and not negative: " + value);
    }
    return value;
  }

  /**
   * Rejects numbers that are too small.
   *
   * @param name name of the number
   * @param min smallest valid number
   * @param value the number
   * @return the number
   * @throws IllegalArgumentException if it is invalid
   */
  public static int atLeast(String name, int min, int value) {
    if (value < min) {
      throw new IllegalArgumentException(name + " must be at least " + min + ": " + value);
    }
    return value;
  }

  /** A time step; NaN, infinite or negative is a bug of the caller. */
  static double timeStep(double dtS) {
    if (!(dtS >= 0) || Double.isInfinite(dtS)) {
      throw new IllegalArgumentException(
          "time step must be finite and not negative: " + dtS + " s");
    }
    return dtS;
  }

  static void size(String name, DMatrixRMaj matrix, int rows, int columns) {
    if (matrix.numRows != rows || matrix.numCols != columns) {
      throw new IllegalArgumentException(
          name
              + " must be "
              + rows
              + " x "
              + columns
              + ", not "
              + matrix.numRows
              + " x "
              + matrix.numCols);
    }
  }

  static void finite(String name, DMatrixRMaj matrix) {
    if (MatrixFeatures_DDRM.hasUncountable(matrix)) {
      throw new IllegalArgumentException(name + " has entries that are not finite");
    }
  }

  /** A state of the right size, all finite. */
  static void state(DMatrixRMaj x, int size) {
    size("state", x, size, 1);
    finite("state", x);
  }

  /** Symmetric and positive definite. */
  static void covariance(String name, DMatrixRMaj p, int size) {
    size(name, p, size, size);
    finite(name, p);
    for (int i = 0; i < size; i++) {
      for (int j = 0; j < i; j++) {
        double scale = Math.sqrt(Math.abs(p.get(i, i) * p.get(j, j)));
        if (Math.abs(p.get(i, j) - p.get(j, i)) > 1e-9 * scale) {
          throw new IllegalArgumentException(name + " is not symmetric");
        }
      }
    }
    if (!MatrixFeatures_DDRM.isPositiveDefinite(p)) {
      throw new IllegalArgumentException(name + " is not positive definite");
    }
  }
}
