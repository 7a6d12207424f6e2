package haltere.core.format.internal.evt;

/**
 * The high part of the time of EVT words, continued over the turns of the camera's clock.
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
   * @param shift place of the high part within the time
   * @param bits bits of the high part
   * @param wrapFall a fall of the high part by as much, or more, is a new turn of the clock
   * @param firstTurnUs time at which the first turn begins
   */
  EvtClock(int shift, int bits, int wrapFall, long firstTurnUs) {
    this.shift = shift;
    this.bits = bits;
    this.wrapFall = wrapFall;
    turnUs = firstTurnUs;
  }

  /** EVT2 and EVT2.1: a turn is 2^34 us; from its last second to its first is a new turn. */
  static EvtClock wide(long firstTurnUs) {
    return new EvtClock(6, 28, (1 << 28) - (1_000_000 >> 6), firstTurnUs);
  }

  /** EVT3: a turn is 2^24 us; a fall by half of it is a new turn. */
  static EvtClock narrow(long firstTurnUs) {
    return new EvtClock(12, 12, 2048, firstTurnUs);
  }

  /** Length of a turn. */
  long turnLengthUs() {
    return 1L << (shift + bits);
  }

  /** Takes a high part; returns the time at which it begins. */
  long take(int value) {
    if (wraps(value)) {
      turnUs += turnLengthUs();
    }
    high = value;
    return startUs();
  }

  /** Whether a high part would be taken for a new turn. */
  boolean wraps(int value) {
    return high - value >= wrapFall;
  }

  /** The longest fall that is not taken for a new turn. */
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

  /** Time at which the last high part begins. */
  long startUs() {
    return turnUs + ((long) high << shift);
  }

  /** Time at which the current turn begins. */
  long turnUs() {
    return turnUs;
  }

  /** As after a high part in a turn. */
  void restore(long turn, int value) {
    turnUs = turn;
    high = value;
  }
}
