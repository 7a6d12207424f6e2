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
 * <p>Only sources and the chain make notifications. Whoever does not know one ignores it and the
 * chain passes it on. {@link EndOfStream} means: give out what you hold. {@link Reset} means:
 * forget it.
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
   * Whether what comes after this has no relation in time to what came before, so that a filter's
   * memory of it is worth nothing.
   *
   * @return true if a filter without better knowledge should reset itself
   */
  boolean endsContinuity();
}
