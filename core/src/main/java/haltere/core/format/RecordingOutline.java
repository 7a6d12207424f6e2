package haltere.core.format;

/**
 * Metadata of a recording without decoding its events: from a table of its packets, or from the
 * lengths and last values of its columns. It includes events that reading skips, which are outside
 * the sensor or in damaged bytes.
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
  /** Outline of a recording without events. */
  public static final RecordingOutline NOTHING = new RecordingOutline(0, 0, 0);

  /** Checks the values. */
  public RecordingOutline {
    if (events < 0) {
      throw new IllegalArgumentException(events + " events");
    }
  }

  /**
   * The outline of this recording together with its continuation.
   *
   * @param next the continuation
   * @return the outline of both
   */
  public RecordingOutline plus(RecordingOutline next) {
    if (events == 0) {
      return next;
    }
    return next.events == 0
        ? this
        : new RecordingOutline(Math.addExact(events, next.events), firstUs, next.lastUs);
  }
}
