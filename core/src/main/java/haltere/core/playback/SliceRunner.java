package haltere.core.playback;

import haltere.core.event.EventPacket;
import haltere.core.pipeline.ChainRunner;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import java.io.IOException;

/**
 * Takes what is ahead in the source through the chain, slice by slice, in turns that are short:
 * hand one piece over, end a slice, go back to the start of a loop.
 *
 * <p>Places are on the elapsed timeline, in microseconds. Thread rule: the processing thread only.
 */
final class SliceRunner {
  private final Playable playable;
  private final SourceCursor cursor;
  private final ChainRunner runner;
  private final SliceCutter slices;
  private final PlaybackPace pace;
  private final StatusBoard board;
  private final AwaitedRequests awaited;
  private final EventTies ties = new EventTies();
  private final RunUp runUp;

  // A jump whose notification is still to be given, before whatever comes next.
  private Reset.Cause pendingBreak = Reset.Cause.REWIND;

  SliceRunner(
      Playable playable,
      SourceCursor cursor,
      ChainRunner runner,
      SliceCutter slices,
      PlaybackPace pace,
      StatusBoard board,
      AwaitedRequests awaited) {
    this.playable = playable;
    this.cursor = cursor;
    this.runner = runner;
    this.slices = slices;
    this.pace = pace;
    this.board = board;
    this.awaited = awaited;
    runUp = new RunUp(cursor, runner, ties);
  }

  // ---- Elsewhere

  /**
   * Goes to a place, brought into its range; the notification is given before whatever comes next.
   */
  void jump(long to, Reset.Cause cause) throws IOException {
    long place = playable.nearestUs(to);
    if (place != 0 && !playable.seekable()) {
      throw new IOException(playable.name() + " cannot seek; it can be rewound");
    }
    endSliceEarly();
    awaited.endSteps();
    cursor.seek(place);
    pendingBreak = cause;
    slices.moveTo(place);
    runUp.cancel();
    ties.forget();
    pace.jumpTo(place);
    board.setPlace(place);
  }

  /** Goes to a place by way of a run-up through the chain. */
  void jumpWithRunUp(StepBackSearch.Place target, long runUpUs) throws IOException {
    long from = Math.max(playable.earliestUs(), target.elapsedUs() - runUpUs);
    jump(playable.seekable() ? from : target.elapsedUs(), Reset.Cause.SEEK);
    if (from < target.elapsedUs() || target.ties() > 0) {
      runUp.open(target);
    }
    board.setPlace(target.elapsedUs());
  }

  /** The place so many events before the slice that is shown. */
  StepBackSearch.Place eventsBack(long events) throws IOException {
    endSliceEarly();
    pendingBreak = Reset.Cause.SEEK;
    return new StepBackSearch(cursor, pace.meter().eventRateEps()).before(board.shown(), events);
  }

  /** The start, or the in point of a loop that is on. */
  long startOfLoop() {
    return playable.seekable() ? slices.inPoint() : 0;
  }

  /** Tells everybody to forget, in the midst of a slice if need be. */
  void userReset() {
    if (pendingBreak != null || !runner.streamRunning()) {
      return;
    }
    long gridTo = slices.gridTo();
    endSliceEarly();
    slices.keepGridTo(gridTo);
    runner.notified(new Reset(Reset.Cause.USER, runner.lastUs(), StreamNotification.NO_TIME_US));
  }

  // ---- Turns

  /** Works a little; returns nanoseconds until the next turn has something to do. */
  long turn() {
    if (idle() && pendingBreak == null) {
      return Long.MAX_VALUE;
    }
    try {
      return advance();
    } catch (IOException | RuntimeException thrown) {
      fail(thrown);
      return 0;
    }
  }

  private boolean idle() {
    return !board.playing() && !awaited.stepping();
  }

  private long advance() throws IOException {
    SourceCursor.Ahead ahead = cursor.ahead();
    if (ahead == SourceCursor.Ahead.UNKNOWN) {
      return 0;
    }
    if (pendingBreak != null) {
      giveBreak(ahead);
    }
    if (idle()) {
      return Long.MAX_VALUE;
    }
    if (runUp.isOpen()) {
      if (!runUp.advance(ahead)) {
        slices.moveTo(runUp.targetUs());
      }
      return 0;
    }
    if (!slices.isOpen() && !openSlice(ahead)) {
      return 0;
    }
    if (!slices.hasBegun()) {
      long wait = awaited.stepping() ? 0 : pace.nanosUntil(slices.fromUs());
      if (wait > 0) {
        return wait;
      }
      begin(-wait);
    }
    feed(ahead);
    return 0;
  }

  private void giveBreak(SourceCursor.Ahead ahead) {
    long nextUs =
        ahead == SourceCursor.Ahead.EVENTS ? cursor.timeUs() : StreamNotification.NO_TIME_US;
    Reset.Cause cause = pendingBreak;
    pendingBreak = null;
    runner.notified(
        runner.streamRunning() ? new Reset(cause, runner.lastUs(), nextUs) : cursor.start());
    awaited.jumped();
  }

