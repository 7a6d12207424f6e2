package haltere.ui.viewer.chain;

import haltere.core.chain.ChainFile;
import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.FilterProvider;
import haltere.core.sink.internal.Unchecked;
import haltere.ui.viewer.controls.Texts;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicReference;
import java.util.function.BiConsumer;
import java.util.function.BiFunction;
import java.util.function.Consumer;
import java.util.function.Function;
import javafx.application.Platform;
import javafx.scene.control.MenuItem;

/**
 * Edits the chain. Each change runs between two packets on the processing thread; the new state of
 * the chain returns to the JavaFX thread.
 */
public final class ChainEditor {
  private final Consumer<String> problems;
  private final List<Consumer<List<StageState>>> followers = new ArrayList<>();
  private final List<BiConsumer<ChainStage, Record>> adopters;
  private final List<Runnable> listeners = new ArrayList<>();
  private final EditHistory history;
  private final String prefix;
  private final ChainEditor outermost;
  private Optional<ChainAccess> player = Optional.empty();
  private BiFunction<String, ChainEditor, List<MenuItem>> presets = (id, chain) -> List.of();
  private Map<String, String> presetChains = Map.of();

  /** An editor without a chain; the consumer gets problems as one line, the history its changes. */
  public ChainEditor(Consumer<String> problems, EditHistory history) {
    this(problems, new ArrayList<>(), history, "", null);
  }

  private ChainEditor(
      Consumer<String> problems,
      List<BiConsumer<ChainStage, Record>> adopters,
      EditHistory history,
      String prefix,
      ChainEditor outermost) {
    this.problems = problems;
    this.adopters = adopters;
    this.history = history;
    this.prefix = prefix;
    this.outermost = outermost == null ? this : outermost;
  }

  /**
   * An editor of a nested chain, found by its stage's name at each change. Its changes are part of
   * this editor's history.
   */
  public ChainEditor inside(ChainStage nested) {
    String name = nested.name();
    ChainEditor inner = new ChainEditor(problems, adopters, history, path(nested) + "/", outermost);
    inner.onStages(stages -> change(chain -> {}));
    ChainAccess.Work read =
        work ->
            run(access -> access.read().run(chain -> work.accept(StageMoves.chain(chain, name))));
    inner.player =
        Optional.of(
            new ChainAccess(
                work -> edit(chain -> work.accept(StageMoves.chain(chain, name))), read, read));
    return inner;
  }

  /** The names of the chains that a stage is in, and its own. */
  String path(ChainStage stage) {
    return prefix + stage.name();
  }

  /** Switches to another chain; changes of the previous one can no longer be undone. */
  public void setAccess(ChainAccess access) {
    player = Optional.of(access);
    history.remove(this);
    listeners.forEach(Runnable::run);
  }

  /** Adds a listener to another chain, or other filters in it. */
  public void onChange(Runnable listener) {
    listeners.add(listener);
  }

  /** Adds a listener to the order and number of the stages. */
  public void onStages(Consumer<List<StageState>> follower) {
    followers.add(follower);
  }

  /** The history for undo and redo. */
  public EditHistory history() {
    return history;
  }

  /** Sets the items of a menu of presets, by the menu's id, for this chain and nested ones. */
  public void setPresets(BiFunction<String, ChainEditor, List<MenuItem>> items) {
    presets = items;
  }

  /** The items of a menu of presets. */
  public BiFunction<String, ChainEditor, List<MenuItem>> presets() {
    return outermost.presets;
  }

  /** Sets the saved presets, as JSON by their names. */
  public void setPresetChains(Map<String, String> chains) {
    presetChains = chains;
  }

  /** The name of a saved chain, by its JSON; empty if it is no preset. */
  public Optional<String> presetName(String json) {
    return presetChains.keySet().stream()
        .filter(name -> presetChains.get(name).equals(json))
        .findFirst();
  }

  /** Adds a filter with default settings at the end. */
  void add(FilterProvider<?> provider) {
    restructure("adding " + Texts.title(provider.name()), chain -> chain.add(provider));
  }

  /** Switches the filters of a button on or off; can be undone. */
  public void setCommonFilter(CommonFilter filter, String text, boolean on) {
    restructure((on ? "switching on " : "switching off ") + text, chain -> filter.set(chain, on));
  }

