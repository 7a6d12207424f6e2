package haltere.core.playback;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.pipeline.ChainRunner;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.function.Consumer;

/**
 * Processes the source through the chain, slice by slice, in short turns: each passes on one piece,
 * ends a slice or returns to the start of a loop.
 *
 * <p>Positions are on the elapsed timeline, in microseconds. Thread rule: the processing thread
 * only.
 */
final class SliceRunner {
  /** Run-ups begin on a grid of this fraction of the memory. */
  private static final int RUNS_PER_MEMORY = 16;

  private final Playable playable;
  private final FilterChain chain;
  private final SourceCursor cursor;
  private final ChainRunner runner;
  private final SliceCutter slices;
  private final PlaybackPace pace;
  private final StatusBoard board;
  private final AwaitedRequests awaited;
  private final EventTies ties = new EventTies();
  private final RunUp runUp;

  // A jump whose notification is sent before the next element.
  private Reset.Cause pendingJump = Reset.Cause.REWIND;

  // Start of the run-up to the displayed slice, the length of its slices, and whether nothing was
  // played or changed manually since then.
  private long runFromUs;
  private long runSliceUs;
  private boolean isExact = true;
  private boolean isManual;

  private boolean repeatRequested;
  private boolean isRepeating;

  SliceRunner(
      Playable playable,
      FilterChain chain,
      SourceCursor cursor,
      ChainRunner runner,
      SliceCutter slices,
      PlaybackPace pace,
      StatusBoard board,
      AwaitedRequests awaited) {
    this.playable = playable;
    this.chain = chain;
    this.cursor = cursor;
    this.runner = runner;
    this.slices = slices;
    this.pace = pace;
    this.board = board;
    this.awaited = awaited;
    runUp = new RunUp(cursor, runner, ties, pace.meter());
  }

  // ---- Jumps

  /**
   * Jumps to a position, limited to its range, with a run-up; the notification is sent before the
   * next element.
   */
  void jump(long to, Reset.Cause cause) throws IOException {
    if (to > playable.nearestUs(to)) {
      playable.catchUp();
    }
    jump(new StepBackSearch.Position(playable.nearestUs(to), 0), cause);
  }

  /** The same, to a position among events of equal time. */
  void jump(StepBackSearch.Position target, Reset.Cause cause) throws IOException {
    long positionUs = target.elapsedUs();
    if (positionUs != 0 && !playable.seekable()) {
      throw new IOException(playable.name() + " cannot seek; it can be rewound");
    }
    endSliceEarly();
    awaited.endSteps();
    approach(target, slices.byCount() ? board.shownLengthUs() : slices.lengthUs());
    slices.moveTo(positionUs);
    pendingJump = cause;
    pace.jumpTo(positionUs);
    board.setPosition(positionUs);
  }

  /** Moves the source to the start of the run-up to a slice. */
  private void approach(StepBackSearch.Position target, long sliceUs) throws IOException {
    long from = runFrom(target.elapsedUs(), sliceUs);
    cursor.seek(from);
    runFromUs = from;
    runSliceUs = sliceUs;
    isExact = true;
    isManual = false;
    endRepeat();
    ties.forget();
    pace.meter().resetRate();
    if (from < target.elapsedUs() || target.ties() > 0) {
      runUp.open(from, target);
    }
  }

  /**
   * Start of the run-up to a slice: before it by the memory of the chain and the slice sinks, on a
   * grid, so that neighbouring slices share their run-up and the numbers that filters give in it.
   */
  private long runFrom(long positionUs, long sliceUs) {
    long[] memoryUs = {chain.memoryUs()};
    runner.forEachSink(
        sink -> {
          if (sink instanceof SliceSink sliced) {
            memoryUs[0] = Math.max(memoryUs[0], sliced.memoryUs(sliceUs));
          }
        });
    long gridUs = Math.max(1, memoryUs[0] / RUNS_PER_MEMORY);
    long from = positionUs - Math.floorMod(positionUs, gridUs) - memoryUs[0];
    return playable.seekable()
        ? Math.min(positionUs, Math.max(playable.earliestUs(), from))
        : positionUs;
  }

  /** The position a number of events before the displayed slice. */
  StepBackSearch.Position eventsBack(long events) throws IOException {
    endSliceEarly();
    pendingJump = Reset.Cause.SEEK;
    return new StepBackSearch(cursor, pace.meter().eventRateEps()).before(board.shown(), events);
  }

