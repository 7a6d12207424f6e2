package haltere.core.format.internal.clock;

import haltere.core.stream.StreamNotification;

/**
 * Times of a narrow clock that turns ({@link WrappingClock} has the rule).
 *
 * <p>Thread rule: one thread.
 */
public final class WrappingTimes extends EventTimes {
  /** Number of values that {@link #save} writes. */
  public static final int STATE_LONGS = 2;

  private final WrappingClock clock;

  /**
   * Before the first event.
   *
   * @param clock what values of the file mean
   */
  public WrappingTimes(WrappingClock clock) {
    this.clock = clock;
  }

  /**
   * Takes the time that the clock gave for the next event, unless it is before the last one; then
   * it is kept as the start of the next segment.
   *
   * @param timeUs what {@link WrappingClock#read} gave last
   * @return false if the event must wait for {@link #acceptRestart()}
   */
  public boolean take(long timeUs) {
    if (clock.goesBack(timeUs)) {
      holdBack(timeUs);
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
    holdNothingBack();
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
