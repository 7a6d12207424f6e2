package haltere.filters.track;

import java.util.Arrays;

/**
 * An extended Kalman filter of a point in a plane that goes straight or on a circle: state (x, y,
 * vx, vy, ω), with ω the rate at which the velocity turns. Written out on arrays; allocates nothing
 * after its construction.
 *
 * <p>Evolution: the coordinated turn (Bar-Shalom, Li and Kirubarajan 2001, section 11.7.1),
 *
 * <pre>
 *   x ← x + (sin ωΔt / ω) vx − ((1 − cos ωΔt) / ω) vy
 *   y ← y + ((1 − cos ωΔt) / ω) vx + (sin ωΔt / ω) vy
 *   v ← turned by ωΔt
 * </pre>
 *
 * <p>and, where ω is 0 and stays 0, constant velocity. The process noise is white acceleration of a
 * density per axis, integrated over Δt, and a random walk of ω. The update is Joseph's form.
 *
 * <p>Units are those of the plane: pixels or metres, with seconds and radians. Thread rule: not
 * safe for use by two threads at a time.
 */
final class PlaneFilter {
  static final int STATES = 5;

  private static final double SMALL_ANGLE = 1e-4;
  private static final double LOG_TWO_PI = Math.log(2 * Math.PI);

  /** State. */
  final double[] x = new double[STATES];

  /** Covariance, all 25 entries, symmetric. */
  final double[] p = new double[STATES * STATES];

  private final double[] gain = new double[STATES * 2];
  private double yX;
  private double yY;
  private double sXx;
  private double sXy;
  private double sYy;
  private double rXx;
  private double rXy;
  private double rYy;
  private double nis = Double.NaN;
  private double logLikelihood = Double.NaN;

  /** Begins with a place of known uncertainty, a velocity of 0 that is unknown, and a turn rate. */
  void launch(
      double atX, double atY, double xx, double xy, double yy, double velocity, double turnRate) {
    Arrays.fill(x, 0);
    Arrays.fill(p, 0);
    x[0] = atX;
    x[1] = atY;
    p[0] = xx;
    p[1] = xy;
    p[STATES] = xy;
    p[STATES + 1] = yy;
    p[12] = velocity;
    p[18] = velocity;
    p[24] = turnRate;
  }

  void copyFrom(PlaneFilter other) {
    System.arraycopy(other.x, 0, x, 0, STATES);
    System.arraycopy(other.p, 0, p, 0, STATES * STATES);
  }

  /** Evolves without noise; with a turn rate that is known to be 0, in a straight line. */
  void evolve(double dtS) {
    double w = x[4];
    if (w == 0 && p[24] == 0) {
      x[0] += dtS * x[2];
      x[1] += dtS * x[3];
      transform(dtS, 0, 1, 0, 0, 0, 0, 0);
      return;
    }
    double angle = w * dtS;
    double sin = Math.sin(angle);
    double cos = Math.cos(angle);
    double a;
    double b;
    double aByW;
    double bByW;
    if (Math.abs(angle) < SMALL_ANGLE) {
      // Series in ωΔt of sin(ωΔt)/ω, (1 − cos ωΔt)/ω and their derivatives by ω.
      a = dtS * (1 - angle * angle / 6);
      b = dtS * angle / 2;
      aByW = -dtS * dtS * angle / 3;
      bByW = dtS * dtS / 2;
    } else {
      a = sin / w;
      b = (1 - cos) / w;
      aByW = (dtS * cos - a) / w;
      bByW = (dtS * sin - b) / w;
    }
    double vx = x[2];
    double vy = x[3];
    x[0] += a * vx - b * vy;
    x[1] += b * vx + a * vy;
    x[2] = cos * vx - sin * vy;
    x[3] = sin * vx + cos * vy;
    transform(
        a, b, cos, sin, aByW * vx - bByW * vy, bByW * vx + aByW * vy, -dtS * x[3], dtS * x[2]);
  }

