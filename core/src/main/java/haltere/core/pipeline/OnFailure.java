package haltere.core.pipeline;

/**
 * Reaction to an exception of a filter or a sink.
 *
 * @since 0.1
 */
public enum OnFailure {
  /** The run stops and the caller gets what was thrown. */
  STOP,
  /**
   * The stage is switched off, or the sink removed, and the run continues; the events of the packet
   * are counted as lost and a {@code DataLost} says so in the stream.
   */
  GO_ON
}
