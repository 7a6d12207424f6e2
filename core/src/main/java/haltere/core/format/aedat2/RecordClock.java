package haltere.core.format.aedat2;

/**
 * Continues a signed 32-bit clock of microseconds as 64 bits. With D the difference of two
 * successive values of the file:
 *
 * <ul>
 *   <li>D at least 0: time goes on by D;
 *   <li>D below -2<sup>31</sup>: the clock has wrapped, time goes on by D + 2<sup>32</sup>;
 *   <li>any other D: the clock went back. By a second at the most, that is disorder within the same
 *       turn of the clock; by more, the camera's clock was set anew and the first turn begins
 *       again;
 *   <li>one exception: shortly after a wrap, a D so large that it leads back to at most a second
 *       before it is an event from before the wrap that comes late, not a leap of 71 minutes.
 * </ul>
 *
 * <p>A restart to zero of a clock that stood below zero looks like time going on, and a silence of
 * more than 35 minutes across a wrap like a restart: 32 bits do not say.
 *
 * <p>Thread rule: one thread.
 */
final class RecordClock {
  private static final long WRAP_US = 1L << 32;
  private static final long HALF_US = 1L << 31;
  private static final long DISORDER_US = 1_000_000;

  private final long firstTurnUs;
  private long turnUs;
  private long lastUs;
  private boolean started;
  private long nextTurnUs;

  /**
   * A clock before its first value.
   *
   * @param firstTurnUs what to add to values before the first wrap
   */
  RecordClock(long firstTurnUs) {
    this.firstTurnUs = firstTurnUs;
    reset(firstTurnUs);
  }

  /** Forgets the last value; values from now on belong to the given turn. */
  void reset(long turn) {
    turnUs = turn;
    started = false;
  }

  /** As after a value whose time was {@code last}. */
  void resume(long turn, long last) {
    turnUs = turn;
    lastUs = last;
    started = true;
  }

  /**
   * What the next value means. If it is {@link #goesBack before} the last one, the clock went back.
   */
  long read(int value) {
    nextTurnUs = turnUs;
    if (!started) {
      return turnUs + value;
    }
    long step = value - (lastUs - turnUs);
    if (step < -HALF_US) {
      nextTurnUs = turnUs + WRAP_US;
    } else if (step < -DISORDER_US) {
      nextTurnUs = firstTurnUs;
    } else if (step > HALF_US && turnUs > firstTurnUs && WRAP_US - step <= DISORDER_US) {
      nextTurnUs = turnUs - WRAP_US;
    }
    return nextTurnUs + value;
  }

  /** Whether a time that {@link #read} gave is before the last one. */
  boolean goesBack(long timeUs) {
    return started && timeUs < lastUs;
  }

  /** Takes the time that {@link #read} gave last as the newest, wherever it leads. */
  void take(long timeUs) {
    turnUs = nextTurnUs;
    lastUs = timeUs;
    started = true;
  }

  /** Moves on within a turn. */
  void advance(long timeUs) {
    lastUs = timeUs;
  }

  boolean started() {
    return started;
  }

  long turnUs() {
    return turnUs;
  }

  long lastUs() {
    return lastUs;
  }
}
