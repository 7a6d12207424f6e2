package haltere.filters.orientation.internal.axis;

import haltere.filters.estimation.GaussianState;
import haltere.filters.orientation.camera.Vectors;
import org.ejml.data.DMatrixRMaj;

/**
 * Difference of two hypotheses of an axis: difference of the states, and parallel transport of a
 * covariance along the great circle into the frame of the first one. Reused.
 */
final class AxisDifference {
  /** Cosine of an angle so near to 180 degrees that any great circle leads there. */
  private static final double OPPOSITE = -1 + 1e-9;

  /** (a, ȧ, b, ḃ) of the second one in the first one's frame, minus the first one's. */
  final double[] d = new double[4];

  private AxisHypothesis first;
  private AxisHypothesis second;
  private final DMatrixRMaj carry = new DMatrixRMaj(4, 4);
  private final GaussianState[] pair = {new GaussianState(4), new GaussianState(4)};
  private final double[] weights = new double[2];

  /** Sets the difference between an axis, or its opposite with the side −1, and another axis. */
  void between(AxisHypothesis from, AxisHypothesis to, double side) {
    first = from;
    second = to;
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
    double va = to.error.mean(1);
    double vb = to.error.mean(3);
    d[0] = scale * a;
    d[1] = side * (m00 * va + m01 * vb) - from.error.mean(1);
    d[2] = scale * b;
    d[3] = side * (m10 * va + m11 * vb) - from.error.mean(3);
    for (int rate = 0; rate < 2; rate++) {
      carry.set(rate, rate, m00);
      carry.set(rate, 2 + rate, m01);
      carry.set(2 + rate, rate, m10);
      carry.set(2 + rate, 2 + rate, m11);
    }
  }

  /** Gets the Gaussian of the second hypothesis in the frame of the first one. */
  void carry(GaussianState into) {
    into.set(second.error);
    into.transform(carry);
    for (int i = 0; i < 4; i++) {
      into.setMean(i, first.error.mean(i) + d[i]);
    }
  }

  /** Merges the second hypothesis, with a share of the weight, into the first one. */
  void merge(double share) {
    pair[0].set(first.error);
    carry(pair[1]);
    weights[0] = 1 - share;
    weights[1] = share;
    first.error.mix(pair, weights);
    first.recentre(false);
  }
}
