package haltere.filters.track.motion;

import haltere.filters.estimation.SineCosine;
import java.util.Arrays;

/**
 * An extended Kalman filter of a point in a plane that goes straight or on a circle: state (x, y,
 * vx, vy, ω), with ω the rate at which the velocity turns. Written out; allocates nothing after its
 * construction.
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
 * density per axis, integrated over Δt, and a random walk of ω.
 *
 * <p>Update: since P Hᵀ = K S, (I − K H) P Hᵀ = K (S − H P Hᵀ) = K R. So all that has to do with
 * the place is a product, in which nothing cancels, and only among velocities and ω something is
 * subtracted. It is a quarter of the arithmetic of Joseph's form.
 *
 * <p>Of the covariance the upper triangle is kept, so it is symmetric by construction; first the
 * entries of place and velocity, then those of ω, which are 0 and are left alone as long as ω is
 * known to be 0.
 *
 * <p>Units are those of the plane: pixels or metres, with seconds and radians. Thread rule: not
 * safe for use by two threads at a time.
 */
final class PlaneFilter {
  static final int STATES = 5;

  /** Entries of the upper triangle. */
  static final int ENTRIES = 15;

  /** The first entry of what is known of ω. */
  private static final int TURN_ENTRIES = 10;

  private static final int[] PLACE = {
    0, 1, 2, 3, 10,
    1, 4, 5, 6, 11,
    2, 5, 7, 8, 12,
    3, 6, 8, 9, 13,
    10, 11, 12, 13, 14
  };

  private static final double SMALL_ANGLE = 1e-4;
  private static final double LOG_TWO_PI = Math.log(2 * Math.PI);

  /** State. */
  final double[] x = new double[STATES];

  /** Covariance: entries 00 01 02 03 11 12 13 22 23 33, then 04 14 24 34 44. */
  final double[] p = new double[ENTRIES];

  private final SineCosine turned = new SineCosine();
  private final double[] gain = new double[STATES * 2];
  private double yX;
  private double yY;
  private double sXx;
  private double sXy;
  private double sYy;
  private double rXx;
  private double rXy;
  private double rYy;

  /** One over the determinant of the covariance of the innovation. */
  private double perDeterminant = Double.NaN;

  private double nis = Double.NaN;

  /** Where an entry of a covariance is among those that are kept. */
  static int place(int row, int column) {
    return PLACE[STATES * row + column];
  }

  /** Begins with a place of known uncertainty, a velocity of 0 that is unknown, and a turn rate. */
  void launch(
      double atX, double atY, double xx, double xy, double yy, double velocity, double turnRate) {
    Arrays.fill(x, 0);
    Arrays.fill(p, 0);
    x[0] = atX;
    x[1] = atY;
    p[0] = xx;
    p[1] = xy;
    p[4] = yy;
    p[7] = velocity;
    p[9] = velocity;
    p[14] = turnRate;
  }

  /** Sets what is known of the second velocity. */
  void setAlong(double velocity, double covarianceYvy, double variance) {
    x[3] = velocity;
    p[6] = covarianceYvy;
    p[9] = variance;
  }

  /** Moves the second coordinate. */
  void shift(double byY, double variance) {
    x[1] += byY;
    p[4] += variance;
  }

  void copyFrom(PlaneFilter other) {
    System.arraycopy(other.x, 0, x, 0, STATES);
    System.arraycopy(other.p, 0, p, 0, ENTRIES);
  }

  double covariance(int row, int column) {
    return p[place(row, column)];
  }

  private boolean turns() {
    return x[4] != 0 || p[14] != 0;
  }

  /** Evolves without noise; with a turn rate that is known to be 0, in a straight line. */
  void evolve(double dtS) {
    evolveFrom(this, dtS);
  }

  /** Becomes what another one, which stays as it is, evolves to. */
  void evolveFrom(PlaneFilter other, double dtS) {
    if (other.turns()) {
      turn(other.x, other.p, dtS);
    } else {
      x[4] = 0;
      Arrays.fill(p, TURN_ENTRIES, ENTRIES, 0);
      goStraight(other.x, other.p, dtS);
    }
  }

  /** Evolves place and velocity in a straight line; what is known of ω stays. */
  void goStraight(double dtS) {
    goStraight(x, p, dtS);
  }

