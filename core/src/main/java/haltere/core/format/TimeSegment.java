package haltere.core.format;

/**
 * A stretch of a recording in which the clock does not go back.
 *
 * @param firstUs time of its first event, or of its first sample where there are no events
 * @param lastUs time of its last event or sample, not before the first
 * @since 0.1
 */
public record TimeSegment(long firstUs, long lastUs) {
  /** Checks the order. */
  public TimeSegment {
    if (lastUs < firstUs) {
      throw new IllegalArgumentException("a segment from " + firstUs + " to " + lastUs + " us");
    }
  }

  /**
   * Its length.
   *
   * @return microseconds, at least 0
   */
  public long durationUs() {
    return lastUs - firstUs;
  }
}
