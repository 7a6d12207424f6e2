package haltere.core.playback;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.pipeline.ChainRunner;
import haltere.core.pipeline.OnFailure;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;

/**
 * The work of a {@link Player}, in turns that are short: apply a command, hand one packet over, end
 * a slice. Knows no thread.
 *
 * <p>Places are on the elapsed timeline, in microseconds.
 */
final class PlaybackEngine {
  /** Most events that go to the chain at a time. */
  static final int CHUNK_EVENTS = 4096;

  /** Playback that is later than this does not catch up. */
  static final long MAX_CATCH_UP_NANOS = 1_000_000_000L;

  private static final long NO_PLACE = Long.MAX_VALUE;

  private final Playable playable;
  private final FilterChain chain;
  private final long runUpUs;
  private final PlaybackClock clock;
  private final SourceCursor cursor;
  private final ChainRunner runner;
  private final PipelineCounters counters = new PipelineCounters();
  private final PlaybackMeter meter;

  private volatile PlayerStatus status;

  private Slicing slicing;
  private Loop loop;
  private State state;
  private String message = "";

  // A jump whose notification is still to be given, before whatever comes next.
  private Reset.Cause pendingBreak = Reset.Cause.REWIND;
  private final List<CompletableFuture<Void>> jumping = new ArrayList<>();

  // Slices to show although playback is paused.
  private int stepsLeft;
  private final List<CompletableFuture<Void>> stepping = new ArrayList<>();

  // Where the next slice starts, unless only the next event tells.
  private long position;
  private boolean positionKnown = true;
  private long outPoint = NO_PLACE;
  private long slicesSinceWrap;

  // The slice that is open, and whether the first piece of it is due or was handed over.
  private boolean open;
  private boolean begun;
  private long sliceFrom;
  private long sliceTo;
  private long sliceOffsetUs;
  private long sliceEvents;
  private long countLeft;
  private long lastFed;
  private long keepGridTo = NO_PLACE;

  // The run-up before a step back: to a place, and so many events of exactly that place.
  private long runUpTo = Long.MIN_VALUE;
  private int runUpTies;
  private boolean runUpOpen;

  // The slice that was shown last.
  private long shownFrom;
  private int shownTies;
  private long shownLengthUs;
  private long shownTimeUs = StreamNotification.NO_TIME_US;
  private int tiesAtLastFed;
  private long lastTiesPlace = Long.MIN_VALUE;

  private long slipNanos;
  private long lagNanos;

  PlaybackEngine(Playable playable, FilterChain chain, PlayerOptions options) {
    if (chain.geometry().width() != playable.geometry().width()
        || chain.geometry().height() != playable.geometry().height()) {
      throw new IllegalArgumentException(
          "the chain is for "
              + chain.geometry()
              + " pixels, "
              + playable.name()
              + " has "
              + playable.geometry());
    }
    this.playable = playable;
    this.chain = chain;
    runUpUs = options.runUpUs();
    clock = new PlaybackClock(options.nanoTime(), options.sleeper());
    clock.setSpeed(options.speed());
    cursor = new SourceCursor(playable);
    runner = new ChainRunner(chain, counters, OnFailure.GO_ON, line -> message = line);
    meter = new PlaybackMeter(chain);
    slicing = options.slicing();
    setLoop(options.loop());
    state = options.paused() ? State.PAUSED : State.PLAYING;
    stepsLeft = options.paused() ? 1 : 0;
    publish();
  }

  PlaybackClock clock() {
    return clock;
  }

  Playable playable() {
    return playable;
  }

  PipelineCounters counters() {
    return counters;
  }

  PlayerStatus status() {
    return status;
  }

  /** Must be called before the first turn. */
  void start(CompletableFuture<Void> started) {
    jumping.add(started);
    clock.setPosition(position);
    if (state == State.PLAYING) {
      clock.resume();
    }
  }

  // ---- Commands

  void apply(PlaybackCommand command, CompletableFuture<Void> done) {
    try {
      if (!obey(command, done)) {
        done.complete(null);
      }
    } catch (IOException | RuntimeException thrown) {
      message = thrown.getMessage() == null ? thrown.toString() : thrown.getMessage();
      done.completeExceptionally(thrown);
    }
    publish();
  }

