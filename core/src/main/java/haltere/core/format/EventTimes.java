package haltere.core.format;

/**
 * Where a decoder is in time. Times ascend within a segment; where the clock goes back, the event
 * that is earlier is held back until the new segment is accepted.
 *
 * <p>Thread rule: one thread.
 */
public interface EventTimes {
  /**
   * Time of the last event.
   *
   * @return microseconds, or {@link haltere.core.stream.StreamNotification#NO_TIME_US} before the
   *     first of a segment
   */
  long lastUs();

  /**
   * Whether the clock goes back with the next event.
   *
   * @return true until that is {@link #acceptRestart() accepted}
   */
  boolean restarted();

  /**
   * Time of the first event of the new segment, where the clock goes back.
   *
   * @return microseconds
   */
  long restartUs();

  /**
   * Goes on after the clock went back, without memory of the last time.
   *
   * @throws IllegalStateException if it did not
   */
  void acceptRestart();
}
