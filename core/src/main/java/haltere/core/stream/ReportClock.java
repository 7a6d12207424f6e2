package haltere.core.stream;

/**
 * Regular times of reports at any rate, without drift: the n-th time of each thousand seconds is at
 * the rounded n-th multiple of the period. The times do not depend on the start of a stream or its
 * division into packets.
 *
 * <p>Thread rule: that of its owner.
 *
 * @since 0.1
 */
public final class ReportClock {
  private static final long BLOCK_US = 1_000_000_000;

  private double rateHz = 1;
  private long blockUs;
  private long number;
  private long nextUs;

  /** A clock of one report a second from time 0 on. */
  public ReportClock() {
    // the initial values of the fields
  }

  /**
   * Changes the rate. The next time is the first one of the new rate that is not before the next
   * time of the old one.
   *
   * @param newRateHz reports a second, above 0
   */
  public void setRate(double newRateHz) {
    rateHz = newRateHz;
    skipTo(nextUs);
  }

  /**
   * Goes to the first time at or after a time, forwards or backwards.
   *
   * @param timeUs microseconds
   */
  public void skipTo(long timeUs) {
    blockUs = Math.floorDiv(timeUs, BLOCK_US) * BLOCK_US;
    number = (long) Math.floor((timeUs - blockUs) * rateHz * 1e-6);
    place();
    while (nextUs < timeUs) {
      advance();
    }
  }

  /**
   * The time of the next report.
   *
   * @return microseconds
   */
  public long nextUs() {
    return nextUs;
  }

  /** Advances to the following time. */
  public void advance() {
    number++;
    place();
  }

  private void place() {
    long offsetUs = Math.round(number * 1e6 / rateHz);
    if (offsetUs >= BLOCK_US) {
      blockUs += BLOCK_US;
      number = 0;
      offsetUs = 0;
    }
    nextUs = blockUs + offsetUs;
  }
}
