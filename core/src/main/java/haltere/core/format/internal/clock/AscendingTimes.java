package haltere.core.format.internal.clock;

import haltere.core.stream.StreamNotification;

/**
 * Times of a clock that does not wrap: a time before the last one begins a new segment.
 *
 * <p>Thread rule: one thread.
 */
public final class AscendingTimes extends EventTimes {
  /** Number of values that {@link #save} writes. */
  public static final int STATE_LONGS = 1;

  private long lastUs = StreamNotification.NO_TIME_US;

  /** The state before the first event. */
  public AscendingTimes() {}

  /**
   * Whether a time is before the last one. If so, it is saved as the start of the next segment.
   *
   * @param timeUs of the next event, microseconds
   * @return true if the event must wait for {@link #acceptRestart()}
   */
  public boolean goesBack(long timeUs) {
    if (timeUs >= lastUs) {
      return false;
    }
    hold(timeUs);
    return true;
  }

  /**
   * Advances to a time.
   *
   * @param timeUs time of the newest event, not before the last one
   */
  public void advance(long timeUs) {
    lastUs = timeUs;
  }

  @Override
  public int stateLongs() {
    return STATE_LONGS;
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = lastUs;
  }

  @Override
  public void restore(long[] state, int at) {
    releaseHeld();
    lastUs = state[at];
  }

  @Override
  public long lastUs() {
    return lastUs;
  }

  @Override
  void forget() {
    lastUs = StreamNotification.NO_TIME_US;
  }
}
