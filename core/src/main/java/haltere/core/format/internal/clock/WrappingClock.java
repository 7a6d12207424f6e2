package haltere.core.format.internal.clock;

/**
 * Extends a narrow clock of microseconds to 64 bits. With W the wrap period of the clock
 * (2<sup>32</sup> for a clock of 32 bits, signed or not) and D the difference of two successive
 * values of the file:
 *
 * <ul>
 *   <li>D at least 0: time continues by D;
 *   <li>D below -W/2: the clock has wrapped, time continues by D + W;
 *   <li>any other D: the clock went back. By a second at most, that is disorder within the same
 *       period; by more, the camera's clock was reset and the first period starts again;
 *   <li>one exception: shortly after a wrap, a D so large that it leads back to at most a second
 *       before it is a late event from before the wrap, not a jump of almost W.
 * </ul>
 *
 * <p>Two cases are ambiguous: a restart to zero of a signed clock below zero looks like advancing
 * time, and a gap of more than W/2 across a wrap like a restart.
 *
 * <p>Thread rule: one thread.
 */
public final class WrappingClock {
  private static final long DISORDER_US = 1_000_000;

  private final long wrapUs;
  private final long firstTurnUs;
  private long turnUs;
  private long lastUs;
  private boolean started;
  private long nextTurnUs;

  /**
   * A clock before its first value.
   *
   * @param wrapUs wrap period
   * @param firstTurnUs offset of values before the first wrap
   */
  public WrappingClock(long wrapUs, long firstTurnUs) {
    this.wrapUs = wrapUs;
    this.firstTurnUs = firstTurnUs;
    reset(firstTurnUs);
  }

  /**
   * Clears the last value.
   *
   * @param turn offset of the values from now on
   */
  public void reset(long turn) {
    turnUs = turn;
    started = false;
  }

  /**
   * Continues after a value.
   *
   * @param turn its offset
   * @param last its time
   */
  public void resume(long turn, long last) {
    turnUs = turn;
    lastUs = last;
    started = true;
  }

  /**
   * The time of the next value. If it is {@link #goesBack before} the last one, the clock went
   * back.
   *
   * @param value from the file
   * @return its time
   */
  public long read(long value) {
    nextTurnUs = turnUs;
    if (!started) {
      return turnUs + value;
    }
    long step = value - (lastUs - turnUs);
    if (step < -wrapUs / 2) {
      nextTurnUs = turnUs + wrapUs;
    } else if (step < -DISORDER_US) {
      nextTurnUs = firstTurnUs;
    } else if (step > wrapUs / 2 && turnUs > firstTurnUs && wrapUs - step <= DISORDER_US) {
      nextTurnUs = turnUs - wrapUs;
    }
    return nextTurnUs + value;
  }

  /**
   * Whether a time of {@link #read} is before the last one.
   *
   * @param timeUs its result
   * @return true if the clock went back
   */
  public boolean goesBack(long timeUs) {
    return started && timeUs < lastUs;
  }

  /**
   * Sets the last time of {@link #read} as the newest.
   *
   * @param timeUs its result
   */
  public void take(long timeUs) {
    turnUs = nextTurnUs;
    lastUs = timeUs;
    started = true;
  }

  /**
   * Advances within a period.
   *
   * @param timeUs the newest time
   */
  public void advance(long timeUs) {
    lastUs = timeUs;
  }

  /**
   * Whether there was a value since the start or the last reset.
   *
   * @return true if {@link #lastUs()} is valid
   */
  public boolean started() {
    return started;
  }

  /**
   * The current offset of the values.
   *
   * @return microseconds
   */
  public long turnUs() {
    return turnUs;
  }

  /**
   * The newest time.
   *
   * @return microseconds
   */
  public long lastUs() {
    return lastUs;
  }
}
