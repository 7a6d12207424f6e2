package haltere.filters.estimation.motion;

import haltere.filters.estimation.Require;

/**
 * State (s, v, a) per axis; the acceleration is a constant to be found, and white acceleration
 * comes on top of it: gravity with gusts.
 *
 * <pre>
 * F = [1 Δt Δt²/2; 0 1 Δt; 0 0 1]     Q = q [Δt³/3 Δt²/2 0; Δt²/2 Δt 0; 0 0 0]
 * </pre>
 *
 * <p>With a density of 0 the filter is the least-squares parabola. An acceleration that changes is
 * {@link WhiteJerk}.
 */
public final class ConstantAcceleration extends AxisBlocks {
  private final double density;

  /**
   * A model of several axes.
   *
   * @param axes at least 1; state (s₁, v₁, a₁, s₂, …)
   * @param accelerationDensity q, spectral density of the acceleration beside the constant one, in
   *     unit²/s³
   */
  public ConstantAcceleration(int axes, double accelerationDensity) {
    super(axes, 3);
    density = Require.notNegative("acceleration density", accelerationDensity);
  }

  @Override
  double noiseEntry(int row, int column, double dtS) {
    return density * integratedWhiteNoise(2, row, column, dtS);
  }
}
