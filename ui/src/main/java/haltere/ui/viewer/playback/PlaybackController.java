package haltere.ui.viewer.playback;

import haltere.core.playback.Loop;
import haltere.core.playback.Mark;
import haltere.core.playback.Playable;
import haltere.core.playback.PlaybackClock;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.Slicing;
import haltere.ui.viewer.controls.Texts;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import javafx.application.Platform;
import javafx.beans.property.BooleanProperty;
import javafx.beans.property.ReadOnlyBooleanProperty;
import javafx.beans.property.ReadOnlyObjectProperty;
import javafx.beans.property.ReadOnlyObjectWrapper;
import javafx.beans.property.SimpleBooleanProperty;

/**
 * Playback for buttons, keys and seek bar: speed, slices and loop persist from one recording to the
 * next, the rest is passed to the open player.
 */
public final class PlaybackController {
  /** Speeds that are offered: 1, 2 and 5 times powers of ten. */
  static final List<Double> SPEEDS =
      List.of(
          1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0);

  /** Fastest speed but unlimited. */
  static final double MAX_SPEED = 10;

  /**
   * Slices finer than the screen's pictures, so that there is a new picture at every pulse although
   * the clocks of player and screen differ.
   */
  public static final Slicing SMOOTH = new Slicing.PerFrame(120);

  /** A fruit fly's. */
  private static final long DEFAULT_BEAT_US = 5_000;

  private final Consumer<String> problems;
  private final ReadOnlyObjectWrapper<Double> speed = new ReadOnlyObjectWrapper<>(1.0);
  private final ReadOnlyObjectWrapper<Slicing> slicing = new ReadOnlyObjectWrapper<>(SMOOTH);
  private final ReadOnlyObjectWrapper<Loop> loop = new ReadOnlyObjectWrapper<>(Loop.ALL);
  private final BooleanProperty beats = new SimpleBooleanProperty();
  private Optional<Player> player = Optional.empty();
  private boolean seeking;
  private final BooleanProperty reverse = new SimpleBooleanProperty();
  private long reverseFromUs;
  private long reverseNanos;

  /** Target of the pending jump, or of the one after it. */
  private long aimUs;

  private OptionalLong nextSeekUs = OptionalLong.empty();

  /** A controller without a player; the consumer gets problems as one line. */
  public PlaybackController(Consumer<String> problems) {
    this.problems = problems;
    beats.subscribe(
        (was, is) -> {
          if (is) {
            setBeat(DEFAULT_BEAT_US);
          }
        });
  }

  /** Options for the player of a new window. */
  public static PlayerOptions firstOptions() {
    return PlayerOptions.defaults().withSlicing(SMOOTH).withLoop(Loop.ALL);
  }

  /** Options for the next player: present speed, slices and loop. */
  public PlayerOptions options() {
    return PlayerOptions.defaults()
        .withSpeed(speed.get())
        .withSlicing(slicing.get())
        .withLoop(new Loop(loop.get().on(), OptionalLong.empty(), OptionalLong.empty()));
  }

  /** Goes over to another player, whose loop is that of {@link #options()}. */
  public void setPlayer(Player newPlayer) {
    player = Optional.of(newPlayer);
    loop.set(new Loop(loop.get().on(), OptionalLong.empty(), OptionalLong.empty()));
    seeking = false;
    reverse.set(false);
    nextSeekUs = OptionalLong.empty();
  }

  /** The player's status; empty before the first one. */
  public Optional<PlayerStatus> status() {
    return player.map(Player::status);
  }

  /** The seekable range; empty without one. */
  public Optional<SeekableRange> reach() {
    return player.map(Player::playable).filter(Playable::seekable).map(SeekableRange::of);
  }

  /** Recording time per real time; infinite for unlimited. */
  public ReadOnlyObjectProperty<Double> speedProperty() {
    return speed.getReadOnlyProperty();
  }

  /** How the stream is cut into slices. */
  public ReadOnlyObjectProperty<Slicing> slicingProperty() {
    return slicing.getReadOnlyProperty();
  }

  /** The repeated part. */
  public ReadOnlyObjectProperty<Loop> loopProperty() {
    return loop.getReadOnlyProperty();
  }

  /** Pauses in either direction, or resumes. */
  public void togglePause() {
    if (reverse.get()) {
      toggleReverse();
    } else {
      player.ifPresent(open -> report(open.togglePause()));
    }
  }

