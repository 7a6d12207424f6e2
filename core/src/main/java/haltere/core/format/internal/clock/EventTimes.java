package haltere.core.format.internal.clock;

/**
 * The current time of a decoder. Times ascend within a segment; if the clock goes back, the earlier
 * event is held back until the new segment is accepted.
 *
 * <p>Thread rule: one thread.
 */
public abstract sealed class EventTimes permits AscendingTimes, WrappingTimes {
  private boolean restarted;
  private long restartUs;

  EventTimes() {}

  /**
   * Time of the last event.
   *
   * @return microseconds, or {@link haltere.core.stream.StreamNotification#NO_TIME_US} before the
   *     first of a segment
   */
  public abstract long lastUs();

  /**
   * Number of values that {@link #save} writes.
   *
   * @return at least 1
   */
  public abstract int stateLongs();

  /**
   * Saves the state.
   *
   * @param state receives {@link #stateLongs()} values
   * @param at index of the first of them
   */
  public abstract void save(long[] state, int at);

  /**
   * Restores a saved state.
   *
   * @param state the values
   * @param at index of the first of them
   */
  public abstract void restore(long[] state, int at);

  /** Clears the last time at the start of a segment. */
  abstract void forget();

  /**
   * Whether the clock goes back with the next event.
   *
   * @return true until that is {@link #acceptRestart() accepted}
   */
  public final boolean restarted() {
    return restarted;
  }

  /**
   * Time of the first event of the new segment, if the clock goes back.
   *
   * @return microseconds
   */
  public final long restartUs() {
    return restartUs;
  }

  /**
   * Continues after the clock went back, with the last time cleared.
   *
   * @throws IllegalStateException if it did not
   */
  public final void acceptRestart() {
    if (!restarted) {
      throw new IllegalStateException("the clock did not go back");
    }
    restarted = false;
    forget();
  }

  /**
   * Whether the event with which the clock goes back is only late, see {@link EventOrder}.
   *
   * @return false for a restart
   */
  public final boolean isLate() {
    return EventOrder.isLate(lastUs(), restartUs);
  }

  /** Holds back an event with which the clock goes back. */
  final void hold(long timeUs) {
    restarted = true;
    restartUs = timeUs;
  }

  /** Clears the held event when a saved state is restored. */
  final void releaseHeld() {
    restarted = false;
  }
}
