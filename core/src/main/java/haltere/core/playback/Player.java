package haltere.core.playback;

import haltere.core.chain.FilterChain;
import haltere.core.stream.StreamHandler;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentSkipListSet;
import java.util.function.Consumer;

/**
 * Plays a recording or a scene through a chain to sinks, paced by a clock, on one processing thread
 * of its own.
 *
 * <p>The stream is cut into {@link Slicing slices}. A slice goes to the chain in packets of at most
 * {@value PlaybackEngine#CHUNK_EVENTS} events, and commands are applied between two of them, so
 * that a command takes effect within milliseconds whatever the length of a slice. Sinks receive
 * these packets after the chain; a {@link SliceSink} also receives the end of each slice. A slice
 * is due when the clock reaches its start. While playback is paused, a jump shows the slice at the
 * new position.
 *
 * <p>Notifications of chain and sinks follow the grammar of {@link
 * haltere.core.stream.StreamNotification}, once each and before the packet that they concern:
 * {@code Reset(REWIND)} for {@link #rewind()} and where a loop starts again, {@code Reset(SEEK)}
 * for a seek or a step back, {@code Reset(USER)} for {@link #reset()}. Several jumps with nothing
 * played between them are one, of the last one's cause. A jump after the end of the stream is a new
 * start of the stream and no reset.
 *
 * <p>The picture of a moment does not depend on how it was reached. A jump first sends a run-up
 * through the chain, as long as the memory of the filters and of the {@link SliceSink slice sinks}
 * ({@link haltere.core.chain.EventFilter#memoryUs()}). Slice sinks receive the run-up; other sinks
 * and subscribers of outlets do not, except by {@link haltere.core.chain.Outlet#follow follow}. The
 * slice of a pause is repeated in the same way, also when the chain changes, {@link #edit}, a slice
 * sink is added, or on request, {@link #refresh}. Edits wait for the end of a run-up. Run-ups start
 * on a grid, so that neighbouring slices share one. Manual changes of filters prevent repetitions
 * until the next jump.
 *
 * <p>Nothing is skipped if source or chain are too slow: playback waits for them. {@link
 * PlayerStatus} has the reached speed, the slowest stage and the share of the source. A lag of more
 * than a second is not caught up. A filter that throws is disabled, the exception is in the status,
 * and the events of its packet are counted as lost and reported by a {@code DataLost}. A sink that
 * throws is removed.
 *
 * <p>Thread rule: all methods may be called from any thread. Filters, sinks and edits run on the
 * processing thread, and futures are completed there. The player owns its playable and closes it,
 * the chain stays the caller's, but only the player may use it between {@link #start()} and {@link
 * #close()}.
 *
 * @since 0.1
 */
public final class Player implements AutoCloseable {
  private final PlaybackThread thread;
  private final ConcurrentSkipListSet<Mark> marks = new ConcurrentSkipListSet<>();

  /**
   * A player that has not started.
   *
   * @param playable what to play; closed with the player
   * @param chain filters for the sensor of the playable
   * @param options how to start
   */
  public Player(Playable playable, FilterChain chain, PlayerOptions options) {
    thread = new PlaybackThread(new PlaybackEngine(playable, chain, options), options.sleeper());
  }

  /**
   * Adds a sink behind the chain. If a stream is running, the sink first receives its start.
   *
   * @param sink receives packets and notifications, and slice ends if it is a {@link SliceSink}
   */
  public void addSink(StreamHandler sink) {
    thread.submit(new PlaybackCommand.AddSink(Objects.requireNonNull(sink, "sink"), false));
  }

  /**
   * Adds a sink before the chain. It must not change packets.
   *
   * @param sink receives packets and notifications, and slice ends if it is a {@link SliceSink}
   */
  public void addRawSink(StreamHandler sink) {
    thread.submit(new PlaybackCommand.AddSink(Objects.requireNonNull(sink, "sink"), true));
  }

  /**
   * Removes a sink, before or after the chain.
   *
   * @param sink one that was added
   * @return completed when it receives nothing more
   */
  public CompletableFuture<Void> removeSink(StreamHandler sink) {
    return thread.submit(new PlaybackCommand.RemoveSink(sink));
  }

  /**
   * Starts the processing thread, once.
   *
   * @return completed when the stream has started
   */
  public CompletableFuture<Void> start() {
    return thread.start();
  }

  /**
   * Resumes playback; at the end, from the start or the loop's in point.
   *
   * @return completed when applied
   */
  public CompletableFuture<Void> play() {
    return thread.submit(new PlaybackCommand.Play(true));
  }

  /**
   * Pauses playback.
   *
   * @return completed when applied
   */
  public CompletableFuture<Void> pause() {
    return thread.submit(new PlaybackCommand.Play(false));
  }

  /**
   * Pauses or resumes playback.
   *
   * @return completed when applied
   */
  public CompletableFuture<Void> togglePause() {
    return thread.submit(new PlaybackCommand.Toggle());
  }

