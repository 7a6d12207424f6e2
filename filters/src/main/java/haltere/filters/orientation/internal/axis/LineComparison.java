package haltere.filters.orientation.internal.axis;

import haltere.filters.estimation.GaussianState;

/**
 * A line compared with the one that a hypothesis of the axis expects: innovation, gradient, and
 * both variances, to the second order (Bar-Shalom, Li and Kirubarajan 2001, section 10.3.2). With
 * the line's picture z = vx + i vy and w = ∂z/z, the angle's first derivatives are Im w and its
 * second ones −Im w wᵀ. Reused.
 */
final class LineComparison {
  /** Squared length of the axis in the picture below which it points to the camera. */
  private static final double END_ON = 1e-12;

  /** Largest ratio of the variance of the expected line to that of the line for its estimation. */
  private static final double MAX_SPREAD = 2;

  /** Largest ratio of the noise with second-order terms to that without for its estimation. */
  private static final double MAX_NONLINEARITY = 1.1;

  /** Largest normalised innovation squared that counts. */
  private static final double MAX_NIS = 9;

  double innovation;
  double ha;
  double hb;

  /** Variance of the line, with the second-order terms. */
  double noise;

  /** Variance of the expected line. */
  double spread;

  private double lineVariance;

  /** Compares; false for an axis towards the camera. */
  boolean compare(AxisHypothesis hypothesis, LineMeasurement line) {
    GaussianState error = hypothesis.error;
    double a = error.mean(0);
    double b = error.mean(2);
    double x1 = line.vx(hypothesis.e1);
    double y1 = line.vy(hypothesis.e1);
    double x2 = line.vx(hypothesis.e2);
    double y2 = line.vy(hypothesis.e2);
    double vx = line.vx(hypothesis.u) + a * x1 + b * x2;
    double vy = line.vy(hypothesis.u) + a * y1 + b * y2;
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

  double nis() {
    return innovation * innovation / (spread + noise);
  }

  /** Variance of the innovation beyond that of the line. */
  double expectedVariance() {
    return spread + noise - lineVariance;
  }

  /** Estimate of the variance of the line; NaN if the innovation does not determine it. */
  double own() {
    boolean isLearnt =
        spread < MAX_SPREAD * lineVariance && noise < MAX_NONLINEARITY * lineVariance;
    return isLearnt ? Math.min(innovation * innovation, MAX_NIS * variance()) - spread : Double.NaN;
  }
}
