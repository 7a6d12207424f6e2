package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/**
 * Body rates p, q, r and a quaternion (a, b, c, d), d its scalar part, in an array of seven, and
 * what follows from them.
 *
 * <pre>
 * ṗ = −p/τ    q̇ = −q/τ    ṙ = −r/τ
 * ȧ = ( d p + b r − c q) / 2n      ḃ = ( d q + c p − a r) / 2n
 * ċ = ( d r + a q − b p) / 2n      ḋ = −(a p + b q + c r) / 2n,   n = |(a, b, c, d)|
 * u = (a² + d² − b² − c², 2(ab + cd), 2(ac − bd))
 * </pre>
 *
 * <p>The last derivative has the opposite sign before c r in the source, in print and in its code,
 * with which the length is not kept (Straw et al. 2011, documentation of the orientation filter).
 */
final class BodyQuaternion {
  private BodyQuaternion() {}

  /** The quaternion of a rotation whose columns are given (Shepperd 1978). */
  static void set(double[] x, double[] c0, double[] c1, double[] c2) {
    double trace = c0[0] + c1[1] + c2[2];
    double[] squares = {
      1 + 2 * c0[0] - trace, 1 + 2 * c1[1] - trace, 1 + 2 * c2[2] - trace, 1 + trace
    };
    int largest = 0;
    for (int i = 1; i < 4; i++) {
      largest = squares[i] > squares[largest] ? i : largest;
    }
    double a;
    double b;
    double c;
    double d;
    switch (largest) {
      case 0 -> {
        a = squares[0];
        b = c1[0] + c0[1];
        c = c2[0] + c0[2];
        d = c1[2] - c2[1];
      }
      case 1 -> {
        a = c1[0] + c0[1];
        b = squares[1];
        c = c1[2] + c2[1];
        d = c2[0] - c0[2];
      }
      case 2 -> {
        a = c2[0] + c0[2];
        b = c1[2] + c2[1];
        c = squares[2];
        d = c0[1] - c1[0];
      }
      default -> {
        a = c1[2] - c2[1];
        b = c2[0] - c0[2];
        c = c0[1] - c1[0];
        d = squares[3];
      }
    }
    double n = Math.sqrt(a * a + b * b + c * c + d * d);
    x[3] = a / n;
    x[4] = b / n;
    x[5] = c / n;
    x[6] = d / n;
  }

  /**
   * Entry of the 4 x 3 matrix that takes a small body rotation to twice the quaternion's change.
   */
  static double byRotation(double[] x, int row, int column) {
    double a = x[3];
    double b = x[4];
    double c = x[5];
    double d = x[6];
    return switch (3 * row + column) {
      case 0, 4, 8 -> d;
      case 1 -> -c;
      case 2 -> b;
      case 3 -> c;
      case 5 -> -a;
      case 6 -> -b;
      case 7 -> a;
      case 9 -> -a;
      case 10 -> -b;
      default -> -c;
    };
  }

  /** The derivative of the class comment into an array. */
  static void derivative(double[] x, double tau, double[] out) {
    double n = 2 * Math.sqrt(x[3] * x[3] + x[4] * x[4] + x[5] * x[5] + x[6] * x[6]);
    out[0] = -x[0] / tau;
    out[1] = -x[1] / tau;
    out[2] = -x[2] / tau;
    out[3] = (x[6] * x[0] + x[4] * x[2] - x[5] * x[1]) / n;
    out[4] = (x[6] * x[1] + x[5] * x[0] - x[3] * x[2]) / n;
    out[5] = (x[6] * x[2] + x[3] * x[1] - x[4] * x[0]) / n;
    out[6] = -(x[3] * x[0] + x[4] * x[1] + x[5] * x[2]) / n;
  }

  /** Entry of the 4 x 4 matrix of rates that a quaternion is multiplied by. */
  static double byRates(double[] x, int row, int column) {
    double wp = x[0];
    double wq = x[1];
    double wr = x[2];
    return switch (4 * row + column) {
      case 1, 11 -> wr;
      case 2 -> -wq;
      case 3 -> wp;
      case 4 -> -wr;
      case 6 -> wp;
      case 7 -> wq;
      case 8 -> wq;
      case 9 -> -wp;
      case 12 -> -wp;
      case 13 -> -wq;
      case 14 -> -wr;
      default -> 0;
    };
  }

  /** ∂u/∂(a, b, c, d), of a state. */
  static double axisByQuaternion(double[] state, int row, int column) {
    double a = 2 * state[3];
    double b = 2 * state[4];
    double c = 2 * state[5];
    double d = 2 * state[6];
    return switch (4 * row + column) {
      case 0 -> a;
      case 1 -> -b;
      case 2 -> -c;
      case 3 -> d;
      case 4 -> b;
      case 5 -> a;
      case 6 -> d;
      case 7 -> c;
      case 8 -> c;
      case 9 -> -d;
      case 10 -> a;
      default -> -b;
    };
  }

  /** The axis, a unit vector. */
  static void axis(double[] state, double[] out) {
    double a = state[3];
    double b = state[4];
    double c = state[5];
    double d = state[6];
    out[0] = a * a + d * d - b * b - c * c;
    out[1] = 2 * (a * b + c * d);
    out[2] = 2 * (a * c - b * d);
    Vectors.normalise(out);
  }

  /** Velocity of the axis' tip, per second. */
  static void tipVelocity(double[] x, double[] out) {
    double a = x[3];
    double b = x[4];
    double c = x[5];
    double d = x[6];
    double q = x[1];
    double r = x[2];
    out[0] = r * 2 * (a * b - c * d) - q * 2 * (a * c + b * d);
    out[1] = r * (b * b + d * d - a * a - c * c) - q * 2 * (b * c - a * d);
    out[2] = r * 2 * (b * c + a * d) - q * (c * c + d * d - a * a - b * b);
  }
}
