package haltere.filters.track;

/**
 * Regular times of a rate that need not divide a second, without drift: the n-th time of each
 * thousand seconds is at the rounded n-th multiple of the period. Thread rule: that of its owner.
 */
final class ReportClock {
  private static final long BLOCK_US = 1_000_000_000;

  private double rateHz = 1;
  private long blockUs;
  private long number;
  private long nextUs;

  /** The next time stays if it is in the future of the caller; it is on the new rate afterwards. */
  void setRate(double newRateHz) {
    rateHz = newRateHz;
    skipTo(nextUs);
  }

  /** Goes to the first time at or after a time. */
  void skipTo(long timeUs) {
    blockUs = Math.floorDiv(timeUs, BLOCK_US) * BLOCK_US;
    number = (long) Math.floor((timeUs - blockUs) * rateHz * 1e-6);
    place();
    while (nextUs < timeUs) {
      advance();
    }
  }

  long nextUs() {
    return nextUs;
  }

  void advance() {
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