  /** Returns true if the future will be completed later. */
  private boolean obey(PlaybackCommand command, CompletableFuture<Void> done) throws IOException {
    if (command instanceof PlaybackCommand.Play play) {
      return setPlaying(play.on(), done);
    } else if (command instanceof PlaybackCommand.Toggle) {
      return setPlaying(state != State.PLAYING, done);
    } else if (command instanceof PlaybackCommand.Step step) {
      return step(step.slices(), done);
    } else if (command instanceof PlaybackCommand.Seek seek) {
      return jumpAndShow(seek.elapsedUs(), Reset.Cause.SEEK, done);
    } else if (command instanceof PlaybackCommand.Rewind) {
      return jumpAndShow(startOfLoop(), Reset.Cause.REWIND, done);
    } else if (command instanceof PlaybackCommand.SetSpeed set) {
      clock.setSpeed(set.speed());
      forgetLag();
      reopen();
    } else if (command instanceof PlaybackCommand.SetSlicing set) {
      slicing = set.slicing();
      keepGridTo = NO_PLACE;
      reopen();
    } else if (command instanceof PlaybackCommand.SetLoop set) {
      setLoop(set.loop());
      reopen();
    } else if (command instanceof PlaybackCommand.UserReset) {
      userReset();
    } else if (command instanceof PlaybackCommand.Edit edit) {
      edit.change().accept(chain);
    } else if (command instanceof PlaybackCommand.AddSink add) {
      runner.addSink(add.sink(), add.raw());
    } else if (command instanceof PlaybackCommand.RemoveSink remove) {
      runner.removeSink(remove.sink());
    }
    return false;
  }

  private boolean setPlaying(boolean on, CompletableFuture<Void> done) throws IOException {
    if (!on) {
      if (state == State.PLAYING) {
        state = State.PAUSED;
        clock.pause();
        meter.restart();
      }
      return false;
    }
    if (state == State.PLAYING) {
      return false;
    }
    endSteps();
    boolean later = false;
    if (state == State.ENDED || state == State.FAILED) {
      later = jump(startOfLoop(), Reset.Cause.REWIND, done);
    }
    state = State.PLAYING;
    long next = open ? sliceFrom : position;
    if (open && begun || clock.positionUs() > next) {
      clock.setPosition(next);
    }
    clock.resume();
    forgetLag();
    return later;
  }

  private boolean step(int slices, CompletableFuture<Void> done) throws IOException {
    setPlaying(false, done);
    if (slices == 0 || (slices > 0 && state != State.PAUSED)) {
      return false;
    }
    if (slices > 0) {
      // What is in hand when a pause comes in the middle of a slice is finished as the first step.
      stepsLeft += slices;
      stepping.add(done);
      return true;
    }
    StepBackSearch.Place target = stepBack(-Math.max(slices, -Integer.MAX_VALUE));
    long from = Math.max(0, target.elapsedUs() - runUpUs);
    jump(playable.seekable() ? from : target.elapsedUs(), Reset.Cause.SEEK, null);
    runUpTo = target.elapsedUs();
    runUpTies = target.ties();
    runUpOpen = from < target.elapsedUs() || runUpTies > 0;
    shownFrom = target.elapsedUs();
    state = State.PAUSED;
    stepsLeft = 1;
    stepping.add(done);
    return true;
  }

  private StepBackSearch.Place stepBack(int slices) throws IOException {
    if (!playable.seekable() && shownFrom > 0) {
      throw new IOException(playable.name() + " cannot step back; rewind it");
    }
    if (slicing instanceof Slicing.ByCount byCount) {
      StepBackSearch.Place shown = new StepBackSearch.Place(shownFrom, shownTies);
      endSliceEarly();
      pendingBreak = Reset.Cause.SEEK;
      return new StepBackSearch(cursor, meter.eventRateEps())
          .before(shown, (long) byCount.events() * slices);
    }
    boolean toStart = sliceUs() > shownFrom / slices;
    return new StepBackSearch.Place(toStart ? 0 : shownFrom - sliceUs() * slices, 0);
  }

  private boolean jumpAndShow(long to, Reset.Cause cause, CompletableFuture<Void> done)
      throws IOException {
    boolean playing = state == State.PLAYING;
    jump(to, cause, playing ? done : null);
    if (!playing) {
      state = State.PAUSED;
      stepsLeft = 1;
      stepping.add(done);
    }
    return true;
  }

