package haltere.filters.orientation.internal.axis;

import haltere.filters.orientation.camera.Vectors;
import org.ejml.data.DMatrixRMaj;
import org.ejml.dense.row.CommonOps_DDRM;

/**
 * Body rates ω = (p, q, r) and a unit quaternion (a, b, c, d), d its scalar part, in an array of
 * seven, and their matrices.
 *
 * <pre>
 * ω̇ = −ω/τ    (ȧ, ḃ, ċ, ḋ) = ½ Ξ ω / n = ½ Ω (a, b, c, d) / n,   n = |(a, b, c, d)|
 * u = ½ A (a, b, c, d) = (a² + d² − b² − c², 2(ab + cd), 2(ac − bd)),   A = ∂u/∂(a, b, c, d)
 * </pre>
 *
 * <p>Straw et al. (2011, documentation of the orientation filter) print ḋ with the opposite sign
 * before c r, which does not preserve the length.
 */
final class BodyQuaternion {
  private BodyQuaternion() {}

  /** Sets the quaternion of the shortest rotation that takes (1, 0, 0) to a unit vector. */
  static void set(double[] x, double[] u) {
    boolean isOpposite = u[0] < -0.5; // then via (−1, 0, 0), half a turn about z
    double side = isOpposite ? -1 : 1;
    double n = Math.sqrt(2 * (1 + side * u[0]));
    double[] turn = {0, -side * u[2] / n, side * u[1] / n, 0.5 * n};
    x[3] = isOpposite ? turn[1] : 0;
    x[4] = isOpposite ? 0 : turn[1];
    x[5] = isOpposite ? turn[3] : turn[2];
    x[6] = isOpposite ? -turn[2] : turn[3];
  }

  /** Ξ, which maps body rates to twice the quaternion's change. */
  static DMatrixRMaj byRates(double[] x) {
    double a = x[3];
    double b = x[4];
    double c = x[5];
    double d = x[6];
    return new DMatrixRMaj(4, 3, true, d, -c, b, c, d, -a, -b, a, d, -a, -b, -c);
  }

  /** Ω, which maps the quaternion to twice its change. */
  static DMatrixRMaj byQuaternion(double[] x) {
    double p = x[0];
    double q = x[1];
    double r = x[2];
    return new DMatrixRMaj(4, 4, true, 0, r, -q, p, -r, 0, p, q, q, -p, 0, r, -p, -q, -r, 0);
  }

  /** A, the derivative of the axis by the quaternion. */
  static DMatrixRMaj axisByQuaternion(double[] x) {
    double a = 2 * x[3];
    double b = 2 * x[4];
    double c = 2 * x[5];
    double d = 2 * x[6];
    return new DMatrixRMaj(3, 4, true, a, -b, -c, d, b, a, d, c, c, -d, a, -b);
  }

  /** The derivative of the class comment. */
  static double[] derivative(double[] x, double tau) {
    double[] change = product(byRates(x), x, 0);
    double n = 2 * Math.sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]);
    double[] out = new double[7];
    for (int i = 0; i < 7; i++) {
      out[i] = i < 3 ? -x[i] / tau : change[i - 3] / n;
    }
    return out;
  }

  /** The axis, a unit vector. */
  static void axis(double[] x, double[] out) {
    System.arraycopy(product(axisByQuaternion(x), x, 3), 0, out, 0, 3);
    Vectors.normalise(out);
  }

  /** Velocity of the axis' tip, per second: A ½ Ξ ω. */
  static void tipVelocity(double[] x, double[] out) {
    double[] change = product(byRates(x), x, 0);
    double[] tip = product(axisByQuaternion(x), change, 0);
    for (int i = 0; i < 3; i++) {
      out[i] = 0.5 * tip[i];
    }
  }

  /** A matrix times the entries of a vector from one on. */
  private static double[] product(DMatrixRMaj m, double[] vector, int from) {
    DMatrixRMaj part = new DMatrixRMaj(m.numCols, 1);
    System.arraycopy(vector, from, part.data, 0, m.numCols);
    DMatrixRMaj out = new DMatrixRMaj(m.numRows, 1);
    CommonOps_DDRM.mult(m, part, out);
    return out.data;
  }
}
