package haltere.core.playback;

/**
 * The state of a player: an immutable snapshot, replaced after every slice and every command.
 *
 * @param state whether it plays
 * @param elapsedUs start of the displayed slice on the elapsed timeline, microseconds; at the end
 *     the duration
 * @param timeUs the same on the source's clock, or {@link
 *     haltere.core.stream.StreamNotification#NO_TIME_US} before the first slice
 * @param durationUs length of the elapsed timeline, -1 if it has no end
 * @param speed requested recording time per real time, infinite for as fast as possible
 * @param achievedSpeed recording time per real time of the last half second or so, 0 when paused
 * @param lagUs real time by which playback is behind its clock since it last started, jumped or
 *     changed its speed, microseconds; 0 at unlimited speed
 * @param slowestStage name of the stage of the chain that took most of the time of the last half
 *     second or so, empty if none took any
 * @param sourceShare share of the real time of the last half second or so for reading, decoding or
 *     simulating, 0 to 1; 0 when paused
 * @param eventsIn events that went to the chain since the start
 * @param eventsOut events that came out of it
 * @param eventRateEps events into the chain per second of recording time, over the last 50 ms or so
 *     of it
 * @param droppedEvents lost events: off the sensor, lost by the source, or in the packet at which a
 *     filter failed
 * @param sliceUs length of the displayed slice, microseconds
 * @param runUpUs recording time of the rest of a run-up until the requested moment is displayed,
 *     microseconds; 0 without a run-up
 * @param message the last failure in one line, or empty
 * @param failures number of failures since the start, which tells a repeated one from the last
 * @since 0.1
 */
public record PlayerStatus(
    State state,
    long elapsedUs,
    long timeUs,
    long durationUs,
    double speed,
    double achievedSpeed,
    long lagUs,
    String slowestStage,
    double sourceShare,
    long eventsIn,
    long eventsOut,
    double eventRateEps,
    long droppedEvents,
    long sliceUs,
    long runUpUs,
    String message,
    long failures) {
  /** Real time by which playback may be late before it is {@link #late()}, microseconds. */
  public static final long LATE_US = 100_000;

  /** States of a player. */
  public enum State {
    /** Slices follow each other as the clock says. */
    PLAYING,
    /** Waiting for a command. */
    PAUSED,
    /** The source has come to its end. */
    ENDED,
    /** The source can no longer be read. */
    FAILED
  }

  /**
   * Whether playback cannot keep up.
   *
   * @return true if playback lags by more than {@link #LATE_US}
   */
  public boolean late() {
    return lagUs > LATE_US;
  }

  /**
   * Whether playback waits mainly for its source. If it is {@link #late()}, a faster chain does not
   * help.
   *
   * @return true if the source takes more than half of the time
   */
  public boolean sourceIsSlowest() {
    return sourceShare > 0.5;
  }
}
