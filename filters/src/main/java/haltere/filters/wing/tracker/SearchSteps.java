package haltere.filters.wing.tracker;

import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/**
 * The steps of the last search for a fly and what became of it, to be looked at.
 *
 * <p>Thread rule: one thread at a time.
 */
final class SearchSteps {
  private final Map<Phase, WingTrackerState> found = new EnumMap<>(Phase.class);
  private WingTrackerState condition;

  /** Forgets all. */
  void clear() {
    found.clear();
    condition = null;
  }

  /** Takes a step; the first one of a search replaces those of the search before. */
  void take(WingTrackerState state) {
    switch (state.phase()) {
      case COLLECTING, TRACKING, UNLOCKED, ONE_WING, LOST -> condition = state;
      case TWO_MEANS -> {
        found.clear();
        found.put(Phase.TWO_MEANS, state);
      }
      default -> found.put(state.phase(), state);
    }
  }

  /** The steps of the last search in their order, and the condition at the end. */
  List<WingTrackerState> inOrder() {
    List<WingTrackerState> all = new ArrayList<>(found.values());
    if (condition != null) {
      all.add(condition);
    }
    return List.copyOf(all);
  }
}
