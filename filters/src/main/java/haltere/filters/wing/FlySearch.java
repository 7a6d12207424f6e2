package haltere.filters.wing;

import java.util.function.Consumer;

/**
 * Searches for the fly in the newest events, at growing intervals while there is none.
 *
 * <p>Thread rule: one thread at a time.
 */
final class FlySearch {
  private static final int FIRST_WAIT_US = 10_000;
  private static final int LONGEST_WAIT_US = 80_000;
  private static final int LONGEST_WAIT_ONE_WING_US = 320_000;

  private final FlyFinder finder;
  private final RecentEvents recent;
  private final Consumer<WingTrackerState> steps;
  private long nextUs;
  private int waitUs = FIRST_WAIT_US;

  /**
   * A search.
   *
   * @param finder looks once
   * @param recent the events that are searched
   * @param steps takes what is found on the way
   */
  FlySearch(FlyFinder finder, RecentEvents recent, Consumer<WingTrackerState> steps) {
    this.finder = finder;
    this.recent = recent;
    this.steps = steps;
  }

  /** Looks at a time next, and often at first. */
  void startAt(long timeUs) {
    nextUs = timeUs;
    waitUs = FIRST_WAIT_US;
  }

  /** Often at first, a while from now. */
  void startAfter(long timeUs) {
    startAt(timeUs + FIRST_WAIT_US);
  }

  /** Looks for a fly if it is time to; null if there is none or it is not. */
  FoundFly look(long timeUs, WingSearchSettings settings) {
    if (timeUs < nextUs) {
      return null;
    }
    int inWindow = recent.size() - recent.indexAtOrAfter(timeUs - settings.windowUs());
    if (inWindow < settings.leastEvents()) {
      nextUs = timeUs + FIRST_WAIT_US;
      return null;
    }
    FoundFly found = find(timeUs, settings);
    if (found == null) {
      waitLonger(timeUs, LONGEST_WAIT_US);
    }
    return found;
  }

  /** The same for a fly of which one wing is tracked; only both are worth it. */
  FoundFly lookForBoth(long timeUs, WingSearchSettings settings) {
    if (timeUs < nextUs) {
      return null;
    }
    FoundFly found = find(timeUs, settings);
    if (found != null && found.seeds()[0] != null && found.seeds()[1] != null) {
      return found;
    }
    waitLonger(timeUs, LONGEST_WAIT_ONE_WING_US);
    return null;
  }

  private void waitLonger(long timeUs, int longestUs) {
    nextUs = timeUs + waitUs;
    waitUs = Math.min(2 * waitUs, longestUs);
  }

  private FoundFly find(long timeUs, WingSearchSettings settings) {
    return finder.find(
        recent,
        timeUs - settings.windowUs(),
        settings,
        (step, events, hz, x, y, heading, size, confidence) ->
            steps.accept(
                new WingTrackerState(timeUs, step, events, hz, x, y, heading, size, confidence)));
  }
}
