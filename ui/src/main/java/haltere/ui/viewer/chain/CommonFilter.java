package haltere.ui.viewer.chain;

import haltere.core.chain.ChainStage;
import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.filters.DefaultChain;
import haltere.ui.viewer.controls.Icons;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/** The filters that most recordings need, each with a button. */
public enum CommonFilter {
  /** Removes noise. */
  DENOISE(Icons.DENOISE, "background-activity", "hot-pixels"),
  OBJECTS(Icons.OBJECTS, "object-tracker"),
  WINGS(Icons.WINGS, "wing-tracker");

  private final Icons icon;
  private final List<String> kinds;

  CommonFilter(Icons icon, String... kinds) {
    this.icon = icon;
    this.kinds = List.of(kinds);
  }

  /** Id of its command and its button. */
  public String id() {
    return "usual-" + name().toLowerCase(Locale.ROOT);
  }

  /** The icon of its button. */
  public Icons icon() {
    return icon;
  }

  /** Whether all of its filters are in a chain and on. */
  public boolean isOn(List<StageState> stages) {
    return stages.stream()
        .map(StageState::stage)
        .filter(ChainStage::isEnabled)
        .map(ChainStage::kind)
        .toList()
        .containsAll(kinds);
  }

  /**
   * Switches its filters on or off, on the chain's processing thread. Missing filters are added,
   * noise filters at the start and trackers at the end; disabled ones keep their position and
   * settings.
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

  /** Applies the settings that a tracker has in the default chain of a scene. */
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
