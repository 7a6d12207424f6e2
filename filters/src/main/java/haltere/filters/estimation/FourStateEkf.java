package haltere.filters.estimation;

import java.util.Objects;

/**
 * An extended Kalman filter of four states for scalar measurements, written out on primitive
 * fields: for use at every event. The caller gives Jacobians and residuals as numbers; nothing is
 * allocated.
 *
 * <pre>{@code
 * // the edge of a wing: centre a, amplitude M, phase ξ, angular frequency ω
 * ekf.predict(0, 0, 0, 0, 0, dtS);                              // ξ ← ξ + ω Δt
 * ekf.addNoise(qa * dtS, qm * dtS, qx * dtS, qw * dtS);
 * wave.of(ekf.x2());                                             // a SineCosine
 * double y = Angles.wrapPi(angle - (ekf.x0() + ekf.x1() * wave.sine()));
 * ekf.update(y, 1, wave.sine(), ekf.x1() * wave.cosine(), 0, r);
 * }</pre>
 *
 * <p>The update is Joseph's form, multiplied out for a scalar: with g = P h, S = hᵀ g + r, K = g/S
 * and A = P − K gᵀ, it is P ← A − (A h − r K) Kᵀ. In exact arithmetic the bracket is zero; here it
 * is the rounding error of A that Joseph's form takes back. Only the upper triangle is kept, so P
 * is symmetric by construction.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class FourStateEkf {
  private final double threshold;
  private final InnovationMonitor monitor;
  private double x0;
  private double x1;
  private double x2;
  private double x3;
  private double p00;
  private double p01;
  private double p02;
  private double p03;
  private double p11;
  private double p12;
  private double p13;
  private double p22;
  private double p23;
  private double p33;
  private double lastNis = Double.NaN;

  /**
   * A filter that needs a launch.
   *
   * @param gate which innovations are believed
   * @param lossAfter gated innovations in a row that mean a loss of lock, at least 1
   */
  public FourStateEkf(Gate gate, int lossAfter) {
    threshold = Objects.requireNonNull(gate, "gate").threshold(1);
    monitor = new InnovationMonitor(lossAfter);
  }

  /**
   * Sets the state, and leaves the covariance: at launch, or for an evolution that is not linear.
   *
   * @param s0 first entry
   * @param s1 second entry
   * @param s2 third entry
   * @param s3 fourth entry
   */
  public void setState(double s0, double s1, double s2, double s3) {
    if (!Double.isFinite(s0 + s1 + s2 + s3)) {
      throw new IllegalArgumentException(
          "state must be finite: " + s0 + ", " + s1 + ", " + s2 + ", " + s3);
    }
    x0 = s0;
    x1 = s1;
    x2 = s2;
    x3 = s3;
  }

  /**
   * Sets the covariance to a diagonal, all of it positive, and ends a run of gated innovations.
   *
   * @param v0 variance of the first entry
   * @param v1 variance of the second entry
   * @param v2 variance of the third entry
   * @param v3 variance of the fourth entry
   */
  public void setVariances(double v0, double v1, double v2, double v3) {
    p00 = Require.positive("variance", v0);
    p11 = Require.positive("variance", v1);
    p22 = Require.positive("variance", v2);
    p33 = Require.positive("variance", v3);
    p01 = 0;
    p02 = 0;
    p03 = 0;
    p12 = 0;
    p13 = 0;
    p23 = 0;
    monitor.endRun();
  }

  /**
   * Sets the whole covariance, as a mixture of several filters does, and ends a run of gated
   * innovations.
   *
   * @param p sixteen entries, row by row, symmetric and positive definite; not kept
   */
  public void setCovariance(double[] p) {
    for (int i = 0; i < 4; i++) {
      Require.positive("variance", p[5 * i]);
    }
    takeCovariance(p);
    monitor.endRun();
  }

  private void takeCovariance(double[] p) {
    p00 = p[0];
    p01 = p[1];
    p02 = p[2];
    p03 = p[3];
    p11 = p[5];
    p12 = p[6];
    p13 = p[7];
    p22 = p[10];
    p23 = p[11];
    p33 = p[15];
  }

  /**
   * Takes over state and covariance of another filter, and ends a run of gated innovations.
   *
   * @param other stays as it is
   */
  public void copy(FourStateEkf other) {
    x0 = other.x0;
    x1 = other.x1;
    x2 = other.x2;
    x3 = other.x3;
    p00 = other.p00;
    p01 = other.p01;
    p02 = other.p02;
    p03 = other.p03;
    p11 = other.p11;
    p12 = other.p12;
    p13 = other.p13;
    p22 = other.p22;
    p23 = other.p23;
    p33 = other.p33;
    monitor.endRun();
  }

  /**
   * The whole covariance.
   *
   * @param out gets sixteen entries, row by row
   */
  public void covariance(double[] out) {
    out[0] = p00;
    out[1] = p01;
    out[2] = p02;
    out[3] = p03;
    out[4] = p01;
    out[5] = p11;
    out[6] = p12;
    out[7] = p13;
    out[8] = p02;
    out[9] = p12;
    out[10] = p22;
    out[11] = p23;
    out[12] = p03;
    out[13] = p13;
    out[14] = p23;
    out[15] = p33;
  }

  /**
   * Predicts by a transition that is 1 on its diagonal and 0 below: x ← F x, P ← F P Fᵀ. That is
   * any chain of integrators in order of their derivatives. Constant velocity in a plane is (Δt, 0,
   * 0, 0, 0, Δt).
   *
   * @param f01 entry of F in row 0, column 1
   * @param f02 entry of F
   * @param f03 entry of F
   * @param f12 entry of F
   * @param f13 entry of F
   * @param f23 entry of F
   */
  public void predict(double f01, double f02, double f03, double f12, double f13, double f23) {
    x0 += f01 * x1 + f02 * x2 + f03 * x3;
    x1 += f12 * x2 + f13 * x3;
    x2 += f23 * x3;
    // B = F P, as far as it is needed: row i is row i of P plus rows below it.
    double b00 = p00 + f01 * p01 + f02 * p02 + f03 * p03;
    double b01 = p01 + f01 * p11 + f02 * p12 + f03 * p13;
    double b02 = p02 + f01 * p12 + f02 * p22 + f03 * p23;
    double b03 = p03 + f01 * p13 + f02 * p23 + f03 * p33;
    double b11 = p11 + f12 * p12 + f13 * p13;
    double b12 = p12 + f12 * p22 + f13 * p23;
    double b13 = p13 + f12 * p23 + f13 * p33;
    double b22 = p22 + f23 * p23;
    double b23 = p23 + f23 * p33;
    // P = B Fᵀ: column j is column j of B plus columns to its right.
    p00 = b00 + f01 * b01 + f02 * b02 + f03 * b03;
    p01 = b01 + f12 * b02 + f13 * b03;
    p02 = b02 + f23 * b03;
    p03 = b03;
    p11 = b11 + f12 * b12 + f13 * b13;
    p12 = b12 + f23 * b13;
    p13 = b13;
    p22 = b22 + f23 * b23;
    p23 = b23;
  }

  /**
   * Predicts the covariance by any Jacobian: P ← F P Fᵀ. The state is the caller's to evolve, with
   * {@link #setState}.
   *
   * @param f sixteen entries, row by row; not kept
   */
  public void predictCovariance(double[] f) {
    double a0 = f[0];
    double a1 = f[1];
    double a2 = f[2];
    double a3 = f[3];
    double r00 = a0 * p00 + a1 * p01 + a2 * p02 + a3 * p03;
    double r01 = a0 * p01 + a1 * p11 + a2 * p12 + a3 * p13;
    double r02 = a0 * p02 + a1 * p12 + a2 * p22 + a3 * p23;
    double r03 = a0 * p03 + a1 * p13 + a2 * p23 + a3 * p33;
    double b0 = f[4];
    double b1 = f[5];
    double b2 = f[6];
    double b3 = f[7];
    double r10 = b0 * p00 + b1 * p01 + b2 * p02 + b3 * p03;
    double r11 = b0 * p01 + b1 * p11 + b2 * p12 + b3 * p13;
    double r12 = b0 * p02 + b1 * p12 + b2 * p22 + b3 * p23;
    double r13 = b0 * p03 + b1 * p13 + b2 * p23 + b3 * p33;
    double c0 = f[8];
    double c1 = f[9];
    double c2 = f[10];
    double c3 = f[11];
    double r20 = c0 * p00 + c1 * p01 + c2 * p02 + c3 * p03;
    double r21 = c0 * p01 + c1 * p11 + c2 * p12 + c3 * p13;
    double r22 = c0 * p02 + c1 * p12 + c2 * p22 + c3 * p23;
    double r23 = c0 * p03 + c1 * p13 + c2 * p23 + c3 * p33;
    double d0 = f[12];
    double d1 = f[13];
    double d2 = f[14];
    double d3 = f[15];
    double r30 = d0 * p00 + d1 * p01 + d2 * p02 + d3 * p03;
    double r31 = d0 * p01 + d1 * p11 + d2 * p12 + d3 * p13;
    double r32 = d0 * p02 + d1 * p12 + d2 * p22 + d3 * p23;
    double r33 = d0 * p03 + d1 * p13 + d2 * p23 + d3 * p33;
    p00 = r00 * a0 + r01 * a1 + r02 * a2 + r03 * a3;
    p01 = r00 * b0 + r01 * b1 + r02 * b2 + r03 * b3;
    p02 = r00 * c0 + r01 * c1 + r02 * c2 + r03 * c3;
    p03 = r00 * d0 + r01 * d1 + r02 * d2 + r03 * d3;
    p11 = r10 * b0 + r11 * b1 + r12 * b2 + r13 * b3;
    p12 = r10 * c0 + r11 * c1 + r12 * c2 + r13 * c3;
    p13 = r10 * d0 + r11 * d1 + r12 * d2 + r13 * d3;
    p22 = r20 * c0 + r21 * c1 + r22 * c2 + r23 * c3;
    p23 = r20 * d0 + r21 * d1 + r22 * d2 + r23 * d3;
    p33 = r30 * d0 + r31 * d1 + r32 * d2 + r33 * d3;
  }

  /**
   * Adds independent process noise; densities times the time step.
   *
   * @param q0 variance that the step adds to the first entry, not negative
   * @param q1 to the second
   * @param q2 to the third
   * @param q3 to the fourth
   */
  public void addNoise(double q0, double q1, double q2, double q3) {
    p00 += q0;
    p11 += q1;
    p22 += q2;
    p33 += q3;
  }

  /**
   * Adds process noise that the first two entries, and the last two, have in common: that of two
   * axes of constant velocity.
   *
   * @param q01 covariance that the step adds between the first and the second entry
   * @param q23 between the third and the fourth
   */
  public void addPairNoise(double q01, double q23) {
    p01 += q01;
    p23 += q23;
  }

  /**
   * Takes a scalar measurement in, unless it lies outside the gate.
   *
   * @param y residual z − h(x); of an angle, wrapped
   * @param h0 ∂h/∂x0
   * @param h1 ∂h/∂x1
   * @param h2 ∂h/∂x2
   * @param h3 ∂h/∂x3
   * @param r variance of the measurement, positive
   * @return what became of it
   */
  public UpdateOutcome update(double y, double h0, double h1, double h2, double h3, double r) {
    // Sums in pairs: each event waits for the one before, so the longest chain is what counts.
    double g0 = (p00 * h0 + p01 * h1) + (p02 * h2 + p03 * h3);
    double g1 = (p01 * h0 + p11 * h1) + (p12 * h2 + p13 * h3);
    double g2 = (p02 * h0 + p12 * h1) + (p22 * h2 + p23 * h3);
    double g3 = (p03 * h0 + p13 * h1) + (p23 * h2 + p33 * h3);
    double s = (h0 * g0 + h1 * g1) + (h2 * g2 + h3 * g3) + r;
    double inverseS = 1 / s;
    double nis = y * y * inverseS;
    if (!(r > 0 && s > 0 && s < Double.POSITIVE_INFINITY && nis < Double.POSITIVE_INFINITY)) {
      return monitor.noteUnusable();
    }
    lastNis = nis;
    if (nis > threshold) {
      return monitor.noteGated();
    }
    double k0 = g0 * inverseS;
    double k1 = g1 * inverseS;
    double k2 = g2 * inverseS;
    double k3 = g3 * inverseS;
    x0 += k0 * y;
    x1 += k1 * y;
    x2 += k2 * y;
    x3 += k3 * y;
    // A = P − K gᵀ
    double a00 = p00 - k0 * g0;
    double a01 = p01 - k0 * g1;
    double a02 = p02 - k0 * g2;
    double a03 = p03 - k0 * g3;
    double a11 = p11 - k1 * g1;
    double a12 = p12 - k1 * g2;
    double a13 = p13 - k1 * g3;
    double a22 = p22 - k2 * g2;
    double a23 = p23 - k2 * g3;
    double a33 = p33 - k3 * g3;
    // e = A h − r K
    double e0 = (a00 * h0 + a01 * h1) + (a02 * h2 + a03 * h3) - r * k0;
    double e1 = (a01 * h0 + a11 * h1) + (a12 * h2 + a13 * h3) - r * k1;
    double e2 = (a02 * h0 + a12 * h1) + (a22 * h2 + a23 * h3) - r * k2;
    double e3 = (a03 * h0 + a13 * h1) + (a23 * h2 + a33 * h3) - r * k3;
    // P = A − e Kᵀ
    p00 = a00 - e0 * k0;
    p01 = a01 - e0 * k1;
    p02 = a02 - e0 * k2;
    p03 = a03 - e0 * k3;
    p11 = a11 - e1 * k1;
    p12 = a12 - e1 * k2;
    p13 = a13 - e1 * k3;
    p22 = a22 - e2 * k2;
    p23 = a23 - e2 * k3;
    p33 = a33 - e3 * k3;
    return monitor.noteApplied();
  }

  /**
   * First entry of the state.
   *
   * @return in its own unit
   */
  public double x0() {
    return x0;
  }

  /**
   * Second entry of the state.
   *
   * @return in its own unit
   */
  public double x1() {
    return x1;
  }

  /**
   * Third entry of the state.
   *
   * @return in its own unit
   */
  public double x2() {
    return x2;
  }

  /**
   * Fourth entry of the state.
   *
   * @return in its own unit
   */
  public double x3() {
    return x3;
  }

  /**
   * One entry of the covariance; for reading now and then, not for the hot path.
   *
   * @param row 0 to 3
   * @param column 0 to 3
   * @return P
   */
  public double covariance(int row, int column) {
    int i = Math.min(row, column);
    int j = Math.max(row, column);
    return switch (4 * i + j) {
      case 0 -> p00;
      case 1 -> p01;
      case 2 -> p02;
      case 3 -> p03;
      case 5 -> p11;
      case 6 -> p12;
      case 7 -> p13;
      case 10 -> p22;
      case 11 -> p23;
      case 15 -> p33;
      default -> throw new IndexOutOfBoundsException(row + ", " + column);
    };
  }

  /**
   * Changes one entry of the covariance so that it stays one; for a person, not for the hot path.
   *
   * @param row 0 to 3
   * @param column 0 to 3
   * @param value the new number
   * @throws IllegalArgumentException if no covariance has such a number there
   */
  public void setCovariance(int row, int column, double value) {
    double[] p = new double[16];
    covariance(p);
    takeCovariance(CovarianceEdit.with(p, 4, row, column, value));
  }

  /**
   * Normalised innovation squared of the last usable measurement.
   *
   * @return NaN before the first
   */
  public double nis() {
    return lastNis;
  }

  /**
   * What became of the measurements so far.
   *
   * @return the filter's own monitor
   */
  public InnovationMonitor monitor() {
    return monitor;
  }
}
