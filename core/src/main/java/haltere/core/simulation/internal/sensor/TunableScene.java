package haltere.core.simulation.internal.sensor;

import haltere.core.simulation.Scene;

/**
 * A scene whose sensor can be tuned while it runs, as the biases of a camera can.
 *
 * <p>Thread rule: as {@link Scene#next}, one thread at a time.
 *
 * @param <T> the record of one row of ground truth
 */
public interface TunableScene<T extends Record> extends Scene<T> {
  /**
   * The tuning in effect.
   *
   * @return the settings' own until it is changed
   */
  SensorTuning tuning();

  /**
   * Changes the sensor for the events that are not made yet. The noisy pixels and the threshold
   * mismatch stay. The same changes at the same positions of the stream make the same events.
   *
   * @param tuning from now on
   */
  void tune(SensorTuning tuning);
}
