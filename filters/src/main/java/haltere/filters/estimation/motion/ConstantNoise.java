package haltere.filters.estimation.motion;

import haltere.filters.estimation.LinearProcessModel;
import haltere.filters.estimation.Require;
import org.ejml.data.DMatrixRMaj;

/**
 * A model with the same covariance added at every step, however long it is: the mode of the
 * original cluster filter (Q = q I per update). Its tuning depends on the rate of updates; prefer
 * the models' own densities.
 */
public final class ConstantNoise {
  private ConstantNoise() {}

  /**
   * A linear model with constant noise.
   *
   * @param model whose transition is kept
   * @param variance q, added to each entry's variance at each step, in the square of its unit
   * @return the model with Q = q I
   */
  public static LinearProcessModel perStep(LinearProcessModel model, double variance) {
    return new Linear(model, diagonal(model, variance));
  }

  private static DMatrixRMaj diagonal(LinearProcessModel model, double variance) {
    Require.notNegative("variance per step", variance);
    DMatrixRMaj q = new DMatrixRMaj(model.stateSize(), model.stateSize());
    for (int i = 0; i < q.numRows; i++) {
      q.set(i, i, variance);
    }
    return q;
  }

  private record Linear(LinearProcessModel model, DMatrixRMaj constant)
      implements LinearProcessModel {
    @Override
    public int stateSize() {
      return model.stateSize();
    }

    @Override
    public void transition(double dtS, DMatrixRMaj f) {
      model.transition(dtS, f);
    }

    @Override
    public void noise(double dtS, DMatrixRMaj q) {
      q.setTo(constant);
    }
  }
}
