package haltere.core.format.internal.clock;

/**
 * The 32-bit clock of a writer: it predicts the times that a reader will reconstruct, which differ
 * after jumps too large for the clock ({@link WrappingClock} has the rule).
 *
 * <p>Thread rule: one thread.
 */
public final class WrittenClock {
  /** Wrap period. */
  public static final long TURN_US = 1L << 32;

  private final WrappingClock reader;
  private long shiftUs;
  private long leaps;

  /**
   * A clock before its first time.
   *
   * @param firstTurnUs offset of its times stated in the file
   */
  public WrittenClock(long firstTurnUs) {
    reader = new WrappingClock(TURN_US, firstTurnUs);
  }

  /**
   * Registers a written time.
   *
   * @param timeUs time of the event
   * @param written its low 32 bits as the format's readers see them, signed or not
   */
  public void take(long timeUs, long written) {
    long readUs = reader.read(written);
    reader.take(readUs);
    if (readUs - timeUs != shiftUs) {
      shiftUs = readUs - timeUs;
      leaps++;
    }
  }

  /**
   * Advances within a period, for times written without {@link #take}.
   *
   * @param timeUs the newest, less than half a period after the last one
   */
  public void advance(long timeUs) {
    reader.advance(timeUs + shiftUs);
  }

  /**
   * Whether a time was registered.
   *
   * @return true if {@link #lastUs()} is valid
   */
  public boolean started() {
    return reader.started();
  }

  /**
   * Start of the current period, on the clock of the events.
   *
   * @return microseconds
   */
  public long turnUs() {
    return reader.turnUs() - shiftUs;
  }

  /**
   * The newest time, on the clock of the events.
   *
   * @return microseconds
   */
  public long lastUs() {
    return reader.lastUs() - shiftUs;
  }

  /**
   * The jumps of time that are too large for the clock.
   *
   * @return their number
   */
  public long leaps() {
    return leaps;
  }
}
