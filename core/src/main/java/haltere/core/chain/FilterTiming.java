package haltere.core.chain;

/**
 * Processor time and event counts of a stage so far.
 *
 * @param packets packets that went through
 * @param eventsIn received events
 * @param eventsOut passed events
 * @param busyNanos time spent in the filter
 * @since 0.1
 */
public record FilterTiming(long packets, long eventsIn, long eventsOut, long busyNanos) {
  /** A stage that has done nothing. */
  public static final FilterTiming NONE = new FilterTiming(0, 0, 0, 0);

  /**
   * Cost of the filter.
   *
   * @return microseconds per thousand events, 0 before the first event
   */
  public double microsPerThousandEvents() {
    return eventsIn == 0 ? 0 : busyNanos / (double) eventsIn;
  }

  /**
   * The difference to an earlier value.
   *
   * @param earlier an earlier value of the same stage
   * @return the difference
   */
  public FilterTiming since(FilterTiming earlier) {
    return new FilterTiming(
        packets - earlier.packets,
        eventsIn - earlier.eventsIn,
        eventsOut - earlier.eventsOut,
        busyNanos - earlier.busyNanos);
  }
}
