package haltere.core.format.internal.clock;

import haltere.core.stream.StreamNotification;

/**
 * Times of a narrow clock that wraps ({@link WrappingClock} has the rule).
 *
 * <p>Thread rule: one thread.
 */
public final class WrappingTimes extends EventTimes {
  /** Number of values that {@link #save} writes. */
  public static final int STATE_LONGS = 2;

  private final WrappingClock clock;

  /**
   * The state before the first event.
   *
   * @param clock converts values of the file to times
   */
  public WrappingTimes(WrappingClock clock) {
    this.clock = clock;
  }

  /**
   * Accepts the time of the next event unless it is before the last one; then it is saved as the
   * start of the next segment.
   *
   * @param timeUs the last result of {@link WrappingClock#read}
   * @return false if the event must wait for {@link #acceptRestart()}
   */
  public boolean take(long timeUs) {
    if (clock.goesBack(timeUs)) {
      hold(timeUs);
      return false;
    }
    clock.take(timeUs);
    return true;
  }

  @Override
  public int stateLongs() {
    return STATE_LONGS;
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = clock.turnUs();
    state[at + 1] = lastUs();
  }

  @Override
  public void restore(long[] state, int at) {
    releaseHeld();
    if (state[at + 1] == StreamNotification.NO_TIME_US) {
      clock.reset(state[at]);
    } else {
      clock.resume(state[at], state[at + 1]);
    }
  }

  @Override
  public long lastUs() {
    return clock.started() ? clock.lastUs() : StreamNotification.NO_TIME_US;
  }

  @Override
  void forget() {
    clock.take(restartUs());
    clock.reset(clock.turnUs());
  }
}
