package haltere.core.playback;

import haltere.core.chain.FilterChain;
import haltere.core.pipeline.ChainRunner;
import haltere.core.pipeline.OnFailure;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.Reset;
import haltere.core.stream.internal.MachineFault;
import haltere.core.stream.internal.Reason;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;

/**
 * The processing thread's part of a {@link Player}: creates its components, applies commands and
 * runs turns.
 *
 * <p>Positions are on the elapsed timeline, in microseconds. Thread rule: {@link #status()}, {@link
 * #playable()} and {@link #counters()} from any thread, the rest on the processing thread only,
 * which is the caller's.
 */
final class PlaybackEngine {
  /** Maximum number of events of a packet for the chain. */
  static final int CHUNK_EVENTS = 4096;

  private final Playable playable;
  private final FilterChain chain;
  private final PipelineCounters counters = new PipelineCounters();
  private final AwaitedRequests awaited = new AwaitedRequests();
  private final PlaybackPace pace;
  private final SliceCutter slices;
  private final StatusBoard board;
  private final ChainRunner runner;
  private final SliceRunner stream;
  private final List<WaitingCommand> waiting = new ArrayList<>();
  private double speed;
  private boolean live;

  /** A command for the chain that waits for the end of a run-up. */
  private record WaitingCommand(PlaybackCommand command, CompletableFuture<Void> done) {}

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
    SourceCursor cursor = new SourceCursor(playable, options.nanoTime());
    PlaybackClock clock = new PlaybackClock(options.nanoTime(), options.sleeper());
    speed = options.speed();
    live = playable.isLive();
    clock.setSpeed(live ? Double.POSITIVE_INFINITY : speed);
    pace = new PlaybackPace(clock, new PlaybackMeter(chain, cursor, options.nanoTime()));
    slices = new SliceCutter(clock, options.slicing(), options.loop(), playable.hasEvents());
    State state = options.paused() ? State.PAUSED : State.PLAYING;
    board = new StatusBoard(playable, slices, pace, counters, state);
    runner =
        new ChainRunner(
            chain, counters, OnFailure.GO_ON, board::setMessage, SliceSink.class::isInstance);
    stream = new SliceRunner(playable, chain, cursor, runner, slices, pace, board, awaited);
    if (options.paused()) {
      awaited.awaitSlice();
    }
  }

  Playable playable() {
    return playable;
  }

  PipelineCounters counters() {
    return counters;
  }

  PlayerStatus status() {
    return board.status();
  }

  /** Must be called before the first turn. */
  void start(CompletableFuture<Void> started) {
    awaited.awaitJump(started);
    if (board.playing()) {
      pace.resume(slices.position(), true);
    } else {
      pace.jumpTo(slices.position());
    }
  }

  /** Runs a short turn; returns the time until the next one is due, nanoseconds. */
  long turn() {
    followSource();
    if (!waiting.isEmpty() && !stream.isLeading()) {
      List<WaitingCommand> now = List.copyOf(waiting);
      waiting.clear();
      now.forEach(each -> apply(each.command(), each.done()));
    }
    return stream.turn();
  }

  /** A live source is not paced; the replay of its kept events is. */
  private void followSource() {
    if (playable.isLive() != live) {
      live = !live;
      pace.setSpeed(live ? Double.POSITIVE_INFINITY : speed, slices.nextUs());
      pace.jumpTo(slices.nextUs());
      slices.reopen();
    }
  }

  /** Enters the state FAILED, which a jump may leave. */
  void fail(Throwable thrown) {
    stream.fail(thrown);
  }

  /** Ends the stream and closes the playable; nothing may be called afterwards. */
  void close() {
    stream.close();
    waiting.forEach(
        each ->
            each.done().completeExceptionally(new IllegalStateException("the player is closed")));
    waiting.clear();
  }

  // ---- Commands

  void apply(PlaybackCommand command, CompletableFuture<Void> done) {
    boolean isForChain =
        command instanceof PlaybackCommand.Edit || command instanceof PlaybackCommand.Read;
    if (isForChain && stream.isLeading()) {
      waiting.add(new WaitingCommand(command, done));
      return;
    }
    // The status is published first, because code that waits for the future may read it at once.
    try {
      boolean later = execute(command, done);
      board.publish();
      if (!later) {
        done.complete(null);
      }
    } catch (IOException | RuntimeException | Error thrown) {
      MachineFault.rethrow(thrown);
      board.setMessage(Reason.of(thrown));
      board.publish();
      done.completeExceptionally(thrown);
    }
  }

  /** Returns true if the future is completed already, or will be later. */
  private boolean execute(PlaybackCommand command, CompletableFuture<Void> done)
      throws IOException {
    if (command instanceof PlaybackCommand.Play play) {
      return setPlaying(play.on(), done);
    } else if (command instanceof PlaybackCommand.Toggle) {
      return setPlaying(!board.playing(), done);
    } else if (command instanceof PlaybackCommand.Step step) {
      return step(step.slices(), done);
    } else if (command instanceof PlaybackCommand.Seek seek) {
      return jumpAndShow(seek.elapsedUs(), Reset.Cause.SEEK, done);
    } else if (command instanceof PlaybackCommand.Rewind) {
      return jumpAndShow(stream.startOfLoop(), Reset.Cause.REWIND, done);
    } else if (command instanceof PlaybackCommand.SetSpeed set) {
      return setSpeed(set.speed(), done);
    } else if (command instanceof PlaybackCommand.SetSlicing set) {
      slices.setSlicing(set.slicing());
    } else if (command instanceof PlaybackCommand.SetLoop set) {
      slices.setLoop(set.loop());
      slices.reopen();
    } else if (command instanceof PlaybackCommand.UserReset) {
      stream.userReset();
    } else if (command instanceof PlaybackCommand.Edit edit) {
      edit(edit.change(), edit.manual());
    } else if (command instanceof PlaybackCommand.Read read) {
      read.reader().accept(chain);
    } else if (command instanceof PlaybackCommand.Refresh) {
      stream.refresh();
    } else if (command instanceof PlaybackCommand.AddSink add) {
      runner.addSink(add.sink(), add.raw());
      if (add.sink() instanceof SliceSink) {
        stream.refresh();
      }
    } else if (command instanceof PlaybackCommand.RemoveSink remove) {
      runner.removeSink(remove.sink());
    }
    return false;
  }

  /** A live source keeps the speed for the replay of its kept events. */
  private boolean setSpeed(double wanted, CompletableFuture<Void> done) {
    speed = wanted;
    if (playable.isLive()) {
      // a fault of the caller, not of playback, whose status has no message of it
      done.completeExceptionally(
          new IOException(playable.name() + " is live: its speed cannot be changed"));
      return true;
    }
    pace.setSpeed(speed, slices.nextUs());
    slices.reopen();
    return false;
  }

  private void edit(Consumer<FilterChain> change, boolean manual) {
    long changes = chain.changes();
    try {
      change.accept(chain);
    } finally {
      if (chain.changes() != changes && !manual) {
        stream.requestRepeat();
      } else {
        stream.changedManually();
      }
    }
  }

  private boolean setPlaying(boolean on, CompletableFuture<Void> done) throws IOException {
    if (on == board.playing()) {
      return false;
    }
    if (!on) {
      pause();
      if (slices.hasBegun() || stream.isJumping()) {
        awaited.awaitSlice();
      } else {
        stream.hold();
      }
      return false;
    }
    awaited.endSteps();
    boolean fromStart = board.state() != State.PAUSED;
    if (fromStart) {
      stream.jump(stream.startOfLoop(), Reset.Cause.REWIND);
      awaited.awaitJump(done);
    }
    board.setState(State.PLAYING);
    pace.resume(slices.nextUs(), slices.hasBegun());
    return fromStart;
  }

  private void pause() {
    if (board.playing()) {
      board.setState(State.PAUSED);
      pace.hold();
    }
  }

  private boolean step(int count, CompletableFuture<Void> done) throws IOException {
    pause();
    if (count == 0 || (count > 0 && board.state() != State.PAUSED)) {
      return false;
    }
    if (count > 0) {
      // A slice that a pause has interrupted is completed as the first step.
      awaited.addSteps(count, done);
      return true;
    }
    stream.jump(stepBack(-Math.max(count, -Integer.MAX_VALUE)), Reset.Cause.SEEK);
    board.setState(State.PAUSED);
    awaited.awaitSlice(done);
    return true;
  }

  private StepBackSearch.Position stepBack(int count) throws IOException {
    long shownFrom = board.shown().elapsedUs();
    if (!playable.seekable() && shownFrom > 0) {
      throw new IOException(playable.name() + " cannot step back; rewind it");
    }
    if (slices.byCount()) {
      return stream.eventsBack((long) slices.countPerSlice() * count);
    }
    long earliest = playable.earliestUs();
    boolean toStart = slices.lengthUs() > (shownFrom - earliest) / count;
    return new StepBackSearch.Position(
        toStart ? earliest : shownFrom - slices.lengthUs() * count, 0);
  }

  private boolean jumpAndShow(long to, Reset.Cause cause, CompletableFuture<Void> done)
      throws IOException {
    stream.jump(to, cause);
    if (board.playing()) {
      awaited.awaitJump(done);
    } else {
      board.setState(State.PAUSED);
      awaited.awaitSlice(done);
    }
    return true;
  }
}
