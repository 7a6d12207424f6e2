package haltere.filters.wing.internal.original;

import haltere.filters.estimation.Angles;
import haltere.filters.estimation.GaussianState;
import haltere.filters.wing.WingNoiseSettings;
import haltere.filters.wing.internal.stroke.EdgeNoise;

/**
 * Process noise of the filter of an edge as in Cardinale (2006): the same at each update with a new
 * time, independent of the time step. The noise of phase and frequency is fully correlated. An
 * average of events has the time of the last one.
 */
public final class UpdateNoise implements EdgeNoise {
  private static final int AMPLITUDE = 1;
  private static final int PHASE = 2;
  private static final int OMEGA = 3;

  /** Initial correlation of phase and frequency: 1 in Cardinale (2006), but here regular. */
  private static final double START_COVARIANCE = 1 - 1e-9;

  /** The noise of Cardinale (2006). */
  public UpdateNoise() {}

  @Override
  public double[] of(WingNoiseSettings noise) {
    return new double[] {noise.centre(), noise.amplitude(), noise.phase(), noise.frequency()};
  }

  @Override
  public void add(GaussianState belief, double[] q, double dtS) {
    for (int i = 0; i < q.length; i++) {
      belief.addNoise(i, q[i]);
    }
    belief.addNoise(PHASE, OMEGA, Math.sqrt(q[PHASE] * q[OMEGA]));
  }

  /** {@inheritDoc} A stroke without an amplitude starts with 1 rad and the centre as its phase. */
  @Override
  public void launch(GaussianState belief) {
    EdgeNoise.super.launch(belief);
    belief.addNoise(PHASE, OMEGA, START_COVARIANCE);
    if (belief.mean(AMPLITUDE) == 0) {
      belief.setMean(AMPLITUDE, 1);
      belief.setMean(PHASE, Angles.wrapPi(belief.mean(0)));
    }
  }

  @Override
  public boolean isDensity() {
    return false;
  }
}