  /** Adds a chain without filters at the end. */
  public void addChain() {
    restructure("adding a chain", chain -> chain.add("chain", new FilterChain(chain.geometry())));
  }

  /** Removes a stage; can be undone. */
  public void remove(ChainStage stage) {
    restructure("removing " + Texts.title(stage.name()), chain -> chain.remove(stage));
  }

  /** Moves a stage by a number of positions, at most to an end. */
  void move(ChainStage stage, int places) {
    restructure(
        "moving " + Texts.title(stage.name()),
        chain -> moveTo(chain, stage, chain.stages().indexOf(stage) + places));
  }

  /** Whether a stage may be moved into this chain, or is there already. */
  boolean takes(String stagePath) {
    return !StageMoves.isWithin(prefix, stagePath);
  }

  /**
   * Moves a stage, by its {@link #path}, from any chain to before another one in this chain, or to
   * its end.
   */
  public void moveHere(String stagePath, Optional<ChainStage> target) {
    String name = StageMoves.name(stagePath);
    if (!StageMoves.prefix(stagePath).equals(prefix)) {
      String before = target.map(ChainStage::name).orElse("");
      outermost.restructure(
          "moving " + Texts.title(name),
          chain -> StageMoves.move(chain, stagePath, prefix, before));
    } else if (!target.map(ChainStage::name).equals(Optional.of(name))) {
      restructure(
          "moving " + Texts.title(name),
          chain ->
              moveTo(
                  chain,
                  chain.stage(name),
                  target.map(chain.stages()::indexOf).orElse(chain.stages().size())));
    }
  }

  /** Whether this chain is nested. */
  boolean isInside() {
    return this != outermost;
  }

  /** Moves a stage out of this chain, to before it. */
  void moveOut(ChainStage stage) {
    String chain = prefix.substring(0, prefix.length() - 1);
    outermost.restructure(
        "moving " + Texts.title(stage.name()),
        all -> StageMoves.move(all, path(stage), StageMoves.prefix(chain), StageMoves.name(chain)));
  }

  private static void moveTo(FilterChain chain, ChainStage stage, int position) {
    int last = chain.stages().size() - 1;
    chain.move(stage, Math.max(0, Math.min(last, position)));
  }

  /** Replaces all stages by those of another chain. */
  public void replaceAll(FilterChain other) {
    restructure("another chain", chain -> replaceAll(chain, other));
  }

  private static void replaceAll(FilterChain chain, FilterChain other) {
    for (ChainStage stage : List.copyOf(chain.stages())) {
      chain.remove(stage);
    }
    for (ChainStage stage : other.stages()) {
      chain.add(stage.kind(), stage.filter(), stage.isEnabled(), chain.stages().size());
    }
  }

  /** Restores the chain from its saved state. */
  private void restore(AtomicReference<String> json) {
    change(
        chain ->
            replaceAll(
                chain,
                Unchecked.read(
                    () -> ChainFile.parse(json.get(), "the chain before", chain.geometry()))));
  }

  void setEnabled(ChainStage stage, boolean enabled) {
    String name = stage.name();
    edit(chain -> chain.setEnabled(stage, enabled));
    made(
        (enabled ? "switching on " : "switching off ") + Texts.title(name),
        "switch " + prefix + name,
        () -> edit(chain -> chain.setEnabled(chain.stage(name), !enabled)),
        () -> edit(chain -> chain.setEnabled(chain.stage(name), enabled)));
  }

  private void made(String text, Object subject, Runnable undo, Runnable redo) {
    history.made(text, outermost, subject, undo, redo, System.nanoTime());
  }

  /**
   * Applies new settings to a filter and notifies the listeners.
   *
   * @param before the settings that it has
   * @param subject the changed object; successive changes of an equal one can be undone together
   * @param refused called with one line if the filter does not take them
   */
  public void apply(
      ChainStage stage, Record before, Record settings, String subject, Consumer<String> refused) {
    if (player.isEmpty()) {
      return;
    }
    String name = stage.name();
    change(chain -> chain.apply(stage, settings), refused);
    made(
        subject + " of " + Texts.title(name),
        prefix + name + "/" + subject,
        () -> reapply(name, before),
        () -> reapply(name, settings));
    adopters.forEach(adopter -> adopter.accept(stage, settings));
  }

