package haltere.ui.viewer;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterProvider;
import haltere.core.playback.Player;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.application.Platform;

/**
 * Changes of the chain as the panels ask for them. Each runs between two packets on the processing
 * thread; what the chain is then comes back to the JavaFX thread.
 *
 * <p>Thread rule: JavaFX thread only; nothing here waits.
 */
final class ChainEditor {
  private final Consumer<String> problems;
  private final Consumer<List<StageState>> changed;
  private final List<Runnable> listeners = new ArrayList<>();
  private final Map<ChainStage, Consumer<Record>> followers = new HashMap<>();
  private Optional<Player> player = Optional.empty();

  /**
   * An editor without a chain.
   *
   * @param problems takes what went wrong, in one line
   * @param changed takes the stages after every change of their order or number
   */
  ChainEditor(Consumer<String> problems, Consumer<List<StageState>> changed) {
    this.problems = problems;
    this.changed = changed;
  }

  void setPlayer(Player newPlayer) {
    player = Optional.of(newPlayer);
    followers.clear();
    listeners.forEach(Runnable::run);
  }

  /** Calls something whenever there is another chain, or other filters in it. */
  void onChange(Runnable listener) {
    listeners.add(listener);
  }

  /** Adds a filter with default settings at the end. */
  void add(FilterProvider<?> provider) {
    restructure(chain -> chain.add(provider));
  }

  void remove(ChainStage stage) {
    restructure(chain -> chain.remove(stage));
  }

  /** Moves a stage by places; beyond an end it stays at the end. */
  void move(ChainStage stage, int places) {
    restructure(
        chain -> {
          int last = chain.stages().size() - 1;
          int position = chain.stages().indexOf(stage) + places;
          chain.move(stage, Math.max(0, Math.min(last, position)));
        });
  }

  /** Puts the stages of another chain in place of all there are. */
  void replaceAll(FilterChain other) {
    restructure(
        chain -> {
          for (ChainStage stage : List.copyOf(chain.stages())) {
            chain.remove(stage);
          }
          for (ChainStage stage : other.stages()) {
            chain.add(stage.kind(), stage.filter(), stage.isEnabled(), chain.stages().size());
          }
        });
  }

  void setEnabled(ChainStage stage, boolean enabled) {
    edit(chain -> chain.setEnabled(stage, enabled));
  }

  /**
   * Gives a filter new settings.
   *
   * @param refused called with one line if the filter does not take them
   */
  void apply(ChainStage stage, Record settings, Consumer<String> refused) {
    if (player.isEmpty()) {
      return;
    }
    player
        .get()
        .edit(chain -> chain.apply(stage, settings))
        .exceptionally(
            problem -> {
              Platform.runLater(() -> refused.accept(Texts.oneLine(problem)));
              return null;
            });
  }

  /**
   * Changes something inside the filters between two packets.
   *
   * @param refused called with one line if that cannot be
   */
  void change(Consumer<FilterChain> work, Consumer<String> refused) {
    player.ifPresent(
        open ->
            open.edit(work)
                .exceptionally(
                    problem -> {
                      Platform.runLater(() -> refused.accept(Texts.oneLine(problem)));
                      return null;
                    }));
  }

  /** Gives a filter settings from within a {@link #change}; who shows them is told. */
  void applyNow(FilterChain chain, ChainStage stage, Record settings) {
    chain.apply(stage, settings);
    Platform.runLater(
        () -> Optional.ofNullable(followers.get(stage)).ifPresent(shown -> shown.accept(settings)));
  }

  /** Tells somebody, in place of whoever was told before, of settings that others have applied. */
  void follow(ChainStage stage, Consumer<Record> follower) {
    followers.put(stage, follower);
  }

  /** Reads something off the chain between two packets and brings it to the JavaFX thread. */
  <T> void read(Function<FilterChain, T> reading, Consumer<T> taker) {
    AtomicReference<T> result = new AtomicReference<>();
    edit(chain -> result.set(reading.apply(chain)))
        .thenRun(() -> Platform.runLater(() -> taker.accept(result.get())));
  }

  private void restructure(Consumer<FilterChain> change) {
    Optional<Player> edited = player;
    AtomicReference<List<StageState>> after = new AtomicReference<>();
    edit(chain -> {
          change.accept(chain);
          after.set(StageState.of(chain));
        })
        .thenRun(
            () ->
                Platform.runLater(
                    () -> {
                      if (player.equals(edited)) {
                        changed.accept(after.get());
                        listeners.forEach(Runnable::run);
                      }
                    }));
  }

  private CompletableFuture<Void> edit(Consumer<FilterChain> change) {
    if (player.isEmpty()) {
      return new CompletableFuture<>();
    }
    CompletableFuture<Void> done = player.get().edit(change);
    done.exceptionally(
        problem -> {
          Platform.runLater(() -> problems.accept(Texts.oneLine(problem)));
          return null;
        });
    return done;
  }
}
