package haltere.core.simulation;

import haltere.core.stream.EventSource;
import java.util.List;
import java.util.OptionalLong;

/**
 * A simulated source with ground truth. The ground truth is a pure function of time: it can be
 * queried for any time, in any order, before or after the events were pulled.
 *
 * <p>Thread rule: events are pulled by one thread at a time; the truth may be queried by any thread
 * at the same time.
 *
 * @param <T> the record of one row of ground truth; its component names are the columns
 * @since 0.1
 */
public interface Scene<T extends Record> extends EventSource {
  /**
   * The record of a row of truth.
   *
   * @return its class
   */
  Class<T> truthType();

  /**
   * The truth at a time.
   *
   * @param timeUs microseconds on the clock of the events
   * @return one row for each object of the scene that has a truth of its own
   */
  List<T> truthRows(long timeUs);

  /**
   * Start, length and rate of the truth.
   *
   * @return always the same
   */
  RunSettings run();

  /**
   * Rate at which the truth is written.
   *
   * @return hertz, greater than 0
   */
  default double truthRateHz() {
    return run().truthRateHz();
  }

  /**
   * Time of the beginning.
   *
   * @return microseconds; no event is earlier
   */
  default long startUs() {
    return run().startUs();
  }

  /**
   * Length of the scene.
   *
   * @return microseconds, or empty if it is endless
   */
  default OptionalLong durationUs() {
    return run().durationUs();
  }

  /**
   * Time of a row of truth.
   *
   * @param row from 0 on
   * @return microseconds, {@link #startUs()} for the first
   */
  default long truthTimeUs(long row) {
    return startUs() + Math.round(row * 1e6 / truthRateHz());
  }

  /** Does nothing. */
  @Override
  default void close() {}
}