  /** Returns true: the future, if there is one, is completed when the notification was given. */
  private boolean jump(long to, Reset.Cause cause, CompletableFuture<Void> done)
      throws IOException {
    long place = Math.max(0, Math.min(to, playable.durationUs().orElse(Long.MAX_VALUE) - 1));
    if (place != 0 && !playable.seekable()) {
      throw new IOException(playable.name() + " cannot seek; it can be rewound");
    }
    endSliceEarly();
    endSteps();
    cursor.seek(place);
    pendingBreak = cause;
    position = place;
    positionKnown = true;
    keepGridTo = NO_PLACE;
    runUpOpen = false;
    slicesSinceWrap = 0;
    lastTiesPlace = Long.MIN_VALUE;
    setLoop(loop);
    clock.setPosition(place);
    forgetLag();
    shownFrom = place;
    shownTies = 0;
    shownTimeUs = StreamNotification.NO_TIME_US;
    if (done != null) {
      jumping.add(done);
    }
    return true;
  }

  private long startOfLoop() {
    return loop.on() && playable.seekable() ? loop.inUs().orElse(0) : 0;
  }

  private void setLoop(Loop newLoop) {
    loop = newLoop;
    long out = loop.on() ? loop.outUs().orElse(NO_PLACE) : NO_PLACE;
    outPoint = position < out ? out : NO_PLACE;
  }

  private void userReset() {
    if (pendingBreak != null || !runner.streamRunning()) {
      return;
    }
    long gridTo = open && begun ? sliceTo : NO_PLACE;
    endSliceEarly();
    keepGridTo = gridTo;
    runner.notified(new Reset(Reset.Cause.USER, runner.lastUs(), StreamNotification.NO_TIME_US));
  }

  private void forgetLag() {
    slipNanos = 0;
    lagNanos = 0;
    meter.restart();
  }

  /** A slice that has not begun is cut anew. */
  private void reopen() {
    if (open && !begun) {
      open = false;
    }
  }

  private void endSteps() {
    stepsLeft = 0;
    complete(stepping);
  }

  private static void complete(List<CompletableFuture<Void>> futures) {
    List<CompletableFuture<Void>> now = List.copyOf(futures);
    futures.clear();
    now.forEach(future -> future.complete(null));
  }

  // ---- Turns

  /** Works a little; returns nanoseconds until the next turn has something to do. */
  long turn() {
    if (state != State.PLAYING && stepsLeft == 0 && pendingBreak == null) {
      return Long.MAX_VALUE;
    }
    try {
      return advance();
    } catch (IOException | RuntimeException thrown) {
      fail(thrown);
      return 0;
    }
  }

