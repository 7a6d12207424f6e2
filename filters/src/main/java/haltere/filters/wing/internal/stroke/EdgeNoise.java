package haltere.filters.wing.internal.stroke;

import haltere.filters.estimation.GaussianState;
import haltere.filters.wing.WingNoiseSettings;

/**
 * Initial covariance and process noise of the filter of an edge: a spectral density, unless an
 * implementation overrides it. Entries of the state: centre, amplitude, phase, angular frequency.
 */
public interface EdgeNoise {
  /** Process noise as a density. */
  EdgeNoise DENSITY = new EdgeNoise() {};

  /**
   * Process noise by the settings.
   *
   * @param noise the settings
   * @return of each entry, in its unit squared a second; the frequency with a twentieth of the
   *     noise of manoeuvres, which a filter of an edge does not detect
   */
  default double[] of(WingNoiseSettings noise) {
    double frequency = noise.frequency() + 0.05 * noise.manoeuvre();
    return new double[] {noise.centre(), noise.amplitude(), noise.phase(), frequency};
  }

  /**
   * Adds the process noise of a prediction.
   *
   * @param belief predicted state, without noise
   * @param q of each entry
   * @param dtS time step, seconds, positive
   */
  default void add(GaussianState belief, double[] q, double dtS) {
    for (int i = 0; i < q.length; i++) {
      belief.addNoise(i, q[i] * dtS);
    }
    belief.addNoise(2, q[3] * dtS * dtS * dtS / 3);
    belief.addNoise(2, 3, q[3] * dtS * dtS / 2);
  }

  /**
   * Sets the covariance at the launch.
   *
   * @param belief its covariance is overwritten
   */
  default void launch(GaussianState belief) {
    belief.setVariances(1, 1e-9, 1, 1);
  }

  /**
   * {@return whether the process noise is a density, so that an average of events has the mean of
   * their times; with noise per update it has the last time}
   */
  default boolean isDensity() {
    return true;
  }
}