  /** Whether nothing has been shown yet since the last jump. */
  boolean isJumping() {
    return pendingJump != null || runUp.isOpen();
  }

  /** Whether the chain processes a run-up, or repeats a slice. */
  boolean isLeading() {
    return runUp.isOpen() || isRepeating;
  }

  // ---- Repetition of the displayed slice

  /** Requests a repetition of the displayed slice, while paused. */
  void requestRepeat() {
    repeatRequested = !board.playing() && board.isShown();
  }

  /** The same, unless it would lose manual changes of filters. */
  void refresh() {
    if (!isManual) {
      requestRepeat();
    }
  }

  /** Filters have a state that their settings do not determine. */
  void changedManually() {
    isManual = true;
  }

  private boolean isRepeatDue() {
    if (awaited.stepping() || isJumping() || !board.isShown() || !playable.seekable()) {
      return false;
    }
    return switch (board.state()) {
      case PAUSED -> repeatRequested || !isManual && !isReproducible();
      case ENDED -> repeatRequested;
      default -> false;
    };
  }

  private boolean isReproducible() {
    long positionUs = board.shown().elapsedUs();
    long sliceUs = board.shownLengthUs();
    long from = runFrom(positionUs, sliceUs);
    return from == positionUs || isExact && runFromUs == from && runSliceUs == sliceUs;
  }

  private void beginRepeat() throws IOException {
    StepBackSearch.Position shown = board.shown();
    long lengthUs = board.shownLengthUs();
    repeatRequested = false;
    approach(shown, lengthUs);
    isRepeating = true;
    slices.drop();
    slices.repeat(shown.elapsedUs(), shown.elapsedUs() + lengthUs, board.shownEvents());
    pendingJump = Reset.Cause.SEEK;
    board.setState(State.PAUSED);
    awaited.awaitSlice();
  }

  /** Ends the run-up; its target slice comes next. */
  private void endRunUp() {
    forEachSliceSink(SliceSink::runUpEnds);
    runner.setRunUp(isRepeating);
  }

  /** Ends a repetition, complete or not. */
  private void endRepeat() {
    if (runUp.isOpen() && runner.isRunUp()) {
      forEachSliceSink(SliceSink::runUpEnds);
    }
    runUp.cancel();
    runner.setRunUp(false);
    board.setRunUp(0);
    isRepeating = false;
  }

  private void forEachSliceSink(Consumer<SliceSink> action) {
    runner.forEachSink(
        sink -> {
          if (sink instanceof SliceSink sliced) {
            action.accept(sliced);
          }
        });
  }

  /** The start, or the in point of a loop that is on. */
  long startOfLoop() {
    return playable.seekable() ? slices.inPoint() : 0;
  }

  /** Resets filters and sinks, also inside a slice. */
  void userReset() {
    if (pendingJump != null || !runner.streamRunning()) {
      return;
    }
    long gridTo = slices.gridTo();
    endSliceEarly();
    slices.keepGridTo(gridTo);
    runner.notified(new Reset(Reset.Cause.USER, runner.lastUs(), StreamNotification.NO_TIME_US));
    changedManually();
  }

  // ---- Turns

