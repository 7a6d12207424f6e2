package haltere.core.format;

/**
 * Metadata of a recording without decoding its events: from a table of its packets, or the lengths
 * and ends of its columns. Events that reading skips, off the sensor or in damaged bytes, count
 * here.
 *
 * <p>Thread rule: immutable.
 *
 * @param events number of events
 * @param firstUs time of the first event in microseconds, 0 without events
 * @param lastUs time of the last event in microseconds, 0 without events; before {@code firstUs} if
 *     the clock was set back
 * @since 0.1
 */
public record RecordingOutline(long events, long firstUs, long lastUs) {
  /** Of a recording without events. */
  public static final RecordingOutline NOTHING = new RecordingOutline(0, 0, 0);

  /** Checks. */
  public RecordingOutline {
    if (events < 0) {
      throw new IllegalArgumentException(events + " events");
    }
  }

  /**
   * The outline of this recording and its continuation.
   *
   * @param next the continuation
   * @return of both
   */
  public RecordingOutline and(RecordingOutline next) {
    if (events == 0) {
      return next;
    }
    return next.events == 0
        ? this
        : new RecordingOutline(Math.addExact(events, next.events), firstUs, next.lastUs);
  }
}
