package haltere.filters.estimation.motion;

import haltere.filters.estimation.Require;

/**
 * State (s, v) per axis; the velocity is constant but for white acceleration.
 *
 * <pre>
 * F = [1 Δt; 0 1]     Q = q [Δt³/3 Δt²/2; Δt²/2 Δt]
 * </pre>
 *
 * <p>Bar-Shalom, Li and Kirubarajan (2001), eq. 6.2.2-8 and 6.2.2-12.
 */
public final class ConstantVelocity extends AxisBlocks {
  private final double density;

  /**
   * A model of several axes.
   *
   * @param axes at least 1; state (s₁, v₁, s₂, v₂, …)
   * @param accelerationDensity q, spectral density of the acceleration, in unit²/s³: in a second
   *     the velocity wanders by √q
   */
  public ConstantVelocity(int axes, double accelerationDensity) {
    super(axes, 2);
    density = Require.notNegative("acceleration density", accelerationDensity);
  }

  @Override
  double noiseEntry(int row, int column, double dtS) {
    return density * integratedWhiteNoise(2, row, column, dtS);
  }
}