  /**
   * Pauses and shows slices without waiting for the clock.
   *
   * @param slices how many slices forward, or back if negative; one back shows the slice before the
   *     one that is shown
   * @return completed when the last of them has been shown, or when a jump or play cancels them
   */
  public CompletableFuture<Void> step(int slices) {
    return thread.submit(new PlaybackCommand.Step(slices));
  }

  /**
   * Jumps to a position.
   *
   * @param elapsedUs position on the elapsed timeline; limited to its range
   * @return completed after the jump and, while paused, when the slice has been shown; fails if the
   *     playable cannot seek there
   */
  public CompletableFuture<Void> seek(long elapsedUs) {
    return thread.submit(new PlaybackCommand.Seek(elapsedUs));
  }

  /**
   * Goes to the start, or to the in point of a loop that is on.
   *
   * @return completed as for {@link #seek}
   */
  public CompletableFuture<Void> rewind() {
    return thread.submit(new PlaybackCommand.Rewind());
  }

  /**
   * Changes the speed from here on.
   *
   * @param speed recording time per real time, {@link PlaybackClock#MIN_SPEED} or more, infinite
   *     for as fast as possible
   * @return completed when applied; exceptionally while a source is live, whose kept events are
   *     replayed at this speed
   */
  public CompletableFuture<Void> setSpeed(double speed) {
    PlaybackClock.checkSpeed(speed);
    return thread.submit(new PlaybackCommand.SetSpeed(speed));
  }

  /**
   * Changes the slices, from the next one on.
   *
   * @param slicing how the stream is cut
   * @return completed when applied
   */
  public CompletableFuture<Void> setSlicing(Slicing slicing) {
    return thread.submit(
        new PlaybackCommand.SetSlicing(Objects.requireNonNull(slicing, "slicing")));
  }

  /**
   * Changes the loop, from the next slice on.
   *
   * @param loop whether playback starts again, and where
   * @return completed when applied
   */
  public CompletableFuture<Void> setLoop(Loop loop) {
    return thread.submit(new PlaybackCommand.SetLoop(Objects.requireNonNull(loop, "loop")));
  }

  /**
   * Resets all filters and sinks at the present position, with a {@code Reset(USER)}.
   *
   * @return completed when applied
   */
  public CompletableFuture<Void> reset() {
    return thread.submit(new PlaybackCommand.UserReset());
  }

  /**
   * Changes the chain between two packets.
   *
   * @param change runs on the processing thread; what it throws fails the future. One that changes
   *     neither filters nor settings counts as manual
   * @return completed when applied
   */
  public CompletableFuture<Void> edit(Consumer<FilterChain> change) {
    return thread.submit(new PlaybackCommand.Edit(Objects.requireNonNull(change, "change"), false));
  }

  /**
   * Changes the chain manually between two packets: the state of filters stays, and no slice is
   * repeated until the next jump.
   *
   * @param change runs on the processing thread; what it throws fails the future
   * @return completed when applied
   */
  public CompletableFuture<Void> adjust(Consumer<FilterChain> change) {
    return thread.submit(new PlaybackCommand.Edit(Objects.requireNonNull(change, "change"), true));
  }

  /**
   * Reads the chain between two packets.
   *
   * @param reader runs on the processing thread and must not change the state of filters; what it
   *     throws fails the future
   * @return completed when done
   */
  public CompletableFuture<Void> read(Consumer<FilterChain> reader) {
    return thread.submit(new PlaybackCommand.Read(Objects.requireNonNull(reader, "reader")));
  }

  /**
   * Repeats the slice of a pause, because a sink needs other events; without effect while playing.
   *
   * @return completed when accepted
   */
  public CompletableFuture<Void> refresh() {
    return thread.submit(new PlaybackCommand.Refresh());
  }

  /**
   * Sets a mark.
   *
   * @param mark a named position
   * @return false if the same mark exists
   */
  public boolean addMark(Mark mark) {
    return marks.add(mark);
  }

  /**
   * Removes a mark.
   *
   * @param mark a mark
   * @return false if it does not exist
   */
  public boolean removeMark(Mark mark) {
    return marks.remove(mark);
  }

  /**
   * The marks.
   *
   * @return a copy, by position
   */
  public List<Mark> marks() {
    return List.copyOf(marks);
  }

  /**
   * The state of the player.
   *
   * @return the last snapshot
   */
  public PlayerStatus status() {
    return thread.status();
  }

  /**
   * The playable.
   *
   * @return for its name, geometry, duration and seekability only
   */
  public Playable playable() {
    return thread.playable();
  }

  /**
   * Ends the stream, with its {@code EndOfStream}, ends the thread and closes the playable.
   * Commands that were not applied fail. Waits until that is done unless called on the processing
   * thread.
   */
  @Override
  public void close() {
    thread.close();
  }
}