  private void goStraight(double[] fromX, double[] fromP, double dtS) {
    double vx = fromX[2];
    double vy = fromX[3];
    x[0] = fromX[0] + dtS * vx;
    x[1] = fromX[1] + dtS * vy;
    x[2] = vx;
    x[3] = vy;
    double p22 = fromP[7];
    double p23 = fromP[8];
    double p33 = fromP[9];
    double p02 = fromP[2] + dtS * p22;
    double p03 = fromP[3] + dtS * p23;
    double p12 = fromP[5] + dtS * p23;
    double p13 = fromP[6] + dtS * p33;
    p[0] = fromP[0] + dtS * (fromP[2] + p02);
    p[1] = fromP[1] + dtS * (fromP[5] + p03);
    p[4] = fromP[4] + dtS * (fromP[6] + p13);
    p[2] = p02;
    p[3] = p03;
    p[5] = p12;
    p[6] = p13;
    p[7] = p22;
    p[8] = p23;
    p[9] = p33;
  }

  private void turn(double[] fromX, double[] fromP, double dtS) {
    double w = fromX[4];
    double angle = w * dtS;
    turned.of(angle);
    double sin = turned.sine();
    double cos = turned.cosine();
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
      double perW = 1 / w;
      a = sin * perW;
      b = (1 - cos) * perW;
      aByW = (dtS * cos - a) * perW;
      bByW = (dtS * sin - b) * perW;
    }
    double vx = fromX[2];
    double vy = fromX[3];
    x[0] = fromX[0] + a * vx - b * vy;
    x[1] = fromX[1] + b * vx + a * vy;
    x[2] = cos * vx - sin * vy;
    x[3] = sin * vx + cos * vy;
    x[4] = w;
    transform(
        fromP,
        a,
        b,
        cos,
        sin,
        aByW * vx - bByW * vy,
        bByW * vx + aByW * vy,
        -dtS * x[3],
        dtS * x[2]);
  }

  /** P ← F P Fᵀ with F = [1 0 a −b e; 0 1 b a f; 0 0 c −s g; 0 0 s c h; 0 0 0 0 1]. */
  private void transform(
      double[] from,
      double a,
      double b,
      double c,
      double s,
      double e,
      double f,
      double g,
      double h) {
    double p04 = from[10];
    double p14 = from[11];
    double p24 = from[12];
    double p34 = from[13];
    double p44 = from[14];
    // M = F P, as far as it is needed.
    double m00 = from[0] + a * from[2] - b * from[3] + e * p04;
    double m01 = from[1] + a * from[5] - b * from[6] + e * p14;
    double m02 = from[2] + a * from[7] - b * from[8] + e * p24;
    double m03 = from[3] + a * from[8] - b * from[9] + e * p34;
    double m04 = p04 + a * p24 - b * p34 + e * p44;
    double m11 = from[4] + b * from[5] + a * from[6] + f * p14;
    double m12 = from[5] + b * from[7] + a * from[8] + f * p24;
    double m13 = from[6] + b * from[8] + a * from[9] + f * p34;
    double m14 = p14 + b * p24 + a * p34 + f * p44;
    double m22 = c * from[7] - s * from[8] + g * p24;
    double m23 = c * from[8] - s * from[9] + g * p34;
    double m24 = c * p24 - s * p34 + g * p44;
    double m32 = s * from[7] + c * from[8] + h * p24;
    double m33 = s * from[8] + c * from[9] + h * p34;
    double m34 = s * p24 + c * p34 + h * p44;
    p[0] = m00 + a * m02 - b * m03 + e * m04;
    p[1] = m01 + b * m02 + a * m03 + f * m04;
    p[2] = c * m02 - s * m03 + g * m04;
    p[3] = s * m02 + c * m03 + h * m04;
    p[4] = m11 + b * m12 + a * m13 + f * m14;
    p[5] = c * m12 - s * m13 + g * m14;
    p[6] = s * m12 + c * m13 + h * m14;
    p[7] = c * m22 - s * m23 + g * m24;
    p[8] = s * m22 + c * m23 + h * m24;
    p[9] = s * m32 + c * m33 + h * m34;
    p[10] = m04;
    p[11] = m14;
    p[12] = m24;
    p[13] = m34;
    p[14] = p44;
  }

  /** Adds what white acceleration and a random walk of the turn rate do in a time. */
  void addNoise(double dtS, double acceleration, double turn) {
    double q = acceleration * dtS;
    double half = q * dtS / 2;
    double third = q * dtS * dtS / 3;
    p[0] += third;
    p[4] += third;
    p[2] += half;
    p[6] += half;
    p[7] += q;
    p[9] += q;
    p[14] += turn * dtS;
  }

  /** Adds the same variance to place and velocity, the original's noise of each step. */
  void addStepNoise(double variance) {
    p[0] += variance;
    p[4] += variance;
    p[7] += variance;
    p[9] += variance;
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
    sYy = p[4] + yy;
    double determinant = sXx * sYy - sXy * sXy;
    perDeterminant = 1 / determinant;
    nis = (sYy * yX * yX - 2 * sXy * yX * yY + sXx * yY * yY) * perDeterminant;
    return sXx > 0
        && determinant > 0
        && determinant < Double.POSITIVE_INFINITY
        && nis >= 0
        && nis < Double.POSITIVE_INFINITY;
  }

  /** Takes in what {@link #innovate} has compared. */
  void correct() {
    double iXx = sYy * perDeterminant;
    double iXy = -sXy * perDeterminant;
    double iYy = sXx * perDeterminant;
    boolean turns = turns();
    setGain(0, p[0], p[1], iXx, iXy, iYy);
    setGain(1, p[1], p[4], iXx, iXy, iYy);
    setGain(2, p[2], p[5], iXx, iXy, iYy);
    setGain(3, p[3], p[6], iXx, iXy, iYy);
    setGain(4, turns ? p[10] : 0, turns ? p[11] : 0, iXx, iXy, iYy);
    if (turns) {
      correctTurnRate();
    }
    correctVelocity();
    correctPlace();
  }

  /** Takes in a measured second velocity. */
  void correctAlong(double velocity, double variance) {
    double s = p[9] + variance;
    double off = (velocity - x[3]) / s;
    for (int i = 0; i < STATES; i++) {
      gain[i] = covariance(i, 3);
      x[i] += gain[i] * off;
    }
    for (int i = 0; i < STATES; i++) {
      for (int j = i; j < STATES; j++) {
        p[place(i, j)] -= gain[i] * gain[j] / s;
      }
    }
  }

  private void setGain(int row, double toX, double toY, double iXx, double iXy, double iYy) {
    double k = toX * iXx + toY * iXy;
    double l = toX * iXy + toY * iYy;
    gain[2 * row] = k;
    gain[2 * row + 1] = l;
    x[row] += k * yX + l * yY;
  }

  /** What is known of ω, before the rest: it needs the entries as they were. */
  private void correctTurnRate() {
    double k4 = gain[8];
    double l4 = gain[9];
    double p04 = p[10];
    double p14 = p[11];
    p[10] = k4 * rXx + l4 * rXy;
    p[11] = k4 * rXy + l4 * rYy;
    p[12] -= gain[4] * p04 + gain[5] * p14;
    p[13] -= gain[6] * p04 + gain[7] * p14;
    p[14] -= k4 * p04 + l4 * p14;
  }

  /** What is known of the velocity; it needs the entries of the place as they were. */
  private void correctVelocity() {
    double k2 = gain[4];
    double l2 = gain[5];
    double k3 = gain[6];
    double l3 = gain[7];
    p[7] -= k2 * p[2] + l2 * p[5];
    p[8] -= k2 * p[3] + l2 * p[6];
    p[9] -= k3 * p[3] + l3 * p[6];
  }

  private void correctPlace() {
    p[0] = gain[0] * rXx + gain[1] * rXy;
    p[1] = gain[0] * rXy + gain[1] * rYy;
    p[4] = gain[2] * rXy + gain[3] * rYy;
    p[2] = gain[4] * rXx + gain[5] * rXy;
    p[5] = gain[4] * rXy + gain[5] * rYy;
    p[3] = gain[6] * rXx + gain[7] * rXy;
    p[6] = gain[6] * rXy + gain[7] * rYy;
  }

  double nis() {
    return nis;
  }

  /** How likely the innovation is, but for the square and a factor that all filters share. */
  double squaredDensity() {
    return perDeterminant;
  }

  double logLikelihood() {
    return -0.5 * (nis - Math.log(perDeterminant)) - LOG_TWO_PI;
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
