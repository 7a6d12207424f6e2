package haltere.filters.wing.search;

import haltere.core.event.SensorGeometry;
import haltere.filters.wing.WingSearchSettings;
import haltere.filters.wing.WingTrackerState;
import java.util.function.Consumer;

/**
 * Searches for the fly in the newest events, at growing intervals while there is none.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class FlySearch {
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
   * @param geometry of the sensor
   * @param recent the events that are searched
   * @param steps takes what is found on the way
   */
  public FlySearch(SensorGeometry geometry, RecentEvents recent, Consumer<WingTrackerState> steps) {
    finder = new FlyFinder(geometry, recent.capacity());
    this.recent = recent;
    this.steps = steps;
  }

  /**
   * Looks at a time next, and often at first.
   *
   * @param timeUs microseconds
   */
  public void startAt(long timeUs) {
    nextUs = timeUs;
    waitUs = FIRST_WAIT_US;
  }

  /**
   * Looks a while from a time, and often at first.
   *
   * @param timeUs microseconds
   */
  public void startAfter(long timeUs) {
    startAt(timeUs + FIRST_WAIT_US);
  }

  /**
   * Looks for a fly if it is time to.
   *
   * @param timeUs now, microseconds
   * @param settings how it is searched for
   * @return the fly; null if there is none or it is not time
   */
  public FoundFly look(long timeUs, WingSearchSettings settings) {
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

  /**
   * The same for a fly of which one wing is tracked; only both are worth it.
   *
   * @param timeUs now, microseconds
   * @param settings how it is searched for
   * @return a fly with both wings, or null
   */
  public FoundFly lookForBoth(long timeUs, WingSearchSettings settings) {
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