  /** Steps forward by slices, or back for negative numbers, and pauses. */
  public void step(int slices) {
    reverse.set(false);
    player.ifPresent(open -> report(open.step(slices)));
  }

  /** Goes to the beginning. */
  public void rewind() {
    reverse.set(false);
    player.ifPresent(open -> report(open.rewind()));
  }

  /** Resets all filters. */
  public void reset() {
    player.ifPresent(open -> report(open.reset()));
  }

  /** Sets the speed, limited to its range; above {@link #MAX_SPEED} is unlimited. */
  public void setSpeed(double wanted) {
    speed.set(
        wanted > MAX_SPEED * 1.0001
            ? Double.POSITIVE_INFINITY
            : Math.max(PlaybackClock.MIN_SPEED, wanted));
    restartReverse();
    boolean live = isLive();
    player.map(open -> open.setSpeed(speed.get())).filter(done -> !live).ifPresent(this::report);
  }

  /** Whether events come in real time, independent of the speed of playback. */
  public boolean isLive() {
    return player.filter(open -> open.playable().isLive()).isPresent();
  }

  /** The next higher of the speeds that are offered. */
  public void faster() {
    setSpeed(
        SPEEDS.stream()
            .filter(next -> next > speed.get() * 1.0001)
            .findFirst()
            .orElse(Double.POSITIVE_INFINITY));
  }

  /** The next lower of the speeds that are offered. */
  public void slower() {
    setSpeed(
        SPEEDS.stream()
            .filter(next -> next < speed.get() * 0.9999)
            .reduce((lower, higher) -> higher)
            .orElse(PlaybackClock.MIN_SPEED));
  }

  /** Whether it plays backwards: paused, from one moment to an earlier one. */
  public ReadOnlyBooleanProperty reverseProperty() {
    return reverse;
  }

  /** Plays backwards, or stops that. */
  public void toggleReverse() {
    reverse.set(!reverse.get() && reach().isPresent());
    if (reverse.get()) {
      player.ifPresent(open -> report(open.pause()));
      restartReverse();
    }
  }

  private void restartReverse() {
    reverseNanos = System.nanoTime();
    status().ifPresent(now -> reverseFromUs = now.elapsedUs());
  }

  /** Goes back as far as time has passed; called at each pulse of JavaFX. */
  public void pulse(long nanos) {
    if (!reverse.get() || seeking || reach().isEmpty()) {
      return;
    }
    double passedUs = (nanos - reverseNanos) / 1000.0;
    double pace = Double.isInfinite(speed.get()) ? MAX_SPEED : speed.get();
    long to = reverseFromUs - Math.round(passedUs * pace);
    SeekableRange all = reach().get();
    long first = Math.max(all.fromUs(), loop.get().on() ? loop.get().inUs().orElse(0) : 0);
    if (to >= first) {
      if (to < player.get().status().elapsedUs()) {
        goTo(to);
      }
    } else if (loop.get().on()) {
      reverseFromUs = loop.get().outUs().orElse(all.toUs()) - 1;
      reverseNanos = nanos;
      goTo(reverseFromUs);
    } else {
      reverse.set(false);
      goTo(first);
    }
  }

  void setSlicing(Slicing wanted) {
    beats.set(false);
    cut(wanted);
  }

  private void cut(Slicing wanted) {
    slicing.set(wanted);
    player.ifPresent(open -> report(open.setSlicing(wanted)));
  }

  /** Whether each slice is one wing beat, whose length is set from outside. */
  public BooleanProperty beatsProperty() {
    return beats;
  }

  /** Sets the period of a wing beat; has an effect while slices are beats. */
  public void setBeat(long periodUs) {
    cut(new Slicing.ByTime(Math.max(1, periodUs)));
  }

  /** Whether the end is followed by the beginning. */
  public void setLooping(boolean on) {
    setLoop(new Loop(on, loop.get().inUs(), loop.get().outUs()));
  }

  /** Sets the loop's start to the present position; an end before it is dropped. */
  public void markIn() {
    status()
        .ifPresent(
            now -> {
              long inUs = Math.max(0, now.elapsedUs());
              OptionalLong out = loop.get().outUs().stream().filter(us -> us > inUs).findFirst();
              setLoop(new Loop(true, OptionalLong.of(inUs), out));
            });
  }

