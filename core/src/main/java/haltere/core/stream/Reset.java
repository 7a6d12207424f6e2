package haltere.core.stream;

import java.util.Objects;

/**
 * Continuity ends here, for the stated cause; time may jump either way.
 *
 * @param cause why
 * @param lastUs time of the last event before, or {@link StreamNotification#NO_TIME_US}
 * @param nextUs time of the first event after, or {@link StreamNotification#NO_TIME_US}
 * @since 0.1
 */
public record Reset(Cause cause, long lastUs, long nextUs) implements StreamNotification {
  /** Why continuity ended. */
  public enum Cause {
    /** A person asked for it. */
    USER,
    /** Playback went back to its start or to the start of its loop. */
    REWIND,
    /** Playback jumped to another time. */
    SEEK,
    /** The source's own clock went back. */
    CLOCK_RESTARTED,
    /** Another source took the place of the last one without a new start of the stream. */
    SOURCE_CHANGED,
    /** A filter that was off is on again and has missed events. */
    RE_ENABLED
  }

  /** Checks that the cause is there. */
  public Reset {
    Objects.requireNonNull(cause, "cause");
  }

  /**
   * A reset whose neighbouring times are not known.
   *
   * @param cause why
   */
  public Reset(Cause cause) {
    this(cause, NO_TIME_US, NO_TIME_US);
  }

  /**
   * Whether a player went to another place of the stream, so that its events may come again.
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
