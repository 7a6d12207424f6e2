package haltere.filters.orientation;

import haltere.filters.estimation.GaussianState;

/**
 * A line beside what a hypothesis of the axis expects of it: innovation, gradient, and both
 * variances, to the second order (Bar-Shalom, Li and Kirubarajan 2001, section 10.3.2). With the
 * line's picture z = vx + i vy and w = ∂z/z, the angle's first derivatives are Im w and its second
 * ones −Im w wᵀ. Reused.
 */
final class LineComparison {
  /** Least squared length of the axis in the picture; below, it is seen end-on. */
  private static final double END_ON = 1e-12;

  /** Variance that is expected over that of the line, up to which it tells of its own. */
  private static final double TELLING = 2;

  /** Noise with the second-order terms over that without, up to which it does. */
  private static final double LINEAR = 1.1;

  /** Largest normalised innovation squared that counts. */
  private static final double MOST_NIS = 9;

  double innovation;
  double ha;
  double hb;

  /** Variance of the line, with the second-order terms. */
  double noise;

  /** Variance of what is expected. */
  double spread;

  private double lineVariance;

  /**
   * Compares.
   *
   * @return false where the body is seen end-on
   */
  boolean compare(AxisHypothesis hypothesis, LineMeasurement line) {
    GaussianState error = hypothesis.error;
    double[] u = hypothesis.u;
    double[] e1 = hypothesis.e1;
    double[] e2 = hypothesis.e2;
    double a = error.mean(0);
    double b = error.mean(2);
    double[] n = line.n;
    double x1 = n[0] * e1[0] + n[1] * e1[1] + n[2] * e1[2];
    double y1 = n[3] * e1[0] + n[4] * e1[1] + n[5] * e1[2];
    double x2 = n[0] * e2[0] + n[1] * e2[1] + n[2] * e2[2];
    double y2 = n[3] * e2[0] + n[4] * e2[1] + n[5] * e2[2];
    double vx = n[0] * u[0] + n[1] * u[1] + n[2] * u[2] + a * x1 + b * x2;
    double vy = n[3] * u[0] + n[4] * u[1] + n[5] * u[2] + a * y1 + b * y2;
    double squares = vx * vx + vy * vy;
    if (!(squares > END_ON)) {
      return false;
    }
    double ra = (vx * x1 + vy * y1) / squares;
    double rb = (vx * x2 + vy * y2) / squares;
    ha = (vx * y1 - vy * x1) / squares;
    hb = (vx * y2 - vy * x2) / squares;
    double p00 = error.covariance(0, 0);
    double p02 = error.covariance(0, 2);
    double p22 = error.covariance(2, 2);
    spread = ha * ha * p00 + 2 * ha * hb * p02 + hb * hb * p22;
    double saa = -2 * ra * ha;
    double sab = -ra * hb - rb * ha;
    double sbb = -2 * rb * hb;
    double m00 = saa * p00 + sab * p02;
    double m01 = saa * p02 + sab * p22;
    double m10 = sab * p00 + sbb * p02;
    double m11 = sab * p02 + sbb * p22;
    innovation = line.residual(vx, vy) - 0.5 * (m00 + m11);
    lineVariance = line.varianceRad2;
    noise = lineVariance + 0.5 * (m00 * m00 + 2 * m01 * m10 + m11 * m11);
    return true;
  }

  /** Variance of the innovation. */
  double variance() {
    return spread + noise;
  }

  /** Normalised innovation squared. */
  double nis() {
    return innovation * innovation / (spread + noise);
  }

  /** By how much the expected line is vague, beyond the noise of lines. */
  double vagueness() {
    return spread + noise - lineVariance;
  }

  /** What the line says of its own variance, on average; NaN where it says nothing. */
  double own() {
    boolean tells = spread < TELLING * lineVariance && noise < LINEAR * lineVariance;
    return tells ? Math.min(innovation * innovation, MOST_NIS * variance()) - spread : Double.NaN;
  }
}