  private long advance() throws IOException {
    SourceCursor.Ahead ahead = cursor.ahead();
    if (ahead == SourceCursor.Ahead.UNKNOWN) {
      return 0;
    }
    if (pendingBreak != null) {
      giveBreak(ahead);
    }
    if (state != State.PLAYING && stepsLeft == 0) {
      return Long.MAX_VALUE;
    }
    if (runUpOpen) {
      return runUp(ahead);
    }
    if (!open && !openSlice(ahead)) {
      return 0;
    }
    if (!begun) {
      long wait = stepsLeft > 0 ? 0 : clock.nanosUntil(sliceFrom);
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
    complete(jumping);
  }

  private boolean openSlice(SourceCursor.Ahead ahead) throws IOException {
    if (ahead == SourceCursor.Ahead.NOTIFICATION) {
      StreamNotification notification = cursor.takeNotification();
      positionKnown &= !(notification instanceof Reset);
      runner.notified(notification);
      return false;
    }
    if (ahead == SourceCursor.Ahead.END) {
      if (loop.on() && slicesSinceWrap > 0) {
        wrap();
      } else {
        end();
      }
      return false;
    }
    boolean byCount = slicing instanceof Slicing.ByCount;
    if (ahead == SourceCursor.Ahead.READING && (byCount || !belongsToSlice())) {
      runner.reading(cursor.takeReading());
      return false;
    }
    if (!positionKnown) {
      keepGridTo = NO_PLACE;
    }
    long nextEvent =
        ahead == SourceCursor.Ahead.READING ? cursor.readingElapsedUs() : cursor.elapsedUs();
    if (!positionKnown || nextEvent < position || byCount && nextEvent < outPoint) {
      // By count a slice starts at its first event. By time an event can lie before the start if it
      // is of the very microsecond after which the last slice was cut short.
      position = nextEvent;
    }
    positionKnown = true;
    if (position >= outPoint) {
      wrap();
      return false;
    }
    sliceFrom = position;
    sliceOffsetUs = cursor.offsetUs();
    countLeft = slicing instanceof Slicing.ByCount count ? count.events() : Long.MAX_VALUE;
    if (byCount) {
      sliceTo = outPoint;
    } else {
      long gridTo = keepGridTo > position ? keepGridTo : NO_PLACE;
      long length = Math.min(sliceUs(), NO_PLACE - position);
      sliceTo = Math.min(Math.min(position + length, gridTo), outPoint);
    }
    keepGridTo = NO_PLACE;
    sliceEvents = 0;
    lastFed = sliceFrom - 1;
    open = true;
    begun = false;
    return true;
  }

  /**
   * Whether the reading that is ahead waits for its slice: one between the first and the last event
   * does, unless nobody knows where the next slice starts.
   */
  private boolean belongsToSlice() {
    long place = cursor.readingElapsedUs();
    return positionKnown
        && place >= position
        && place < playable.durationUs().orElse(Long.MAX_VALUE);
  }

  private long sliceUs() {
    if (slicing instanceof Slicing.ByTime byTime) {
      return byTime.sliceUs();
    }
    if (slicing instanceof Slicing.PerFrame perFrame) {
      double speed = clock.unlimited() ? 1 : clock.speed();
      return Math.max(1, Math.round(speed * 1e6 / perFrame.framesPerSecond()));
    }
    return 1;
  }

  private void begin(long lateNanos) {
    begun = true;
    shownFrom = sliceFrom;
    shownTies = tiesBefore(sliceFrom);
    shownTimeUs = sliceFrom - sliceOffsetUs;
    if (stepsLeft > 0) {
      clock.setPosition(sliceFrom);
      return;
    }
    if (!clock.unlimited()) {
      long slip = Math.max(0, lateNanos - MAX_CATCH_UP_NANOS);
      clock.delay(slip);
      slipNanos += slip;
      lagNanos = slipNanos + lateNanos - slip;
    }
    meter.sliceBegins(clock.nanoTime(), sliceFrom);
  }

  private int tiesBefore(long place) {
    return place == lastTiesPlace ? tiesAtLastFed : 0;
  }

  private void feed(SourceCursor.Ahead ahead) {
    if (ahead == SourceCursor.Ahead.READING) {
      if (slicing instanceof Slicing.ByCount || cursor.readingElapsedUs() < sliceTo) {
        runner.reading(cursor.takeReading());
      } else {
        endSlice(sliceTo);
      }
      return;
    }
    if (ahead != SourceCursor.Ahead.EVENTS) {
      boolean reset = ahead == SourceCursor.Ahead.NOTIFICATION;
      long gridTo = reset ? sliceTo : NO_PLACE;
      endSlice(lastFed + 1);
      keepGridTo = slicing instanceof Slicing.ByCount ? NO_PLACE : gridTo;
      return;
    }
    int count = (int) Math.min(Math.min(cursor.countBefore(sliceTo), CHUNK_EVENTS), countLeft);
    if (count == 0) {
      endSlice(sliceTo);
      return;
    }
    EventPacket piece = cursor.take(count);
    noteTies(piece);
    lastFed = piece.timeUs(count - 1) + sliceOffsetUs;
    sliceEvents += count;
    countLeft -= count;
    runner.packet(piece);
    if (countLeft == 0) {
      endSlice(lastFed + 1);
    }
  }

  /** Remembers how many events of the last microsecond have been handed over. */
  private void noteTies(EventPacket piece) {
    int count = piece.size();
    long lastUs = piece.timeUs(count - 1);
    int ties = 0;
    while (ties < count && piece.timeUs(count - 1 - ties) == lastUs) {
      ties++;
    }
    long place = lastUs + cursor.offsetUs();
    tiesAtLastFed = ties == count && place == lastTiesPlace ? tiesAtLastFed + ties : ties;
    lastTiesPlace = place;
  }

  private long runUp(SourceCursor.Ahead ahead) {
    if (ahead == SourceCursor.Ahead.NOTIFICATION) {
      runner.runUpNotified(cursor.takeNotification());
      return 0;
    }
    if (ahead == SourceCursor.Ahead.READING
        && cursor.readingElapsedUs() < runUpTo + Math.min(runUpTies, 1)) {
      runner.runUpReading(cursor.takeReading());
      return 0;
    }
    if (ahead == SourceCursor.Ahead.EVENTS) {
      int count = Math.min(cursor.countBefore(runUpTo), CHUNK_EVENTS);
      if (count == 0 && runUpTies > 0) {
        count = 1;
        runUpTies--;
      }
      if (count > 0) {
        EventPacket piece = cursor.take(count);
        noteTies(piece);
        runner.runUp(piece);
        return 0;
      }
    }
    runUpOpen = false;
    position = runUpTo;
    setLoop(loop);
    return 0;
  }

  private void endSlice(long to) {
    open = false;
    position = to;
    long from = sliceFrom;
    if (to > from) {
      slicesSinceWrap++;
      shownLengthUs = to - from;
      meter.sliceEnded(to - from, sliceEvents);
      long offset = sliceOffsetUs;
      runner.forEachSink(
          sink -> {
            if (sink instanceof SliceSink sliced) {
              sliced.sliceEnd(from - offset, to - offset);
            }
          });
      if (stepsLeft > 0 && --stepsLeft == 0) {
        publish();
        complete(stepping);
        return;
      }
    }
    publish();
  }

  /** Cuts a slice that is half done where it is. */
  private void endSliceEarly() {
    if (open && begun && sliceEvents > 0) {
      int steps = stepsLeft;
      stepsLeft = 0;
      endSlice(lastFed + 1);
      stepsLeft = steps;
    }
    open = false;
  }

  private void wrap() throws IOException {
    long from = position;
    long to = startOfLoop();
    slicesSinceWrap = 0;
    lastTiesPlace = Long.MIN_VALUE;
    cursor.seek(to);
    pendingBreak = Reset.Cause.REWIND;
    position = to;
    keepGridTo = NO_PLACE;
    setLoop(loop);
    clock.shift(to - from);
    meter.shift(to - from);
  }

  private void end() {
    state = State.ENDED;
    clock.pause();
    meter.restart();
    // Whoever is told of the end may ask at once.
    publish();
    runner.notified(cursor.end());
    publish();
    endSteps();
  }

  /** Gives up; another jump may try again. */
  void fail(Throwable thrown) {
    endSliceEarly();
    pendingBreak = null;
    state = State.FAILED;
    clock.pause();
    meter.restart();
    message = thrown instanceof IOException ? thrown.getMessage() : thrown.toString();
    endStream();
    publish();
    List<CompletableFuture<Void>> waiting = new ArrayList<>(jumping);
    waiting.addAll(stepping);
    jumping.clear();
    stepping.clear();
    stepsLeft = 0;
    waiting.forEach(future -> future.completeExceptionally(thrown));
  }

  private void endStream() {
    if (runner.streamRunning()) {
      runner.notified(new EndOfStream(runner.lastUs()));
    }
  }

  /** Ends the stream and closes the playable; nothing may be called afterwards. */
  void close() {
    endSliceEarly();
    if (state != State.FAILED) {
      state = State.ENDED;
    }
    endStream();
    try {
      playable.close();
    } catch (IOException thrown) {
      message = thrown.getMessage();
    }
    publish();
    IllegalStateException closed = new IllegalStateException("the player is closed");
    jumping.forEach(future -> future.completeExceptionally(closed));
    stepping.forEach(future -> future.completeExceptionally(closed));
  }

  private void publish() {
    status =
        new PlayerStatus(
            state,
            state == State.ENDED ? position : shownFrom,
            shownTimeUs,
            playable.durationUs().orElse(-1),
            clock.speed(),
            meter.speed(),
            clock.unlimited() ? 0 : lagNanos / 1000,
            meter.slowestStage(),
            counters.get(Counter.EVENTS_IN),
            counters.get(Counter.EVENTS_OUT),
            meter.eventRateEps(),
            counters.get(Counter.EVENTS_OUTSIDE_SENSOR)
                + counters.get(Counter.EVENTS_LOST_IN_FAILURE)
                + counters.get(Counter.EVENTS_LOST_BEFORE),
            shownLengthUs,
            message);
  }
}
