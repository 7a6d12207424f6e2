package haltere.filters.estimation;

import org.ejml.data.DMatrixRMaj;

/**
 * The edge of a beating wing, as the tests' example of a non-linear model: state (a, M, ξ, ω),
 * measured angle a + M sin ξ.
 */
final class WingEdge implements LinearProcessModel {
  private final double[] densities;

  WingEdge(double... densities) {
    this.densities = densities;
  }

  @Override
  public int stateSize() {
    return 4;
  }

  @Override
  public void transition(double dtS, DMatrixRMaj f) {
    f.zero();
    for (int i = 0; i < 4; i++) {
      f.set(i, i, 1);
    }
    f.set(2, 3, dtS);
  }

  @Override
  public void noise(double dtS, DMatrixRMaj q) {
    q.zero();
    for (int i = 0; i < 4; i++) {
      q.set(i, i, densities[i] * dtS);
    }
  }

  /** The measured angle. */
  record Angle(double variance, Gate gate) implements MeasurementModel {
    @Override
    public int size() {
      return 1;
    }

    @Override
    public void expected(DMatrixRMaj x, DMatrixRMaj z) {
      z.set(0, 0, x.get(0) + x.get(1) * Math.sin(x.get(2)));
    }

    @Override
    public void jacobian(DMatrixRMaj x, DMatrixRMaj h) {
      h.set(0, 0, 1);
      h.set(0, 1, Math.sin(x.get(2)));
      h.set(0, 2, x.get(1) * Math.cos(x.get(2)));
      h.set(0, 3, 0);
    }

    @Override
    public void noise(DMatrixRMaj x, DMatrixRMaj r) {
      r.set(0, 0, variance);
    }

    @Override
    public void residual(DMatrixRMaj z, DMatrixRMaj expected, DMatrixRMaj y) {
      y.set(0, 0, Angles.wrapPi(z.get(0) - expected.get(0)));
    }
  }
}
