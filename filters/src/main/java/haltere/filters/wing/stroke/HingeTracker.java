package haltere.filters.wing.stroke;

import java.util.Arrays;

/**
 * Follows a wing's hinge as the body sways. The stroke's filter explains the angles; what it cannot
 * explain, as it differs between near and far events, is a shift of the hinge. Residuals gather in
 * normal equations of the shift beside the filter's own centre, amplitude and phase, which are
 * eliminated; the shift is a random walk that is estimated every few milliseconds.
 *
 * <p>Thread rule: one thread at a time.
 */
final class HingeTracker {
  private static final int SIZE = 5;
  private static final int SHIFT = 2;

  private final double[][] a = new double[SIZE][SIZE];
  private final double[] b = new double[SIZE];
  private final double[][] m = new double[SIZE][SIZE + 1];
  private double pxx;
  private double pxy;
  private double pyy;
  private final UsualShift usual = new UsualShift();

  /** The last shift, pixels, and what it does to centre, amplitude and phase. */
  double shiftX;

  double shiftY;
  double centreShift;
  double amplitudeShift;
  double phaseShift;

  /** Begins with an uncertainty of the hinge, pixels. */
  void launch(double sdPx) {
    pxx = sdPx * sdPx;
    pyy = pxx;
    pxy = 0;
    usual.clear();
    clear();
  }

  private void clear() {
    for (double[] row : a) {
      Arrays.fill(row, 0);
    }
    Arrays.fill(b, 0);
  }

  /**
   * Takes a residual.
   *
   * @param weight one over its variance
   * @param y the residual, radians
   * @param gx by how much it falls when the hinge moves to the right, radians a pixel
   * @param gy by how much it falls when the hinge moves up
   * @param sin sine of the phase
   * @param slope derivative of the angle with respect to the phase
   */
  void add(double weight, double y, double gx, double gy, double sin, double slope) {
    double[] a0 = a[0];
    double[] a1 = a[1];
    double[] a2 = a[2];
    double[] a3 = a[3];
    double wx = weight * gx;
    a0[0] += wx * gx;
    a0[1] += wx * gy;
    a0[2] += wx;
    a0[3] += wx * sin;
    a0[4] += wx * slope;
    double wy = weight * gy;
    a1[1] += wy * gy;
    a1[2] += wy;
    a1[3] += wy * sin;
    a1[4] += wy * slope;
    double ws = weight * sin;
    a2[2] += weight;
    a2[3] += ws;
    a2[4] += weight * slope;
    a3[3] += ws * sin;
    a3[4] += ws * slope;
    a[4][4] += weight * slope * slope;
    double r = weight * y;
    b[0] += r * gx;
    b[1] += r * gy;
    b[2] += r;
    b[3] += r * sin;
    b[4] += r * slope;
  }

  /**
   * Estimates the shift since the last time.
   *
   * @param byHand whether a person has put the hinge where it is; what the events say against that
   *     at first is no shift, then or later
   */
  boolean solve(double dtS, double walkPx2PerS, double inflation, boolean byHand) {
    pxx += walkPx2PerS * dtS;
    pyy += walkPx2PerS * dtS;
    // eliminate the nuisances, the last three, from the bottom up
    for (int i = 0; i < SIZE; i++) {
      for (int j = 0; j < SIZE; j++) {
        m[i][j] = j >= i ? a[i][j] : a[j][i];
      }
      m[i][SIZE] = b[i];
    }
    double trust = a[2][2] * 1e-6 + 1e-9;
    for (int k = SHIFT; k < SIZE; k++) {
      m[k][k] += trust;
    }
    for (int k = SIZE - 1; k >= SHIFT; k--) {
      for (int i = 0; i < k; i++) {
        double f = m[i][k] / m[k][k];
        for (int j = 0; j <= SIZE; j++) {
          m[i][j] -= f * m[k][j];
        }
      }
    }
    double jxx = m[0][0] / inflation;
    double jxy = m[0][1] / inflation;
    double jyy = m[1][1] / inflation;
    double rx = m[0][SIZE] / inflation;
    double ry = m[1][SIZE] / inflation;
    if (byHand) {
      if (!usual.isLearnt()) {
        usual.add(jxx, jxy, jyy, rx, ry);
        clear();
        return false;
      }
      rx -= jxx * usual.x() + jxy * usual.y();
      ry -= jxy * usual.x() + jyy * usual.y();
    }
    double det = pxx * pyy - pxy * pxy;
    double ixx = pyy / det + jxx;
    double ixy = -pxy / det + jxy;
    double iyy = pxx / det + jyy;
    double idet = ixx * iyy - ixy * ixy;
    if (!(det > 0) || !(idet > 0)) {
      clear();
      return false;
    }
    pxx = iyy / idet;
    pxy = -ixy / idet;
    pyy = ixx / idet;
    shiftX = pxx * rx + pxy * ry;
    shiftY = pxy * rx + pyy * ry;
    // what the shift takes from the nuisances
    double[] n = m[2];
    centreShift = -(n[0] * shiftX + n[1] * shiftY) / n[2];
    n = m[3];
    amplitudeShift = -(n[0] * shiftX + n[1] * shiftY + n[2] * centreShift) / n[3];
    n = m[4];
    phaseShift =
        -(n[0] * shiftX + n[1] * shiftY + n[2] * centreShift + n[3] * amplitudeShift) / n[4];
    clear();
    return true;
  }
}
