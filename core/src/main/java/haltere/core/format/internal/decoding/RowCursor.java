package haltere.core.format.internal.decoding;

import haltere.core.format.RecordingClock;
import haltere.core.format.internal.clock.AscendingTimes;
import haltere.core.format.internal.clock.EventTimes;

/**
 * A cursor over events in numbered rows of columns. Its state is the next row and the last time.
 *
 * <p>Thread rule: one thread.
 */
public abstract class RowCursor implements EventCursor {
  /** Result of {@link #rounded} for a value that is no number of a column. */
  public static final long NO_NUMBER = Long.MIN_VALUE;

  private static final double RANGE = 0x1p63;

  /** Times of the rows. */
  protected final AscendingTimes times = new AscendingTimes();

  /** The next row, from 0. */
  protected long row;

  /**
   * Rounds a real number.
   *
   * @param value any number
   * @return the nearest integer, or {@link #NO_NUMBER} if the value is not finite or too large
   */
  public static long rounded(double value) {
    return Math.abs(value) < RANGE ? Math.round(value) : NO_NUMBER;
  }

  /**
   * The number of rows.
   *
   * @return as the file states it
   */
  protected abstract long rows();

  /**
   * The size of the file.
   *
   * @return bytes
   */
  protected abstract long fileBytes();

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.WRITERS_CHOICE);
  }

  @Override
  public EventTimes times() {
    return times;
  }

  /** {@inheritDoc} Proportional to the rows read. */
  @Override
  public long positionBytes() {
    long rows = rows();
    return row >= rows ? fileBytes() : (long) (fileBytes() * ((double) row / rows));
  }

  @Override
  public int stateLongs() {
    return 2;
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = row;
    times.save(state, at + 1);
  }

  @Override
  public void restore(long[] state, int at) {
    row = state[at];
    times.restore(state, at + 1);
  }
}
