package haltere.filters.estimation.motion;

import haltere.filters.estimation.ProcessModel;
import haltere.filters.estimation.Require;
import org.ejml.data.DMatrixRMaj;

/**
 * Several independent axes with the same model, each a chain of integrators driven by white noise:
 * the state is (s, v, …) of the first axis, then of the second.
 *
 * <pre>
 * F = [1 Δt Δt²/2; 0 1 Δt; 0 0 1], or its first two rows and columns
 * Q = q ∫ g gᵀ dt,   g = (…, t²/2, t, 1) from the entry that the noise drives upwards
 * </pre>
 *
 * <p>Bar-Shalom, Li and Kirubarajan (2001), section 6.2. Immutable.
 */
public final class AxisMotion implements ProcessModel {
  private final int axes;
  private final int order;

  /** Number of integrators after the noise; 0 for constant noise per step. */
  private final int driven;

  private final double density;

  private AxisMotion(int axes, int order, int driven, String what, double density) {
    this.axes = Require.atLeast("axes", 1, axes);
    this.order = order;
    this.driven = driven;
    this.density = Require.notNegative(what, density);
  }

  /**
   * State (s, v) per axis; white acceleration drives the velocity (eq. 6.2.2-8 and 6.2.2-12).
   *
   * @param axes at least 1
   * @param density q, spectral density of the acceleration, in unit²/s³: in a second the velocity
   *     wanders by √q
   * @return the model
   */
  public static AxisMotion constantVelocity(int axes, double density) {
    return new AxisMotion(axes, 2, 2, "acceleration density", density);
  }

  /**
   * State (s, v, a) per axis; a constant unknown acceleration plus white acceleration: gravity with
   * gusts. With a density of 0 the filter is the least-squares parabola.
   *
   * @param axes at least 1
   * @param density q, spectral density of the white acceleration, in unit²/s³
   * @return the model
   */
  public static AxisMotion constantAcceleration(int axes, double density) {
    return new AxisMotion(axes, 3, 2, "acceleration density", density);
  }

  /**
   * State (s, v, a) per axis; the acceleration is a random walk, driven by white jerk (Wiener
   * process acceleration, eq. 6.2.3-5 and 6.2.3-7).
   *
   * @param axes at least 1
   * @param density q, spectral density of the jerk, in unit²/s⁵: in a second the acceleration
   *     wanders by √q
   * @return the model
   */
  public static AxisMotion whiteJerk(int axes, double density) {
    return new AxisMotion(axes, 3, 3, "jerk density", density);
  }

  /**
   * The same motion with Q = q I at every step, independent of its length. Its tuning depends on
   * the rate of updates; prefer a density.
   *
   * @param variance q, added to each entry's variance, in the square of its unit
   * @return another model
   */
  public AxisMotion withNoisePerStep(double variance) {
    return new AxisMotion(axes, order, 0, "variance per step", variance);
  }

  @Override
  public int stateSize() {
    return axes * order;
  }

  /** {@inheritDoc} Taylor: s ← s + v Δt + a Δt²/2. */
  @Override
  public void evolve(DMatrixRMaj x, double dtS, DMatrixRMaj evolved) {
    for (int entry = 0; entry < stateSize(); entry++) {
      double sum = 0;
      double factor = 1;
      for (int ahead = 0; ahead < order - entry % order; ahead++) {
        sum += factor * x.data[entry + ahead];
        factor *= dtS / (ahead + 1);
      }
      evolved.data[entry] = sum;
    }
  }

  /** {@inheritDoc} It does not depend on the state. */
  @Override
  public void jacobian(DMatrixRMaj x, double dtS, DMatrixRMaj f) {
    f.zero();
    for (int entry = 0; entry < stateSize(); entry++) {
      double factor = 1;
      for (int ahead = 0; ahead < order - entry % order; ahead++) {
        f.set(entry, entry + ahead, factor);
        factor *= dtS / (ahead + 1);
      }
    }
  }

  /** {@inheritDoc} It does not depend on the state. */
  @Override
  public void noise(DMatrixRMaj x, double dtS, DMatrixRMaj q) {
    q.zero();
    for (int i = 0; i < stateSize(); i++) {
      for (int j = i - i % order; j < i - i % order + order; j++) {
        double perStep = i == j ? 1 : 0;
        q.set(i, j, density * (driven == 0 ? perStep : integrated(i % order, j % order, dtS)));
      }
    }
  }

  /** The integral of Δtⁱ Δtʲ / (i! j!), with i and j integrators between the noise and an entry. */
  private double integrated(int row, int column, double dtS) {
    int i = driven - 1 - row;
    int j = driven - 1 - column;
    if (i < 0 || j < 0) {
      return 0;
    }
    double value = dtS / (i + j + 1);
    for (int k = 1; k <= i; k++) {
      value *= dtS / k;
    }
    for (int k = 1; k <= j; k++) {
      value *= dtS / k;
    }
    return value;
  }
}
