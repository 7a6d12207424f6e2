package haltere.ui.viewer.chain;

import haltere.core.chain.ChainStage;
import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.filters.DefaultChain;
import haltere.ui.viewer.controls.Icons;
import java.util.List;
import java.util.Optional;

/** The filters that most recordings need, each switched by one button. */
public enum UsualFilter {
  /** Removes noise. */
  DENOISE(
      "Denoise",
      "Hides events of noise: those without neighbours, and those of hot pixels.",
      Icons.DENOISE,
      "background-activity",
      "hot-pixels"),
  /** Finds objects. */
  OBJECTS(
      "Track objects",
      "Follows each moving object: its position, velocity and extent.",
      Icons.OBJECTS,
      "object-tracker"),
  /** Finds wings. */
  WINGS(
      "Track wings",
      "Follows both wings of a tethered fly within each beat.",
      Icons.WINGS,
      "wing-tracker");

  private final String words;
  private final String help;
  private final Icons icon;
  private final List<String> kinds;

  UsualFilter(String words, String help, Icons icon, String... kinds) {
    this.words = words;
    this.help = help;
    this.icon = icon;
    this.kinds = List.of(kinds);
  }

  /** What its button says. */
  public String words() {
    return words;
  }

  /** What it does, in one sentence. */
  public String help() {
    return help;
  }

  /** The icon of its button. */
  public Icons icon() {
    return icon;
  }

  /** Whether all of its filters are in a chain and on. */
  public boolean isOn(List<StageState> stages) {
    return kinds.stream()
        .allMatch(
            kind ->
                stages.stream()
                    .map(StageState::stage)
                    .anyMatch(stage -> stage.kind().equals(kind) && stage.isEnabled()));
  }

  /**
   * Switches its filters on or off, on the chain's processing thread. Those that are missing are
   * added, noise filters at the start and trackers at the end; switched off they keep their place
   * and settings.
   */
  void set(FilterChain chain, boolean on) {
    for (int i = 0; i < kinds.size(); i++) {
      String kind = kinds.get(i);
      Optional<ChainStage> there =
          chain.stages().stream().filter(stage -> stage.kind().equals(kind)).findFirst();
      if (there.isPresent()) {
        chain.setEnabled(there.get(), on);
      } else if (on) {
        ChainStage added = chain.add(Filters.named(kind));
        if (this == DENOISE) {
          chain.move(added, i);
        } else {
          applyUsual(chain, added);
        }
      }
    }
  }

  /** Gives a tracker the settings that it has where a scene begins with it. */
  private static void applyUsual(FilterChain chain, ChainStage added) {
    try (FilterChain fly = DefaultChain.forFly(chain.geometry())) {
      for (ChainStage stage : fly.stages()) {
        if (stage.kind().equals(added.kind())
            && stage.filter() instanceof ConfigurableFilter<?> usual) {
          chain.apply(added, (Record) usual.settings());
        }
      }
    }
  }
}