  /** Runs a short turn; returns the time until the next one is due, nanoseconds. */
  long turn() {
    try {
      if (isRepeatDue()) {
        beginRepeat();
      }
      return idle() && pendingJump == null ? Long.MAX_VALUE : advance();
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
    if (pendingJump != null) {
      notifyJump(ahead);
    }
    if (idle()) {
      return Long.MAX_VALUE;
    }
    if (runUp.isOpen()) {
      advanceRunUp(ahead);
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

  private void advanceRunUp(SourceCursor.Ahead ahead) {
    boolean goesOn = runUp.advance(ahead);
    board.setRunUp(runUp.leftUs());
    if (!goesOn) {
      pace.jumpTo(runUp.targetUs());
      endRunUp();
    }
    if (!goesOn && !isRepeating) {
      slices.moveTo(runUp.targetUs());
    }
    board.publish();
  }

  private void notifyJump(SourceCursor.Ahead ahead) {
    long nextUs =
        ahead == SourceCursor.Ahead.EVENTS ? cursor.timeUs() : StreamNotification.NO_TIME_US;
    Reset.Cause cause = pendingJump;
    pendingJump = null;
    forEachSliceSink(sink -> sink.runUpBegins(runSliceUs));
    runner.setRunUp(isRepeating && runner.streamRunning());
    runner.notified(
        runner.streamRunning() ? new Reset(cause, runner.lastUs(), nextUs) : cursor.start());
    runner.setRunUp(true);
    if (!runUp.isOpen()) {
      endRunUp();
    }
    awaited.jumped();
  }

  /** Opens the next slice; false if the next element is processed outside of slices. */
  private boolean openSlice(SourceCursor.Ahead ahead) throws IOException {
    if (ahead == SourceCursor.Ahead.NOTIFICATION) {
      StreamNotification notification = cursor.takeNotification();
      if (notification instanceof Reset) {
        slices.losePosition();
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
    boolean sample = ahead == SourceCursor.Ahead.SAMPLE;
    if (sample
        && !slices.waitsForSlice(
            cursor.sampleElapsedUs(), playable.durationUs().orElse(Long.MAX_VALUE))) {
      runner.sample(cursor.takeSample());
      return false;
    }
    long next = sample ? cursor.sampleElapsedUs() : cursor.elapsedUs();
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
    if (ahead == SourceCursor.Ahead.SAMPLE) {
      if (slices.byCount() || cursor.sampleElapsedUs() < slices.toUs()) {
        slices.handOverSample(cursor.sampleElapsedUs());
        runner.sample(cursor.takeSample());
      } else {
        endSlice(slices.toUs());
      }
      return;
    }
    if (ahead != SourceCursor.Ahead.EVENTS) {
      boolean gridStays = ahead == SourceCursor.Ahead.NOTIFICATION && !slices.byCount();
      long gridTo = gridStays ? slices.toUs() : SliceCutter.NO_POSITION;
      endSlice(slices.afterLast());
      slices.keepGridTo(gridTo);
      return;
    }
    int max = Math.min(cursor.countBefore(slices.toUs()), PlaybackEngine.CHUNK_EVENTS);
    int count = (int) Math.min(max, slices.countLeft());
    if (count == 0) {
      endSlice(slices.toUs());
      return;
    }
    EventPacket piece = cursor.take(count);
    ties.handOver(piece, cursor.offsetUs());
    pace.meter().handOver(piece, cursor.offsetUs());
    slices.handOver(count, piece.timeUs(count - 1));
    runner.packet(piece);
    if (slices.countLeft() == 0) {
      endSlice(slices.afterLast());
    }
  }

  private void endSlice(long to) {
    boolean isLastStep = cut(to) && awaited.sliceShown();
    isExact &= isRepeating || !board.playing();
    if (isRepeating) {
      endRepeat();
    }
    if (isLastStep) {
      hold();
    }
    board.publish();
    if (isLastStep) {
      awaited.endSteps();
    }
  }

  /** Tells slice sinks that the last slice stays displayed. */
  void hold() {
    forEachSliceSink(SliceSink::sliceHeld);
  }

  /** Ends an incomplete slice at its last event; it does not count as a step. */
  private void endSliceEarly() {
    if (slices.hasBegun() && slices.events() > 0 && !isRepeating) {
      cut(slices.afterLast());
      board.publish();
    }
    slices.drop();
  }

  /** Ends the open slice and notifies the sinks; false if it does not count. */
  private boolean cut(long to) {
    if (!slices.end(to)) {
      return false;
    }
    long from = slices.fromUs();
    long offset = slices.offsetUs();
    board.setShownLength(to - from, slices.events());
    pace.meter().sliceEnded(to);
    forEachSliceSink(sink -> sink.sliceEnd(from - offset, to - offset));
    return true;
  }

  private void wrap() throws IOException {
    long from = slices.position();
    long to = playable.nearestUs(startOfLoop());
    approach(new StepBackSearch.Position(to, 0), slices.lengthUs());
    pendingJump = Reset.Cause.REWIND;
    slices.moveTo(to);
    pace.shift(to - from);
  }

  // ---- The end

  private void end() {
    board.setState(State.ENDED);
    pace.hold();
    // A sink may read the status when it is notified of the end.
    board.publish();
    runner.notified(cursor.end());
    hold();
    board.publish();
    awaited.endSteps();
  }

  /** Enters the state FAILED, which a jump may leave. */
  void fail(Throwable thrown) {
    endSliceEarly();
    endRepeat();
    pendingJump = null;
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
    endRepeat();
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
