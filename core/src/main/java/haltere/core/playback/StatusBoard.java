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
  private long failures;

  // The displayed slice.
  private StepBackSearch.Position shown = new StepBackSearch.Position(0, 0);
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

  /** The last published snapshot. */
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

  /** Sets the last failure, in one line. */
  void setMessage(String line) {
    message = line;
    failures++;
  }

  /** Start of the displayed slice. */
  StepBackSearch.Position shown() {
    return shown;
  }

  /** Sets the position after a jump; no slice is displayed yet. */
  void setPosition(long elapsedUs) {
    shown = new StepBackSearch.Position(elapsedUs, 0);
    shownTimeUs = StreamNotification.NO_TIME_US;
  }

  /** Sets the displayed slice. */
  void setShown(long elapsedUs, int ties, long timeUs) {
    shown = new StepBackSearch.Position(elapsedUs, ties);
    shownTimeUs = timeUs;
  }

  /** Sets the length of the displayed slice, at its end. */
  void setShownLength(long lengthUs, long events) {
    shownLengthUs = lengthUs;
    shownEvents = events;
  }

  /** Whether a slice is displayed. */
  boolean isShown() {
    return shownTimeUs != StreamNotification.NO_TIME_US;
  }

  /** Length of the displayed slice, microseconds. */
  long shownLengthUs() {
    return shownLengthUs;
  }

  /** Number of events before the chain in the displayed slice. */
  long shownEvents() {
    return shownEvents;
  }

  /** Sets the rest of a run-up, microseconds of recording time. */
  void setRunUp(long leftUs) {
    runUpUs = leftUs;
  }

  /** Publishes a new snapshot. */
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
                + counters.get(Counter.EVENTS_AT_IMPOSSIBLE_TIMES)
                + counters.get(Counter.EVENTS_LOST_IN_FAILURE)
                + counters.get(Counter.EVENTS_LOST_BEFORE),
            shownLengthUs,
            runUpUs,
            message,
            failures);
  }
}
