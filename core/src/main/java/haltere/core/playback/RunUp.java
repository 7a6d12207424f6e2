package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.pipeline.ChainRunner;

/**
 * The run-up to the target of a jump: processes the events before it, so that filters and slice
 * sinks have the same state as in playback.
 *
 * <p>Thread rule: the processing thread only.
 */
final class RunUp {
  private final SourceCursor cursor;
  private final ChainRunner runner;
  private final EventTies ties;
  private final PlaybackMeter meter;
  private boolean open;
  private long targetUs;
  private long reachedUs;
  private int tiesLeft;

  RunUp(SourceCursor cursor, ChainRunner runner, EventTies ties, PlaybackMeter meter) {
    this.cursor = cursor;
    this.runner = runner;
    this.ties = ties;
    this.meter = meter;
  }

  /** Begins a run-up with the next element of the cursor. */
  void open(long fromUs, StepBackSearch.Position target) {
    open = true;
    reachedUs = fromUs;
    targetUs = target.elapsedUs();
    tiesLeft = target.ties();
  }

  /** Cancels the run-up. */
  void cancel() {
    open = false;
  }

  /** Whether a run-up is under way. */
  boolean isOpen() {
    return open;
  }

  /** Target of the run-up on the elapsed timeline. */
  long targetUs() {
    return targetUs;
  }

  /** Recording time until the target, microseconds. */
  long leftUs() {
    return open ? Math.max(0, targetUs - reachedUs) : 0;
  }

  /** Processes the next piece; false when the target has been reached. */
  boolean advance(SourceCursor.Ahead ahead) {
    if (ahead == SourceCursor.Ahead.NOTIFICATION) {
      runner.notified(cursor.takeNotification());
      return true;
    }
    if (ahead == SourceCursor.Ahead.SAMPLE
        && cursor.sampleElapsedUs() < targetUs + Math.min(tiesLeft, 1)) {
      runner.sample(cursor.takeSample());
      return true;
    }
    if (ahead == SourceCursor.Ahead.EVENTS) {
      int count = Math.min(cursor.countBefore(targetUs), PlaybackEngine.CHUNK_EVENTS);
      if (count == 0 && tiesLeft > 0) {
        count = 1;
        tiesLeft--;
      }
      if (count > 0) {
        EventPacket piece = cursor.take(count);
        ties.handOver(piece, cursor.offsetUs());
        meter.handOver(piece, cursor.offsetUs());
        reachedUs = piece.lastTimeUs() + cursor.offsetUs();
        runner.packet(piece);
        return true;
      }
    }
    open = false;
    return false;
  }
}
