package haltere.ui.viewer.chain;

import haltere.core.chain.ChainStage;
import haltere.core.chain.ConfigurableFilter;
import haltere.core.chain.FilterChain;
import java.util.List;
import java.util.Optional;

/**
 * A stage and its present settings, read on the processing thread for the window.
 *
 * @param stage its timing and whether it is enabled may be read from any thread
 * @param settings the settings record, empty for a filter without
 * @param inside the stages of a chain inside the chain, empty for a filter
 */
public record StageState(ChainStage stage, Optional<Record> settings, List<StageState> inside) {
  /** All stages of a chain, read on its processing thread, or before the player has started. */
  public static List<StageState> of(FilterChain chain) {
    return chain.stages().stream()
        .map(
            stage ->
                new StageState(
                    stage,
                    stage.filter() instanceof ConfigurableFilter<?> configurable
                        ? Optional.of((Record) configurable.settings())
                        : Optional.empty(),
                    stage.filter() instanceof FilterChain nested ? of(nested) : List.of()))
        .toList();
  }
}
