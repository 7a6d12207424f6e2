package haltere.core.stream;

import java.util.Objects;

/**
 * A discontinuity; time may jump in both directions.
 *
 * @param cause of the discontinuity
 * @param lastUs time of the last event before, or {@link StreamNotification#NO_TIME_US}
 * @param nextUs time of the first event after, or {@link StreamNotification#NO_TIME_US}
 * @since 0.1
 */
public record Reset(Cause cause, long lastUs, long nextUs) implements StreamNotification {
  /** Cause of a discontinuity. */
  public enum Cause {
    /** Requested by the user. */
    USER,
    /** Playback went back to its start or to the start of its loop. */
    REWIND,
    /** Playback jumped to another time. */
    SEEK,
    /** The source's own clock went back. */
    CLOCK_RESTARTED,
    /** Another source replaced the last one without a new start of the stream. */
    SOURCE_CHANGED,
    /** A filter that was off is on again and has missed events. */
    RE_ENABLED
  }

  /** Checks that the cause is not null. */
  public Reset {
    Objects.requireNonNull(cause, "cause");
  }

  /**
   * A reset whose neighbouring times are not known.
   *
   * @param cause of the discontinuity
   */
  public Reset(Cause cause) {
    this(cause, NO_TIME_US, NO_TIME_US);
  }

  /**
   * Whether a player jumped in the stream, so that its events may be repeated.
   *
   * @return true for a seek and a rewind
   */
  public boolean isJump() {
    return cause == Cause.SEEK || cause == Cause.REWIND;
  }

  @Override
  public boolean endsContinuity() {
    return true;
  }
}