  /** Opens a slice before what is ahead; false if that was something else. */
  private boolean openSlice(SourceCursor.Ahead ahead) throws IOException {
    if (ahead == SourceCursor.Ahead.NOTIFICATION) {
      StreamNotification notification = cursor.takeNotification();
      if (notification instanceof Reset) {
        slices.losePlace();
      }
      runner.notified(notification);
      return false;
    }
    if (ahead == SourceCursor.Ahead.END) {
      if (slices.loops()) {
        wrap();
      } else {
        end();
      }
      return false;
    }
    boolean reading = ahead == SourceCursor.Ahead.READING;
    if (reading
        && !slices.waitsForSlice(
            cursor.readingElapsedUs(), playable.durationUs().orElse(Long.MAX_VALUE))) {
      runner.reading(cursor.takeReading());
      return false;
    }
    long next = reading ? cursor.readingElapsedUs() : cursor.elapsedUs();
    if (!slices.openBefore(next, cursor.offsetUs())) {
      wrap();
      return false;
    }
    return true;
  }

  private void begin(long lateNanos) {
    slices.begin();
    long from = slices.fromUs();
    board.setShown(from, ties.at(from), from - slices.offsetUs());
    if (awaited.stepping()) {
      pace.stepBegins(from);
    } else {
      pace.sliceBegins(from, lateNanos);
    }
  }

  private void feed(SourceCursor.Ahead ahead) {
    if (ahead == SourceCursor.Ahead.READING) {
      if (slices.byCount() || cursor.readingElapsedUs() < slices.toUs()) {
        runner.reading(cursor.takeReading());
      } else {
        endSlice(slices.toUs());
      }
      return;
    }
    if (ahead != SourceCursor.Ahead.EVENTS) {
      boolean gridStays = ahead == SourceCursor.Ahead.NOTIFICATION && !slices.byCount();
      long gridTo = gridStays ? slices.toUs() : SliceCutter.NO_PLACE;
      endSlice(slices.afterLast());
      slices.keepGridTo(gridTo);
      return;
    }
    int most = Math.min(cursor.countBefore(slices.toUs()), PlaybackEngine.CHUNK_EVENTS);
    int count = (int) Math.min(most, slices.countLeft());
    if (count == 0) {
      endSlice(slices.toUs());
      return;
    }
    EventPacket piece = cursor.take(count);
    ties.handOver(piece, cursor.offsetUs());
    slices.handOver(count, piece.timeUs(count - 1));
    runner.packet(piece);
    if (slices.countLeft() == 0) {
      endSlice(slices.afterLast());
    }
  }

  private void endSlice(long to) {
    boolean lastAsked = cut(to) && awaited.sliceShown();
    board.publish();
    if (lastAsked) {
      awaited.endSteps();
    }
  }

  /** Cuts a slice that is half done where it is; it counts for no step. */
  private void endSliceEarly() {
    if (slices.hasBegun() && slices.events() > 0) {
      cut(slices.afterLast());
      board.publish();
    }
    slices.drop();
  }

  /** Ends the open slice and tells the sinks; false if it is none. */
  private boolean cut(long to) {
    if (!slices.end(to)) {
      return false;
    }
    long from = slices.fromUs();
    long offset = slices.offsetUs();
    board.setShownLength(to - from);
    pace.meter().sliceEnded(to - from, slices.events());
    runner.forEachSink(
        sink -> {
          if (sink instanceof SliceSink sliced) {
            sliced.sliceEnd(from - offset, to - offset);
          }
        });
    return true;
  }

  private void wrap() throws IOException {
    long from = slices.position();
    long to = playable.nearestUs(startOfLoop());
    cursor.seek(to);
    pendingBreak = Reset.Cause.REWIND;
    slices.moveTo(to);
    ties.forget();
    pace.shift(to - from);
  }

  // ---- The end

  private void end() {
    board.setState(State.ENDED);
    pace.hold();
    // Whoever is told of the end may ask at once.
    board.publish();
    runner.notified(cursor.end());
    board.publish();
    awaited.endSteps();
  }

  /** Gives up; another jump may try again. */
  void fail(Throwable thrown) {
    endSliceEarly();
    pendingBreak = null;
    board.setState(State.FAILED);
    pace.hold();
    board.setMessage(thrown instanceof IOException ? thrown.getMessage() : thrown.toString());
    endStream();
    board.publish();
    awaited.fail(thrown);
  }

  /** Ends the stream and closes the playable; nothing may be called afterwards. */
  void close() {
    endSliceEarly();
    if (board.state() != State.FAILED) {
      board.setState(State.ENDED);
    }
    endStream();
    try {
      playable.close();
    } catch (IOException thrown) {
      board.setMessage(thrown.getMessage());
    }
    board.publish();
    awaited.fail(new IllegalStateException("the player is closed"));
  }

  private void endStream() {
    if (runner.streamRunning()) {
      runner.notified(new EndOfStream(runner.lastUs()));
    }
  }
}
