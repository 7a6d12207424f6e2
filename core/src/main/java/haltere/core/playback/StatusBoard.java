package haltere.core.playback;

import haltere.core.pipeline.PipelineCounters;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.StreamNotification;

/**
 * The status of a player: collects changes and publishes immutable snapshots.
 *
 * <p>Thread rule: {@link #status()} from any thread, the rest on the processing thread only.
 */
final class StatusBoard {
  private final Playable playable;
  private final SliceCutter slices;
  private final PlaybackPace pace;
  private final PipelineCounters counters;
  private State state;
  private String message = "";

  // The slice that was shown last.
  private StepBackSearch.Place shown = new StepBackSearch.Place(0, 0);
  private long shownTimeUs = StreamNotification.NO_TIME_US;
  private long shownLengthUs;
  private long shownEvents;
  private long runUpUs;

  private volatile PlayerStatus status;

  StatusBoard(
      Playable playable,
      SliceCutter slices,
      PlaybackPace pace,
      PipelineCounters counters,
      State state) {
    this.playable = playable;
    this.slices = slices;
    this.pace = pace;
    this.counters = counters;
    this.state = state;
    publish();
  }

  /** The reading that was put up last. */
  PlayerStatus status() {
    return status;
  }

  State state() {
    return state;
  }

  boolean playing() {
    return state == State.PLAYING;
  }

  void setState(State newState) {
    state = newState;
  }

  /** Something failed, in one line. */
  void setMessage(String line) {
    message = line;
  }

  /** Where the slice starts that is shown. */
  StepBackSearch.Place shown() {
    return shown;
  }

  /** The player is somewhere; nothing of it is shown yet. */
  void setPlace(long elapsedUs) {
    shown = new StepBackSearch.Place(elapsedUs, 0);
    shownTimeUs = StreamNotification.NO_TIME_US;
  }

  /** A slice is shown from now on. */
  void setShown(long elapsedUs, int ties, long timeUs) {
    shown = new StepBackSearch.Place(elapsedUs, ties);
    shownTimeUs = timeUs;
  }

  /** The slice that is shown has ended. */
  void setShownLength(long lengthUs, long events) {
    shownLengthUs = lengthUs;
    shownEvents = events;
  }

  /** Whether a slice is shown. */
  boolean isShown() {
    return shownTimeUs != StreamNotification.NO_TIME_US;
  }

  /** Length of the slice that is shown, microseconds. */
  long shownLengthUs() {
    return shownLengthUs;
  }

  /** Events before the chain in the slice that is shown. */
  long shownEvents() {
    return shownEvents;
  }

  /** So much of a run-up is still to come, microseconds of recording time. */
  void setRunUp(long leftUs) {
    runUpUs = leftUs;
  }

  /** Puts up a new reading. */
  void publish() {
    PlaybackMeter meter = pace.meter();
    status =
        new PlayerStatus(
            state,
            state == State.ENDED ? slices.position() : shown.elapsedUs(),
            shownTimeUs,
            playable.durationUs().orElse(-1),
            pace.speed(),
            meter.speed(),
            pace.lagUs(),
            meter.slowestStage(),
            meter.sourceShare(),
            counters.get(Counter.EVENTS_IN),
            counters.get(Counter.EVENTS_OUT),
            meter.eventRateEps(),
            counters.get(Counter.EVENTS_OUTSIDE_SENSOR)
                + counters.get(Counter.EVENTS_LOST_IN_FAILURE)
                + counters.get(Counter.EVENTS_LOST_BEFORE),
            shownLengthUs,
            runUpUs,
            message);
  }
}
