package haltere.core.format.internal.clock;

import java.util.Optional;

/**
 * A clock of 32 bits as a writer uses it: what a reader will make of the times that it writes,
 * which is another time where they leap too far for such a clock ({@link WrappingClock} has the
 * rule).
 *
 * <p>Thread rule: one thread.
 */
public final class WrittenClock {
  /** Length of a turn. */
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
   * Takes a time that is written, wherever it leads.
   *
   * @param timeUs the event's
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
   * Moves on within a turn, where times are written without {@link #take}.
   *
   * @param timeUs the newest, less than half a turn behind the last one
   */
  public void advance(long timeUs) {
    reader.advance(timeUs + shiftUs);
  }

  /**
   * Whether a time was taken.
   *
   * @return true if {@link #lastUs()} means anything
   */
  public boolean started() {
    return reader.started();
  }

  /**
   * Start of the turn that the clock is in, on the clock of the events.
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
   * Losses of such a clock.
   *
   * @return a line for the user, or empty if nothing
   */
  public Optional<String> loss() {
    return leaps == 0
        ? Optional.empty()
        : Optional.of(
            leaps
                + " jumps of time are too long for the format's 32-bit clock; later times read "
                + "back shifted");
  }
}
