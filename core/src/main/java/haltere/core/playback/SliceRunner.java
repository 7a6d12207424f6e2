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
 * Takes what is ahead in the source through the chain, slice by slice, in turns that are short:
 * hand one piece over, end a slice, go back to the start of a loop.
 *
 * <p>Places are on the elapsed timeline, in microseconds. Thread rule: the processing thread only.
 */
final class SliceRunner {
  /** Runs begin at multiples of this part of the memory. */
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

  // A jump whose notification is still to be given, before whatever comes next.
  private Reset.Cause pendingBreak = Reset.Cause.REWIND;

  // Where the run began that led to what is shown, for slices of what length, and whether it was
  // neither played nor changed by hand since then.
  private long runFromUs;
  private long runSliceUs;
  private boolean isExact = true;
  private boolean isByHand;

  private boolean remakeWanted;
  private boolean isRemaking;

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

  // ---- Elsewhere

  /**
   * Goes to a place, brought into its range, by way of a run-up; the notification is given before
   * whatever comes next.
   */
  void jump(long to, Reset.Cause cause) throws IOException {
    jump(new StepBackSearch.Place(playable.nearestUs(to), 0), cause);
  }

  /** The same, to a place among events of one time. */
  void jump(StepBackSearch.Place target, Reset.Cause cause) throws IOException {
    long place = target.elapsedUs();
    if (place != 0 && !playable.seekable()) {
      throw new IOException(playable.name() + " cannot seek; it can be rewound");
    }
    endSliceEarly();
    awaited.endSteps();
    approach(target, slices.byCount() ? board.shownLengthUs() : slices.lengthUs());
    slices.moveTo(place);
    pendingBreak = cause;
    pace.jumpTo(place);
    board.setPlace(place);
  }

  /** Puts the source where the run-up to a slice begins. */
  private void approach(StepBackSearch.Place target, long sliceUs) throws IOException {
    long from = runFrom(target.elapsedUs(), sliceUs);
    cursor.seek(from);
    runFromUs = from;
    runSliceUs = sliceUs;
    isExact = true;
    isByHand = false;
    endRemake();
    ties.forget();
    pace.meter().forgetRate();
    if (from < target.elapsedUs() || target.ties() > 0) {
      runUp.open(from, target);
    }
  }

  /**
   * Where the run to a slice begins: as far before it as the chain and those who show it remember,
   * on a grid, so that neighbouring slices share their run and what filters number in it.
   */
  private long runFrom(long place, long sliceUs) {
    long[] memoryUs = {chain.memoryUs()};
    runner.forEachSink(
        sink -> {
          if (sink instanceof SliceSink sliced) {
            memoryUs[0] = Math.max(memoryUs[0], sliced.memoryUs(sliceUs));
          }
        });
    long gridUs = Math.max(1, memoryUs[0] / RUNS_PER_MEMORY);
    long from = place - Math.floorMod(place, gridUs) - memoryUs[0];
    return playable.seekable() ? Math.min(place, Math.max(playable.earliestUs(), from)) : place;
  }

  /** The place so many events before the slice that is shown. */
  StepBackSearch.Place eventsBack(long events) throws IOException {
    endSliceEarly();
    pendingBreak = Reset.Cause.SEEK;
    return new StepBackSearch(cursor, pace.meter().eventRateEps()).before(board.shown(), events);
  }

  /** Whether a place was jumped to of which nothing is shown yet. */
  boolean isJumping() {
    return pendingBreak != null || runUp.isOpen();
  }

  /** Whether what goes through the chain leads to a moment, or is one that has been shown. */
  boolean isLeading() {
    return runUp.isOpen() || isRemaking;
  }

  // ---- The same moment anew

  /** What is shown depends on something that has changed: in pause it is made anew. */
  void remake() {
    remakeWanted = !board.playing() && board.isShown();
  }

  /** The same, unless filters were changed by hand, which would be lost. */
  void refresh() {
    if (!isByHand) {
      remake();
    }
  }

  /** Filters were told something that their settings do not tell. */
  void changedByHand() {
    isByHand = true;
  }

  private boolean isRemakeDue() {
    if (awaited.stepping() || isJumping() || !board.isShown() || !playable.seekable()) {
      return false;
    }
    return switch (board.state()) {
      case PAUSED -> remakeWanted || !isByHand && !isReproducible();
      case ENDED -> remakeWanted;
      default -> false;
    };
  }

  private boolean isReproducible() {
    long place = board.shown().elapsedUs();
    long sliceUs = board.shownLengthUs();
    long from = runFrom(place, sliceUs);
    return from == place || isExact && runFromUs == from && runSliceUs == sliceUs;
  }

