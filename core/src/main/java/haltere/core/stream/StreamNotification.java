package haltere.core.stream;

/**
 * Notifications of a stream, in order with its packets.
 *
 * <p>The grammar of a stream:
 *
 * <pre>
 * stream   = StreamStarted item* DeviceLost? EndOfStream
 * item     = packet | sample | Reset | DataLost
 * </pre>
 *
 * <p>Exactly one {@link EndOfStream} ends a stream and nothing follows it until the next {@link
 * StreamStarted}. A {@link Reset} or {@link DataLost} stands before the packet that it concerns:
 * the packets before it are from before the break, those after it from after. Times never descend
 * from one packet to the next unless a notification that {@link #endsContinuity() ends continuity}
 * stands between them. {@link StreamGrammar} checks all of this.
 *
 * <p>Only sources and the chain create notifications. A filter ignores unknown ones; the chain
 * passes them on. {@link EndOfStream} means: publish what is buffered. {@link Reset} means: return
 * to the initial state.
 *
 * <p>Thread rule: immutable; delivered on the processing thread.
 *
 * @since 0.1
 */
public sealed interface StreamNotification
    permits StreamStarted, Reset, DataLost, DeviceLost, EndOfStream {
  /** Stands for a time that is not known. */
  long NO_TIME_US = Long.MIN_VALUE;

  /**
   * Whether events after this have no relation in time to those before, which invalidates the state
   * of filters.
   *
   * @return true if a filter should reset itself by default
   */
  boolean endsContinuity();

  /**
   * Whether events after this are of another time, so that what was made of those before is
   * obsolete: as {@link #endsContinuity()}, except that time goes on after lost data.
   *
   * @return true if a picture of the events should be cleared
   */
  default boolean restartsTime() {
    return endsContinuity();
  }
}
