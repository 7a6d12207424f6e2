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
  private final FourStateCovariance p = new FourStateCovariance();
  private double x0;
  private double x1;
  private double x2;
  private double x3;
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
    p.setVariances(
        Require.positive("variance", v0),
        Require.positive("variance", v1),
        Require.positive("variance", v2),
        Require.positive("variance", v3));
    monitor.endRun();
  }

  /**
   * Sets the whole covariance, as a mixture of several filters does, and ends a run of gated
   * innovations.
   *
   * @param entries sixteen, row by row, symmetric and positive definite; not kept
   */
  public void setCovariance(double[] entries) {
    for (int i = 0; i < 4; i++) {
      Require.positive("variance", entries[5 * i]);
    }
    p.read(entries);
    monitor.endRun();
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
    p.copy(other.p);
    monitor.endRun();
  }

  /**
   * The whole covariance.
   *
   * @param out gets sixteen entries, row by row
   */
  public void covariance(double[] out) {
    p.write(out);
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
    p.transform(f01, f02, f03, f12, f13, f23);
  }

  /**
   * Predicts the covariance by any Jacobian: P ← F P Fᵀ. The state is the caller's to evolve, with
   * {@link #setState}.
   *
   * @param f sixteen entries, row by row; not kept
   */
  public void predictCovariance(double[] f) {
    p.transform(f);
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
    p.e00 += q0;
    p.e11 += q1;
    p.e22 += q2;
    p.e33 += q3;
  }

  /**
   * Adds process noise that the first two entries, and the last two, have in common: that of two
   * axes of constant velocity.
   *
   * @param q01 covariance that the step adds between the first and the second entry
   * @param q23 between the third and the fourth
   */
  public void addPairNoise(double q01, double q23) {
    p.e01 += q01;
    p.e23 += q23;
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
    double g0 = (p.e00 * h0 + p.e01 * h1) + (p.e02 * h2 + p.e03 * h3);
    double g1 = (p.e01 * h0 + p.e11 * h1) + (p.e12 * h2 + p.e13 * h3);
    double g2 = (p.e02 * h0 + p.e12 * h1) + (p.e22 * h2 + p.e23 * h3);
    double g3 = (p.e03 * h0 + p.e13 * h1) + (p.e23 * h2 + p.e33 * h3);
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
    double a00 = p.e00 - k0 * g0;
    double a01 = p.e01 - k0 * g1;
    double a02 = p.e02 - k0 * g2;
    double a03 = p.e03 - k0 * g3;
    double a11 = p.e11 - k1 * g1;
    double a12 = p.e12 - k1 * g2;
    double a13 = p.e13 - k1 * g3;
    double a22 = p.e22 - k2 * g2;
    double a23 = p.e23 - k2 * g3;
    double a33 = p.e33 - k3 * g3;
    // e = A h − r K
    double e0 = (a00 * h0 + a01 * h1) + (a02 * h2 + a03 * h3) - r * k0;
    double e1 = (a01 * h0 + a11 * h1) + (a12 * h2 + a13 * h3) - r * k1;
    double e2 = (a02 * h0 + a12 * h1) + (a22 * h2 + a23 * h3) - r * k2;
    double e3 = (a03 * h0 + a13 * h1) + (a23 * h2 + a33 * h3) - r * k3;
    // P = A − e Kᵀ
    p.e00 = a00 - e0 * k0;
    p.e01 = a01 - e0 * k1;
    p.e02 = a02 - e0 * k2;
    p.e03 = a03 - e0 * k3;
    p.e11 = a11 - e1 * k1;
    p.e12 = a12 - e1 * k2;
    p.e13 = a13 - e1 * k3;
    p.e22 = a22 - e2 * k2;
    p.e23 = a23 - e2 * k3;
    p.e33 = a33 - e3 * k3;
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
    return p.get(row, column);
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
    double[] entries = new double[16];
    p.write(entries);
    p.read(CovarianceEdit.with(entries, 4, row, column, value));
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
