package haltere.filters.estimation.motion;

import haltere.filters.estimation.Require;

/**
 * State (s, v, a) per axis; the acceleration wanders, driven by white jerk.
 *
 * <pre>
 * F = [1 Δt Δt²/2; 0 1 Δt; 0 0 1]
 * Q = q [Δt⁵/20 Δt⁴/8 Δt³/6; Δt⁴/8 Δt³/3 Δt²/2; Δt³/6 Δt²/2 Δt]
 * </pre>
 *
 * <p>Bar-Shalom, Li and Kirubarajan (2001), eq. 6.2.3-5 and 6.2.3-7 (Wiener process acceleration).
 */
public final class WhiteJerk extends AxisBlocks {
  private final double density;

  /**
   * A model of several axes.
   *
   * @param axes at least 1; state (s₁, v₁, a₁, s₂, …)
   * @param jerkDensity q, spectral density of the jerk, in unit²/s⁵: in a second the acceleration
   *     wanders by √q
   */
  public WhiteJerk(int axes, double jerkDensity) {
    super(axes, 3);
    density = Require.notNegative("jerk density", jerkDensity);
  }

  @Override
  double noiseEntry(int row, int column, double dtS) {
    return density * integratedWhiteNoise(3, row, column, dtS);
  }
}
