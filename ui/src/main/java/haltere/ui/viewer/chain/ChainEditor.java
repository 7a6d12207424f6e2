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
 * Changes of the chain as the panels ask for them. Each runs between two packets on the processing
 * thread; what the chain is then comes back to the JavaFX thread.
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

  /** An editor without a chain; tells what went wrong in one line. */
  public ChainEditor(Consumer<String> problems) {
    this(problems, new ArrayList<>(), new EditHistory(), "", null);
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
   * An editor of a chain inside this one, which is found by its stage's name at each change. What
   * it changes is shown and taken back with all else.
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

  /** Goes over to another chain; what was changed in the one before can no longer be undone. */
  public void setAccess(ChainAccess access) {
    player = Optional.of(access);
    history.clear();
    listeners.forEach(Runnable::run);
  }

  /** Calls something whenever there is another chain, or other filters in it. */
  public void onChange(Runnable listener) {
    listeners.add(listener);
  }

  /** Calls something with the stages after every change of their order or number. */
  public void onStages(Consumer<List<StageState>> follower) {
    followers.add(follower);
  }

  /** What can be taken back. */
  public EditHistory history() {
    return history;
  }

  /**
   * Says what a menu of presets offers, by the menu's id, for this chain and those inside of it.
   */
  public void setPresets(BiFunction<String, ChainEditor, List<MenuItem>> items) {
    presets = items;
  }

  /** What a menu of presets offers. */
  public BiFunction<String, ChainEditor, List<MenuItem>> presets() {
    return outermost.presets;
  }

  /** Says which presets there are, as JSON by their names. */
  public void setPresetChains(Map<String, String> chains) {
    presetChains = chains;
  }

  /** What a saved chain is called, by its JSON; empty for one that is no preset. */
  public Optional<String> presetName(String json) {
    return presetChains.keySet().stream()
        .filter(name -> presetChains.get(name).equals(json))
        .findFirst();
  }

  /** Adds a filter with default settings at the end. */
  void add(FilterProvider<?> provider) {
    restructure("adding " + Texts.title(provider.name()), chain -> chain.add(provider));
  }

  /** Switches the filters of a button, by its words, on or off; may be taken back. */
  public void setUsual(UsualFilter filter, String words, boolean on) {
    restructure((on ? "switching on " : "switching off ") + words, chain -> filter.set(chain, on));
  }

  /** Adds a chain without filters at the end. */
  public void addChain() {
    restructure("adding a chain", chain -> chain.add("chain", new FilterChain(chain.geometry())));
  }

  /** Removes a stage; may be taken back. */
  public void remove(ChainStage stage) {
    restructure("removing " + Texts.title(stage.name()), chain -> chain.remove(stage));
  }

  /** Moves a stage by places; beyond an end it stays at the end. */
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
   * Moves a stage, by its {@link #path}, to the place of another one in this chain, or to its end,
   * from wherever it is.
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

  /** Whether this chain is inside another one. */
  boolean isInside() {
    return this != outermost;
  }

  /** Moves a stage out of this chain, to the place before it. */
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

  /** Puts the stages of another chain in place of all there are. */
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

  /** Makes the chain what it was when it was written down. */
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

  private void made(String words, Object subject, Runnable undo, Runnable redo) {
    history.made(words, subject, undo, redo, System.nanoTime());
  }

  /**
   * Gives a filter new settings; who shows them is told.
   *
   * @param before the settings that it has
   * @param subject what is changed, so that changes of the same can be taken back as one
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

  /** Tells somebody of settings that a filter was given. */
  public void onSettings(BiConsumer<ChainStage, Record> adopter) {
    adopters.add(adopter);
  }

  /**
   * Changes something inside the filters between two packets; tells in one line if that cannot be.
   */
  public void change(Consumer<FilterChain> work, Consumer<String> refused) {
    run(access -> access.edit().run(work), refused);
  }

  /**
   * Changes something inside the filters by hand: what they know at this moment stays. Tells in one
   * line if that cannot be.
   */
  public void adjust(Consumer<FilterChain> work, Consumer<String> refused) {
    run(access -> access.adjust().run(work), refused);
  }

  /**
   * Gives a filter settings from within a {@link #change}, on the processing thread; who shows them
   * is told.
   */
  public void applyNow(FilterChain chain, ChainStage stage, Record settings) {
    chain.apply(stage, settings);
    Platform.runLater(() -> adopters.forEach(adopter -> adopter.accept(stage, settings)));
  }

  /** Does something between two packets on the processing thread. */
  public void onProcessing(Runnable work) {
    run(access -> access.read().run(chain -> work.run()));
  }

  /** Reads something off the chain between two packets and brings it to the JavaFX thread. */
  public <T> void read(Function<FilterChain, T> reading, Consumer<T> consumer) {
    read(reading, consumer, whileOpen());
  }

  /**
   * The same, where it matters that nothing could be read, because what was open has been closed.
   */
  public <T> void read(
      Function<FilterChain, T> reading, Consumer<T> consumer, Consumer<String> refused) {
    AtomicReference<T> result = new AtomicReference<>();
    run(access -> access.read().run(chain -> result.set(reading.apply(chain))), refused)
        .thenRun(() -> Platform.runLater(() -> consumer.accept(result.get())));
  }

  /**
   * Changes the order or the number of the filters. It can be taken back at once: what is undone
   * meanwhile waits behind the change.
   */
  private void restructure(String words, Consumer<FilterChain> change) {
    AtomicReference<String> before = new AtomicReference<>();
    AtomicReference<String> after = new AtomicReference<>();
    if (player.isPresent()) {
      made(words, before, () -> restore(before), () -> restore(after));
    }
    change(
            chain -> {
              before.set(ChainFile.write(chain));
              change.accept(chain);
              after.set(ChainFile.write(chain));
            })
        .exceptionally(
            refused -> {
              Platform.runLater(() -> history.forget(before));
              return null;
            });
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

  /** What could not be done with a chain that is no longer open is nobody's loss. */
  private Consumer<String> whileOpen() {
    Optional<ChainAccess> asked = player;
    return problem -> {
      if (player.equals(asked)) {
        problems.accept(problem);
      }
    };
  }
}
