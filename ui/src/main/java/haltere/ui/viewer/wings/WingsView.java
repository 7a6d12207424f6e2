package haltere.ui.viewer.wings;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.tracker.WingTracker;
import haltere.filters.wing.tracker.WingTrackerFilter;
import java.util.List;
import java.util.Optional;

/**
 * The present state of the first wing tracker of a chain, read on the processing thread for the
 * window.
 *
 * @param stage its stage
 * @param filter the stage's filter
 * @param settings in force
 * @param filters its Kalman filters
 * @param geometry of the fly, empty while there is none
 * @param regionPx radius of the region of interest, pixels
 * @param steps the last search and its outcome
 * @param status the filter's status
 */
record WingsView(
    ChainStage stage,
    WingTrackerFilter filter,
    WingTrackerSettings settings,
    List<WingFilterState> filters,
    Optional<FlyGeometry> geometry,
    double regionPx,
    List<WingTrackerState> steps,
    String status) {
  /** Looks at a chain; processing thread. */
  static Optional<WingsView> of(FilterChain chain) {
    for (ChainStage stage : chain.stages()) {
      if (stage.filter() instanceof WingTrackerFilter filter) {
        WingTracker tracker = filter.tracker();
        return Optional.of(
            new WingsView(
                stage,
                filter,
                tracker.settings(),
                tracker.filters(),
                tracker.geometry(),
                tracker.regionPx(),
                tracker.searchSteps(),
                filter.status()));
      }
    }
    return Optional.empty();
  }

  /** The same of a chain that must have a wing tracker. */
  static WingsView orRefuse(FilterChain chain) {
    return of(chain)
        .orElseThrow(() -> new IllegalArgumentException("there is no wing tracker in the chain"));
  }
}
