package haltere.core.playback;

import haltere.core.chain.FilterChain;
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

  private final SliceCutter cutter;
  private long outPoint = SliceCutter.NO_PLACE;

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
    cutter = new SliceCutter(cursor, runner, meter);
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
    clock.setPosition(0);
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
      cutter.reopen();
    } else if (command instanceof PlaybackCommand.SetSlicing set) {
      slicing = set.slicing();
      cutter.dropGrid();
      cutter.reopen();
    } else if (command instanceof PlaybackCommand.SetLoop set) {
      setLoop(set.loop());
      cutter.reopen();
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
    long next = cutter.isOpen() ? cutter.from() : cutter.position();
    if (cutter.hasBegun() || clock.positionUs() > next) {
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
    cutter.runUpTo(target);
    cutter.show(target.elapsedUs());
    state = State.PAUSED;
    stepsLeft = 1;
    stepping.add(done);
    return true;
  }

  private StepBackSearch.Place stepBack(int slices) throws IOException {
    if (!playable.seekable() && cutter.shownFrom() > 0) {
      throw new IOException(playable.name() + " cannot step back; rewind it");
    }
    if (slicing instanceof Slicing.ByCount byCount) {
      StepBackSearch.Place shown = cutter.shownPlace();
      cutter.endEarly();
      pendingBreak = Reset.Cause.SEEK;
      return new StepBackSearch(cursor, meter.eventRateEps())
          .before(shown, (long) byCount.events() * slices);
    }
    boolean toStart = sliceUs() > cutter.shownFrom() / slices;
    return new StepBackSearch.Place(toStart ? 0 : cutter.shownFrom() - sliceUs() * slices, 0);
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
    cutter.endEarly();
    endSteps();
    cursor.seek(place);
    pendingBreak = cause;
    cutter.moveTo(place);
    cutter.show(place);
    setLoop(loop);
    clock.setPosition(place);
    forgetLag();
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
    long out = loop.on() ? loop.outUs().orElse(SliceCutter.NO_PLACE) : SliceCutter.NO_PLACE;
    outPoint = cutter.position() < out ? out : SliceCutter.NO_PLACE;
  }

  private void userReset() {
    if (pendingBreak != null || !runner.streamRunning()) {
      return;
    }
    cutter.split();
    runner.notified(new Reset(Reset.Cause.USER, runner.lastUs(), StreamNotification.NO_TIME_US));
  }

  private void forgetLag() {
    slipNanos = 0;
    lagNanos = 0;
    meter.restart();
  }

  private void endSteps() {
    stepsLeft = 0;
    complete(stepping);
  }

  private static void complete(List<CompletableFuture<Void>> futures) {
    if (futures.isEmpty()) {
      return;
    }
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
    if (cutter.runningUp()) {
      cutter.runUp(ahead);
      if (!cutter.runningUp()) {
        setLoop(loop);
      }
      return 0;
    }
    if (!cutter.isOpen() && !openSlice(ahead)) {
      return 0;
    }
    if (!cutter.hasBegun()) {
      long wait = stepsLeft > 0 ? 0 : clock.nanosUntil(cutter.from());
      if (wait > 0) {
        return wait;
      }
      begin(-wait);
    }
    if (cutter.feed(ahead)) {
      sliceShown();
    }
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
    switch (cutter.open(ahead, slicing, sliceUs(), outPoint)) {
      case OPEN -> {
        return true;
      }
      case AT_END -> {
        if (loop.on() && cutter.slices() > 0) {
          wrap();
        } else {
          end();
        }
      }
      case AT_OUT_POINT -> wrap();
      case NOT_YET -> {}
    }
    return false;
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
    cutter.begin();
    if (stepsLeft > 0) {
      clock.setPosition(cutter.from());
      return;
    }
    if (!clock.unlimited()) {
      long slip = Math.max(0, lateNanos - MAX_CATCH_UP_NANOS);
      clock.delay(slip);
      slipNanos += slip;
      lagNanos = slipNanos + lateNanos - slip;
    }
    meter.sliceBegins(clock.nanoTime(), cutter.from());
  }

  private void sliceShown() {
    if (stepsLeft > 0) {
      stepsLeft--;
    }
    publish();
    if (stepsLeft == 0) {
      complete(stepping);
    }
  }

  private void wrap() throws IOException {
    long from = cutter.position();
    long to = startOfLoop();
    cursor.seek(to);
    pendingBreak = Reset.Cause.REWIND;
    cutter.moveTo(to);
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
    cutter.endEarly();
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
    cutter.endEarly();
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
            state == State.ENDED ? cutter.position() : cutter.shownFrom(),
            cutter.shownTimeUs(),
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
            cutter.shownLengthUs(),
            message);
  }
}
