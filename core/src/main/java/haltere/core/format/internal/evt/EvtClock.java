package haltere.core.format.internal.evt;

/**
 * The high part of the time of EVT words, extended over wraps of the camera's clock.
 *
 * <p>Thread rule: one thread.
 */
final class EvtClock {
  private final int shift;
  private final int bits;
  private final int wrapFall;
  private long turnUs;
  private int high = -1;

  /**
   * A clock before its first value.
   *
   * @param shift bit position of the high part in the time
   * @param bits bits of the high part
   * @param wrapFall minimum decrease of the high part that is a wrap
   * @param firstTurnUs start time of the first period
   */
  EvtClock(int shift, int bits, int wrapFall, long firstTurnUs) {
    this.shift = shift;
    this.bits = bits;
    this.wrapFall = wrapFall;
    turnUs = firstTurnUs;
  }

  /** EVT2 and EVT2.1: a period is 2^34 us; a jump from its last second to its first is a wrap. */
  static EvtClock wide(long firstTurnUs) {
    return new EvtClock(6, 28, (1 << 28) - (1_000_000 >> 6), firstTurnUs);
  }

  /** EVT3: a period is 2^24 us; a decrease by half of it is a wrap. */
  static EvtClock narrow(long firstTurnUs) {
    return new EvtClock(12, 12, 2048, firstTurnUs);
  }

  /** Wrap period. */
  long turnLengthUs() {
    return 1L << (shift + bits);
  }

  /** Processes a high part; returns its start time. */
  long take(int value) {
    if (wraps(value)) {
      turnUs += turnLengthUs();
    }
    high = value;
    return startUs();
  }

  /** Whether a high part would be a wrap. */
  boolean wraps(int value) {
    return high - value >= wrapFall;
  }

  /** The largest decrease that is not a wrap. */
  int longestFall() {
    return wrapFall - 1;
  }

  /** The largest high part. */
  int last() {
    return (1 << bits) - 1;
  }

  /** The high part of a time. */
  int highOf(long timeUs) {
    return (int) (timeUs >> shift) & last();
  }

  /** The last high part, or -1 if there was none. */
  int high() {
    return high;
  }

  /** Start time of the last high part. */
  long startUs() {
    return turnUs + ((long) high << shift);
  }

  /** Start time of the current period. */
  long turnUs() {
    return turnUs;
  }

  /** Restores the state after a high part in a period. */
  void restore(long turn, int value) {
    turnUs = turn;
    high = value;
  }
}