  /**
   * Sets the loop's end after the shown slice, from which playback goes back to its start; a start
   * after the end is dropped.
   */
  public void markOut() {
    status()
        .ifPresent(
            now -> {
              long outUs = Math.max(1, now.elapsedUs() + now.sliceUs());
              OptionalLong in = loop.get().inUs().stream().filter(us -> us < outUs).findFirst();
              setLoop(new Loop(true, in, OptionalLong.of(outUs)));
              if (now.state() == PlayerStatus.State.PLAYING) {
                rewind();
              }
            });
  }

  /** Moves an end of the loop; the other end is at least 1 us away. */
  public void moveLoopEnd(boolean isStart, long elapsedUs) {
    OptionalLong in = loop.get().inUs();
    OptionalLong out = loop.get().outUs();
    if (isStart) {
      in = OptionalLong.of(Math.max(0, Math.min(elapsedUs, out.orElse(Long.MAX_VALUE) - 1)));
    } else {
      out = OptionalLong.of(Math.max(elapsedUs, in.orElse(0) + 1));
    }
    setLoop(new Loop(true, in, out));
  }

  /** Takes the ends of the loop away, so that it is all of the recording. */
  public void clearInOut() {
    setLoop(new Loop(loop.get().on(), OptionalLong.empty(), OptionalLong.empty()));
  }

  private void setLoop(Loop wanted) {
    loop.set(wanted);
    player.ifPresent(open -> report(open.setLoop(wanted)));
  }

  /** Sets a mark at the present position. */
  public void mark() {
    mark("Mark " + (marks().size() + 1));
  }

  /** Sets a named mark at the present position; an existing one is renamed. */
  public void mark(String name) {
    player.ifPresent(
        open -> {
          long here = Math.max(0, open.status().elapsedUs());
          open.marks().stream().filter(mark -> mark.elapsedUs() == here).forEach(open::removeMark);
          open.addMark(new Mark(name, here));
        });
  }

  /** Takes all marks away. */
  public void clearMarks() {
    player.ifPresent(open -> open.marks().forEach(open::removeMark));
  }

  /** The marks, in the order of their times. */
  public List<Mark> marks() {
    return player.map(Player::marks).orElse(List.of());
  }

  /** Goes to the next mark, or the one before. */
  public void toMark(boolean next) {
    long here = status().map(PlayerStatus::elapsedUs).orElse(0L);
    OptionalLong there =
        next
            ? marks().stream().mapToLong(Mark::elapsedUs).filter(us -> us > here).min()
            : marks().stream().mapToLong(Mark::elapsedUs).filter(us -> us < here).max();
    there.ifPresent(this::seek);
  }

  /** Jumps by a time from the present position, or from the target of a pending jump. */
  public void jump(long us) {
    status().ifPresent(now -> seek((seeking ? aimUs : now.elapsedUs()) + us));
  }

  /** Seeks. During a jump only the last request is kept. */
  public void seek(long elapsedUs) {
    reverse.set(false);
    goTo(elapsedUs);
  }

  private void goTo(long elapsedUs) {
    if (reach().isEmpty()) {
      return;
    }
    Player open = player.get();
    long endUs = open.playable().durationUs().orElse(Long.MAX_VALUE);
    // the end shows the last full slice, not the last event alone
    long backUs = elapsedUs >= endUs - 1 ? endUs - open.status().sliceUs() : elapsedUs;
    aimUs = open.playable().nearestUs(backUs);
    if (seeking) {
      nextSeekUs = OptionalLong.of(elapsedUs);
      return;
    }
    seeking = true;
    CompletableFuture<Void> done = open.seek(backUs);
    report(done);
    done.whenComplete(
        (nothing, problem) ->
            Platform.runLater(
                () -> {
                  if (player.get() != open) {
                    return;
                  }
                  seeking = false;
                  OptionalLong next = nextSeekUs;
                  nextSeekUs = OptionalLong.empty();
                  next.ifPresent(this::goTo);
                }));
  }

  private void report(CompletableFuture<Void> command) {
    Player asked = player.get();
    command.exceptionally(
        problem -> {
          Platform.runLater(
              () -> {
                // failures of a closed player are irrelevant
                if (player.get() == asked) {
                  problems.accept(Texts.oneLine(problem));
                }
              });
          return null;
        });
  }
}
