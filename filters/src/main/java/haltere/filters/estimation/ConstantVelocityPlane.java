package haltere.filters.estimation;

import java.util.Objects;

/**
 * The Kalman filter of {@link haltere.filters.estimation.motion.ConstantVelocity} in two axes with
 * one gate: state (x, vₓ, y, v_y).
 *
 * <p>Where the two measured coordinates have independent noise, the four states fall apart into two
 * filters of two, with a fifth of the arithmetic. Allocates nothing.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class ConstantVelocityPlane {
  private final ConstantVelocityAxis x;
  private final ConstantVelocityAxis y;
  private final InnovationMonitor monitor;
  private final double threshold;
  private double lastNis = Double.NaN;

  /**
   * A filter that needs a launch.
   *
   * @param accelerationDensity q per axis, in unit²/s³
   * @param gate which innovations are believed, both axes together
   * @param lossAfter gated innovations in a row that mean a loss of lock, at least 1
   */
  public ConstantVelocityPlane(double accelerationDensity, Gate gate, int lossAfter) {
    x = new ConstantVelocityAxis(accelerationDensity);
    y = new ConstantVelocityAxis(accelerationDensity);
    threshold = Objects.requireNonNull(gate, "gate").threshold(2);
    monitor = new InnovationMonitor(lossAfter);
  }

  /**
   * Begins (again) at a place, with an unknown velocity.
   *
   * @param atX in units
   * @param atY in units
   * @param positionVariance unit², positive
   * @param velocityVariance unit²/s², positive; large
   */
  public void launch(double atX, double atY, double positionVariance, double velocityVariance) {
    x.launch(atX, 0, positionVariance, velocityVariance);
    y.launch(atY, 0, positionVariance, velocityVariance);
    monitor.endRun();
  }

  /**
   * Predicts.
   *
   * @param dtS seconds, finite and not negative
   */
  public void predict(double dtS) {
    x.predict(dtS);
    y.predict(dtS);
  }

  /**
   * Predicts with another density than the filter's own, as dynamic variances do.
   *
   * @param dtS seconds, finite and not negative
   * @param accelerationDensity q per axis, in unit²/s³, not negative
   */
  public void predict(double dtS, double accelerationDensity) {
    x.predict(dtS, accelerationDensity);
    y.predict(dtS, accelerationDensity);
  }

  /**
   * Takes a measured place in, unless it lies outside the gate.
   *
   * @param atX in units
   * @param atY in units
   * @param variance of each coordinate, in unit², positive
   * @return what became of it
   */
  public UpdateOutcome update(double atX, double atY, double variance) {
    return update(atX, atY, variance, variance);
  }

  /**
   * Takes a measured place in, unless it lies outside the gate.
   *
   * @param atX in units
   * @param atY in units
   * @param varianceX in unit², positive
   * @param varianceY in unit², positive
   * @return what became of it
   */
  public UpdateOutcome update(double atX, double atY, double varianceX, double varianceY) {
    double nis = x.nis(atX, varianceX) + y.nis(atY, varianceY);
    boolean variances =
        varianceX > 0 && varianceY > 0 && varianceX + varianceY < Double.POSITIVE_INFINITY;
    if (!(variances && nis < Double.POSITIVE_INFINITY)) {
      return monitor.noteUnusable();
    }
    lastNis = nis;
    if (nis > threshold) {
      return monitor.noteGated();
    }
    x.update(atX, varianceX);
    y.update(atY, varianceY);
    return monitor.noteApplied();
  }

  /**
   * The filter of the first axis.
   *
   * @return position, velocity and their covariance
   */
  public ConstantVelocityAxis x() {
    return x;
  }

  /**
   * The filter of the second axis.
   *
   * @return position, velocity and their covariance
   */
  public ConstantVelocityAxis y() {
    return y;
  }

  /**
   * Normalised innovation squared of the last usable measurement, two degrees of freedom.
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
