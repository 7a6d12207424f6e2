package haltere.filters.estimation.motion;

import haltere.filters.estimation.LinearProcessModel;
import haltere.filters.estimation.Require;
import org.ejml.data.DMatrixRMaj;

/**
 * A linear model of several axes that move alike and independently: the state is (s, v, …) of the
 * first axis, then of the second. A subclass gives the block of one axis.
 */
abstract sealed class AxisBlocks implements LinearProcessModel
    permits ConstantVelocity, ConstantAcceleration, WhiteJerk {
  private final int axes;
  private final int order;

  AxisBlocks(int axes, int order) {
    this.axes = Require.atLeast("axes", 1, axes);
    this.order = order;
  }

  /** Entry of one axis's Q(Δt). */
  abstract double noiseEntry(int row, int column, double dtS);

  @Override
  public final int stateSize() {
    return axes * order;
  }

  /** Taylor: s ← s + v Δt + a Δt²/2. */
  @Override
  public final void transition(double dtS, DMatrixRMaj f) {
    f.zero();
    for (int start = 0; start < stateSize(); start += order) {
      for (int i = 0; i < order; i++) {
        double entry = 1;
        for (int j = i; j < order; j++) {
          f.set(start + i, start + j, entry);
          entry *= dtS / (j - i + 1);
        }
      }
    }
  }

  @Override
  public final void noise(double dtS, DMatrixRMaj q) {
    q.zero();
    for (int start = 0; start < stateSize(); start += order) {
      for (int i = 0; i < order; i++) {
        for (int j = 0; j < order; j++) {
          q.set(start + i, start + j, noiseEntry(i, j, dtS));
        }
      }
    }
  }

  /**
   * Entry of the covariance that white noise of density 1 at the last of {@code order} integrators
   * leaves after a time, as the integral of Δtⁱ Δtʲ / (i! j!).
   */
  static double integratedWhiteNoise(int order, int row, int column, double dtS) {
    int i = order - 1 - row;
    int j = order - 1 - column;
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