  /** P ← F P Fᵀ with F = [1 0 a −b e; 0 1 b a f; 0 0 c −s g; 0 0 s c h; 0 0 0 0 1], rows first. */
  private void transform(
      double a, double b, double c, double s, double e, double f, double g, double h) {
    for (int j = 0; j < STATES; j++) {
      double p2 = p[10 + j];
      double p3 = p[15 + j];
      double p4 = p[20 + j];
      p[j] += a * p2 - b * p3 + e * p4;
      p[5 + j] += b * p2 + a * p3 + f * p4;
      p[10 + j] = c * p2 - s * p3 + g * p4;
      p[15 + j] = s * p2 + c * p3 + h * p4;
    }
    for (int i = 0; i < STATES * STATES; i += STATES) {
      double p2 = p[i + 2];
      double p3 = p[i + 3];
      double p4 = p[i + 4];
      p[i] += a * p2 - b * p3 + e * p4;
      p[i + 1] += b * p2 + a * p3 + f * p4;
      p[i + 2] = c * p2 - s * p3 + g * p4;
      p[i + 3] = s * p2 + c * p3 + h * p4;
    }
    symmetrise();
  }

  /** Adds what white acceleration and a random walk of the turn rate do in a time. */
  void addNoise(double dtS, double acceleration, double turn) {
    double q = acceleration * dtS;
    double half = q * dtS / 2;
    double third = q * dtS * dtS / 3;
    p[0] += third;
    p[6] += third;
    p[2] += half;
    p[10] += half;
    p[8] += half;
    p[16] += half;
    p[12] += q;
    p[18] += q;
    p[24] += turn * dtS;
  }

  /** Adds the same variance to place and velocity, the original's noise of each step. */
  void addStepNoise(double variance) {
    p[0] += variance;
    p[6] += variance;
    p[12] += variance;
    p[18] += variance;
  }

  /**
   * Compares a measured place with the prediction.
   *
   * @return false, and nothing is usable, if the numbers are not
   */
  boolean innovate(double zX, double zY, double xx, double xy, double yy) {
    rXx = xx;
    rXy = xy;
    rYy = yy;
    yX = zX - x[0];
    yY = zY - x[1];
    sXx = p[0] + xx;
    sXy = p[1] + xy;
    sYy = p[6] + yy;
    double determinant = sXx * sYy - sXy * sXy;
    nis = (sYy * yX * yX - 2 * sXy * yX * yY + sXx * yY * yY) / determinant;
    logLikelihood = -0.5 * (nis + Math.log(determinant)) - LOG_TWO_PI;
    return sXx > 0 && determinant > 0 && nis >= 0 && logLikelihood > Double.NEGATIVE_INFINITY;
  }

  /** Takes in what {@link #innovate} has compared. */
  void correct() {
    double inverse = 1 / (sXx * sYy - sXy * sXy);
    double iXx = sYy * inverse;
    double iXy = -sXy * inverse;
    double iYy = sXx * inverse;
    for (int i = 0; i < STATES; i++) {
      double a = p[5 * i];
      double b = p[5 * i + 1];
      double k = a * iXx + b * iXy;
      double l = a * iXy + b * iYy;
      gain[2 * i] = k;
      gain[2 * i + 1] = l;
      x[i] += k * yX + l * yY;
    }
    // A = (I − K H) P, then P = A (I − K H)ᵀ + K R Kᵀ
    for (int j = 0; j < STATES; j++) {
      double a = p[j];
      double b = p[5 + j];
      for (int i = 0; i < STATES; i++) {
        p[5 * i + j] -= gain[2 * i] * a + gain[2 * i + 1] * b;
      }
    }
    for (int i = 0; i < STATES; i++) {
      double k = gain[2 * i];
      double l = gain[2 * i + 1];
      double u = k * rXx + l * rXy - p[5 * i];
      double v = k * rXy + l * rYy - p[5 * i + 1];
      for (int j = 0; j < STATES; j++) {
        p[5 * i + j] += u * gain[2 * j] + v * gain[2 * j + 1];
      }
    }
    symmetrise();
  }

  private void symmetrise() {
    for (int i = 0; i < STATES; i++) {
      for (int j = i + 1; j < STATES; j++) {
        double mean = 0.5 * (p[5 * i + j] + p[5 * j + i]);
        p[5 * i + j] = mean;
        p[5 * j + i] = mean;
      }
    }
  }

  double nis() {
    return nis;
  }

  double logLikelihood() {
    return logLikelihood;
  }

  double innovationX() {
    return yX;
  }

  double innovationY() {
    return yY;
  }

  double innovationXx() {
    return sXx;
  }

  double innovationXy() {
    return sXy;
  }

  double innovationYy() {
    return sYy;
  }

  /** Entry of the last gain: row 0 to 4, column 0 for x and 1 for y. */
  double gain(int row, int column) {
    return gain[2 * row + column];
  }
}
