package haltere.filters.estimation;

/**
 * The Kalman filter of {@link haltere.filters.estimation.motion.ConstantVelocity} on one axis,
 * written out on primitive fields: for use at every event. It allocates nothing.
 *
 * <p>The update is Joseph's form: with a gain of k = (k₀, k₁), P₀₀ = (1 − k₀)² p₀₀ + k₀² r and so
 * on, where 1 − k₀ is calculated as r / S, so that nothing cancels. What a long gap means is the
 * caller's to say.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class ConstantVelocityAxis {
  private final double density;
  private double position;
  private double velocity;
  private double p00;
  private double p01;
  private double p11;

  /**
   * A filter that needs a launch.
   *
   * @param accelerationDensity q, in unit²/s³
   */
  public ConstantVelocityAxis(double accelerationDensity) {
    density = Require.notNegative("acceleration density", accelerationDensity);
  }

  /**
   * Begins (again).
   *
   * @param newPosition s, in units
   * @param newVelocity v, in units/s
   * @param positionVariance unit², positive
   * @param velocityVariance unit²/s², positive
   */
  public void launch(
      double newPosition, double newVelocity, double positionVariance, double velocityVariance) {
    position = Require.finite("position", newPosition);
    velocity = Require.finite("velocity", newVelocity);
    p00 = Require.positive("position variance", positionVariance);
    p11 = Require.positive("velocity variance", velocityVariance);
    p01 = 0;
  }

  /**
   * Predicts.
   *
   * @param dtS seconds, finite and not negative
   */
  public void predict(double dtS) {
    predict(dtS, density);
  }

  /**
   * Predicts with another density than the filter's own, as dynamic variances do.
   *
   * @param dtS seconds, finite and not negative
   * @param accelerationDensity q, in unit²/s³, not negative
   */
  public void predict(double dtS, double accelerationDensity) {
    Require.timeStep(dtS);
    double noise = Require.notNegative("acceleration density", accelerationDensity) * dtS;
    position += velocity * dtS;
    p00 += dtS * (2 * p01 + dtS * (p11 + noise * (1.0 / 3)));
    p01 += dtS * (p11 + 0.5 * noise);
    p11 += noise;
  }

  /**
   * Takes a measured position in.
   *
   * @param z position; the caller has gated it, see {@link #nis}
   * @param r its variance in unit², positive
   * @return false, and nothing is changed, if the position is not finite or the variance not
   *     positive
   */
  public boolean update(double z, double r) {
    double y = z - position;
    if (!(Math.abs(y) < Double.POSITIVE_INFINITY && r > 0 && r < Double.POSITIVE_INFINITY)) {
      return false;
    }
    double inverseS = 1 / (p00 + r);
    double k0 = p00 * inverseS;
    double k1 = p01 * inverseS;
    double rest = r * inverseS;
    position += k0 * y;
    velocity += k1 * y;
    // (I − K H) P (I − K H)ᵀ + K R Kᵀ with I − K H = [rest 0; −k1 1]
    double a01 = p01 - k1 * p00;
    double a11 = p11 - k1 * p01;
    p11 = a11 - k1 * a01 + k1 * k1 * r;
    p01 = rest * a01 + k0 * k1 * r;
    p00 = rest * rest * p00 + k0 * k0 * r;
    return true;
  }

  /**
   * How far a measurement lies from the prediction.
   *
   * @param z position
   * @param r its variance in unit², positive
   * @return normalised innovation squared
   */
  public double nis(double z, double r) {
    double y = z - position;
    return y * y / (p00 + r);
  }

  /**
   * Sets the position without touching what the filter is unsure of, as feedback to a cluster does.
   *
   * @param newPosition finite
   */
  public void shiftTo(double newPosition) {
    position = Require.finite("position", newPosition);
  }

  /**
   * Estimated position.
   *
   * @return in units
   */
  public double position() {
    return position;
  }

  /**
   * Estimated velocity.
   *
   * @return in units/s
   */
  public double velocity() {
    return velocity;
  }

  /**
   * Variance of the position.
   *
   * @return in unit²
   */
  public double positionVariance() {
    return p00;
  }

  /**
   * Covariance of position and velocity.
   *
   * @return in unit²/s
   */
  public double crossCovariance() {
    return p01;
  }

  /**
   * Variance of the velocity.
   *
   * @return in unit²/s²
   */
  public double velocityVariance() {
    return p11;
  }
}