  private void reapply(String stage, Record settings) {
    edit(chain -> applyNow(chain, chain.stage(stage), settings));
  }

  /** Adds a listener to settings of filters. */
  public void onSettings(BiConsumer<ChainStage, Record> adopter) {
    adopters.add(adopter);
  }

  /** Changes the state of filters between two packets; reports a refusal in one line. */
  public void change(Consumer<FilterChain> work, Consumer<String> refused) {
    run(access -> access.edit().run(work), refused);
  }

  /**
   * Changes the state of filters manually: their other state remains. Reports a refusal in one
   * line.
   */
  public void adjust(Consumer<FilterChain> work, Consumer<String> refused) {
    run(access -> access.adjust().run(work), refused);
  }

  /**
   * Applies settings within a {@link #change}, on the processing thread, and notifies the
   * listeners.
   */
  public void applyNow(FilterChain chain, ChainStage stage, Record settings) {
    chain.apply(stage, settings);
    Platform.runLater(() -> adopters.forEach(adopter -> adopter.accept(stage, settings)));
  }

  /** Runs a task between two packets on the processing thread. */
  public void onProcessing(Runnable work) {
    run(access -> access.read().run(chain -> work.run()));
  }

  /** Reads from the chain between two packets and returns the result on the JavaFX thread. */
  public <T> void read(Function<FilterChain, T> reading, Consumer<T> consumer) {
    read(reading, consumer, whileOpen());
  }

  /** The same, with a report if the source has been closed. */
  public <T> void read(
      Function<FilterChain, T> reading, Consumer<T> consumer, Consumer<String> refused) {
    AtomicReference<T> result = new AtomicReference<>();
    run(access -> access.read().run(chain -> result.set(reading.apply(chain))), refused)
        .thenRun(() -> Platform.runLater(() -> consumer.accept(result.get())));
  }

  /**
   * Changes the order or the number of the filters. It can be undone at once: the undo, and what
   * listeners to the history read, wait for the change.
   */
  private void restructure(String text, Consumer<FilterChain> change) {
    AtomicReference<String> before = new AtomicReference<>();
    AtomicReference<String> after = new AtomicReference<>();
    change(
            chain -> {
              before.set(ChainFile.write(chain));
              change.accept(chain);
              after.set(ChainFile.write(chain));
            })
        .exceptionally(
            refused -> {
              Platform.runLater(() -> history.remove(before));
              return null;
            });
    if (player.isPresent()) {
      made(text, before, () -> restore(before), () -> restore(after));
    }
  }

  private CompletableFuture<Void> change(Consumer<FilterChain> change) {
    Optional<ChainAccess> edited = player;
    AtomicReference<List<StageState>> after = new AtomicReference<>();
    return edit(chain -> {
          change.accept(chain);
          after.set(StageState.of(chain));
        })
        .thenRun(
            () ->
                Platform.runLater(
                    () -> {
                      if (player.equals(edited)) {
                        followers.forEach(follower -> follower.accept(after.get()));
                        listeners.forEach(Runnable::run);
                      }
                    }));
  }

  private CompletableFuture<Void> edit(Consumer<FilterChain> change) {
    return run(access -> access.edit().run(change));
  }

  private CompletableFuture<Void> run(Function<ChainAccess, CompletableFuture<Void>> work) {
    return run(work, whileOpen());
  }

  private CompletableFuture<Void> run(
      Function<ChainAccess, CompletableFuture<Void>> work, Consumer<String> refused) {
    if (player.isEmpty()) {
      return new CompletableFuture<>();
    }
    CompletableFuture<Void> done = work.apply(player.get());
    done.exceptionally(
        problem -> {
          Platform.runLater(() -> refused.accept(Texts.oneLine(problem)));
          return null;
        });
    return done;
  }

  /** Ignores failures of a chain that is no longer open. */
  private Consumer<String> whileOpen() {
    Optional<ChainAccess> asked = player;
    return problem -> {
      if (player.equals(asked)) {
        problems.accept(problem);
      }
    };
  }
}
