package haltere.core.format;

/**
 * A section of a recording in which the clock does not go back.
 *
 * @param firstUs time of its first event, or of its first sample if there are no events
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
   * Its duration.
   *
   * @return microseconds, at least 0
   */
  public long durationUs() {
    return lastUs - firstUs;
  }
}
