package haltere.core.pipeline;

/**
 * Reaction to an exception of a filter or a sink.
 *
 * @since 0.1
 */
public enum OnFailure {
  /** The run stops and the exception is thrown to the caller. */
  STOP,
  /**
   * The stage is disabled, or the sink removed, and the run continues; the events of the packet are
   * counted as lost and reported by a {@code DataLost} in the stream.
   */
  GO_ON
}