  private void beginRemake() throws IOException {
    StepBackSearch.Place shown = board.shown();
    long lengthUs = board.shownLengthUs();
    remakeWanted = false;
    approach(shown, lengthUs);
    isRemaking = true;
    slices.drop();
    slices.repeat(shown.elapsedUs(), shown.elapsedUs() + lengthUs, board.shownEvents());
    pendingBreak = Reset.Cause.SEEK;
    board.setState(State.PAUSED);
    awaited.awaitSlice();
  }

  /** What comes next is the slice that the run-up led to. */
  private void endRunUp() {
    tellSinks(SliceSink::runUpEnds);
    runner.setRunUp(isRemaking);
  }

  /** What was asked for is no longer wanted, or has been made. */
  private void endRemake() {
    if (runUp.isOpen() && runner.isRunUp()) {
      tellSinks(SliceSink::runUpEnds);
    }
    runUp.cancel();
    runner.setRunUp(false);
    board.setRunUp(0);
    isRemaking = false;
  }

  private void tellSinks(Consumer<SliceSink> action) {
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

  /** Tells everybody to forget, in the midst of a slice if need be. */
  void userReset() {
    if (pendingBreak != null || !runner.streamRunning()) {
      return;
    }
    long gridTo = slices.gridTo();
    endSliceEarly();
    slices.keepGridTo(gridTo);
    runner.notified(new Reset(Reset.Cause.USER, runner.lastUs(), StreamNotification.NO_TIME_US));
    changedByHand();
  }

  // ---- Turns

  /** Works a little; returns nanoseconds until the next turn has something to do. */
  long turn() {
    try {
      if (isRemakeDue()) {
        beginRemake();
      }
      return idle() && pendingBreak == null ? Long.MAX_VALUE : advance();
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
    if (!goesOn && !isRemaking) {
      slices.moveTo(runUp.targetUs());
    }
    board.publish();
  }

  private void giveBreak(SourceCursor.Ahead ahead) {
    long nextUs =
        ahead == SourceCursor.Ahead.EVENTS ? cursor.timeUs() : StreamNotification.NO_TIME_US;
    Reset.Cause cause = pendingBreak;
    pendingBreak = null;
    tellSinks(sink -> sink.runUpBegins(runSliceUs));
    runner.setRunUp(isRemaking && runner.streamRunning());
    runner.notified(
        runner.streamRunning() ? new Reset(cause, runner.lastUs(), nextUs) : cursor.start());
    runner.setRunUp(true);
    if (!runUp.isOpen()) {
      endRunUp();
    }
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
        runner.sample(cursor.takeSample());
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
    pace.meter().handOver(piece, cursor.offsetUs());
    slices.handOver(count, piece.timeUs(count - 1));
    runner.packet(piece);
    if (slices.countLeft() == 0) {
      endSlice(slices.afterLast());
    }
  }

  private void endSlice(long to) {
    boolean lastAsked = cut(to) && awaited.sliceShown();
    isExact &= isRemaking || !board.playing();
    if (isRemaking) {
      endRemake();
    }
    if (lastAsked) {
      hold();
    }
    board.publish();
    if (lastAsked) {
      awaited.endSteps();
    }
  }

  /** Playback stands at the slice that ended last. */
  void hold() {
    tellSinks(SliceSink::sliceHeld);
  }

  /** Cuts a slice that is half done where it is; it counts for no step. */
  private void endSliceEarly() {
    if (slices.hasBegun() && slices.events() > 0 && !isRemaking) {
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
    board.setShownLength(to - from, slices.events());
    pace.meter().sliceEnded(to);
    tellSinks(sink -> sink.sliceEnd(from - offset, to - offset));
    return true;
  }

  private void wrap() throws IOException {
    long from = slices.position();
    long to = playable.nearestUs(startOfLoop());
    approach(new StepBackSearch.Place(to, 0), slices.lengthUs());
    pendingBreak = Reset.Cause.REWIND;
    slices.moveTo(to);
    pace.shift(to - from);
  }

  // ---- The end

  private void end() {
    board.setState(State.ENDED);
    pace.hold();
    // Whoever is told of the end may ask at once.
    board.publish();
    runner.notified(cursor.end());
    hold();
    board.publish();
    awaited.endSteps();
  }

  /** Gives up; another jump may try again. */
  void fail(Throwable thrown) {
    endSliceEarly();
    endRemake();
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
    endRemake();
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
