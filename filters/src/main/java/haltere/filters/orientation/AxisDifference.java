package haltere.filters.orientation;

import haltere.filters.orientation.camera.Vectors;

/**
 * How one guess of an axis differs from another: the difference of the states and the covariance,
 * carried along the great circle between them into the other's frame. Reused.
 */
final class AxisDifference {
  /** Cosine of an angle so near to 180 degrees that any great circle leads there. */
  private static final double OPPOSITE = -1 + 1e-9;

  /** (a, ȧ, b, ḃ) in the other's frame. */
  final double[] d = new double[4];

  /** Covariance in the other's frame. */
  final double[] p = new double[16];

  private final double[] own = new double[16];
  private final double[] half = new double[16];
  private final double[] carry = new double[16];

  /** Works out the difference of two lines, whichever ends are heads. */
  void betweenLines(AxisHypothesis from, AxisHypothesis to) {
    between(from, to, Vectors.dot(from.u, to.u) < 0 ? -1 : 1);
  }

  /** Works out the difference of two axes with a head, which may be any angle apart. */
  void betweenHeads(AxisHypothesis from, AxisHypothesis to) {
    between(from, to, 1);
  }

  /** The covariance is left for {@link #carryCovariance}. */
  private void between(AxisHypothesis from, AxisHypothesis to, double side) {
    double[] u = from.u;
    double cos = Math.max(OPPOSITE, Math.min(1, side * Vectors.dot(u, to.u)));
    double a = side * Vectors.dot(to.u, from.e1);
    double b = side * Vectors.dot(to.u, from.e2);
    double sin = Math.sqrt(a * a + b * b);
    double scale = sin < 1e-7 ? 1 : Math.atan2(sin, cos) / sin;
    // A tangent x at u' becomes x − (u·x) (u + u') / (1 + u·u'); the part along u drops out.
    double along1 = Vectors.dot(u, to.e1) / (1 + cos);
    double along2 = Vectors.dot(u, to.e2) / (1 + cos);
    double m00 = Vectors.dot(to.e1, from.e1) - along1 * a;
    double m10 = Vectors.dot(to.e1, from.e2) - along1 * b;
    double m01 = Vectors.dot(to.e2, from.e1) - along2 * a;
    double m11 = Vectors.dot(to.e2, from.e2) - along2 * b;
    d[0] = scale * a;
    d[1] = side * (m00 * to.va + m01 * to.vb) - from.va;
    d[2] = scale * b;
    d[3] = side * (m10 * to.va + m11 * to.vb) - from.vb;
    carry[0] = m00;
    carry[2] = m01;
    carry[5] = m00;
    carry[7] = m01;
    carry[8] = m10;
    carry[10] = m11;
    carry[13] = m10;
    carry[15] = m11;
  }

  /** Carries the covariance of the guess that was given second. */
  void carryCovariance(AxisHypothesis to) {
    to.covariance(own);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
          sum += carry[4 * i + k] * own[4 * k + j];
        }
        half[4 * i + j] = sum;
      }
    }
    for (int i = 0; i < 4; i++) {
      for (int j = i; j < 4; j++) {
        double sum = 0;
        for (int k = 0; k < 4; k++) {
          sum += half[4 * i + k] * carry[4 * j + k];
        }
        p[4 * i + j] = sum;
        p[4 * j + i] = sum;
      }
    }
  }
}
