package haltere.filters.wing.internal.search;

import haltere.core.event.SensorGeometry;
import haltere.filters.wing.WingSearchSettings;
import haltere.filters.wing.WingTrackerState;
import java.util.function.Consumer;

/**
 * Searches for the fly by its strokes ({@link FlyFinder}), at growing intervals while there is
 * none. The first search waits for a whole window of events.
 */
public final class StrokeSearch implements FlySearch {
  private static final int FIRST_WAIT_US = 10_000;
  private static final int MAX_WAIT_US = 80_000;
  private static final int MAX_WAIT_ONE_WING_US = 320_000;

  private final FlyFinder finder;
  private final RecentEvents recent;
  private long nextUs;
  private int waitUs = FIRST_WAIT_US;

  /**
   * A search.
   *
   * @param geometry of the sensor
   * @param recent the events that are searched
   * @param steps receives each step
   */
  public StrokeSearch(
      SensorGeometry geometry, RecentEvents recent, Consumer<WingTrackerState> steps) {
    finder = new FlyFinder(geometry, RecentEvents.CAPACITY, steps);
    this.recent = recent;
  }

  @Override
  public void begin(long timeUs, WingSearchSettings settings) {
    startAt(timeUs + settings.windowUs());
  }

  @Override
  public void startAt(long timeUs) {
    nextUs = timeUs;
    waitUs = FIRST_WAIT_US;
  }

  @Override
  public FoundFly look(long timeUs, WingSearchSettings settings) {
    if (timeUs < nextUs) {
      return null;
    }
    int inWindow = recent.size() - recent.indexAtOrAfter(timeUs - settings.windowUs());
    if (inWindow < settings.minEvents()) {
      nextUs = timeUs + FIRST_WAIT_US;
      return null;
    }
    FoundFly found = finder.find(recent, timeUs, settings);
    if (found == null) {
      waitLonger(timeUs, MAX_WAIT_US);
    }
    return found;
  }

  @Override
  public FoundFly findBoth(long timeUs, WingSearchSettings settings) {
    if (timeUs < nextUs) {
      return null;
    }
    FoundFly found = finder.find(recent, timeUs, settings);
    if (found != null && found.seeds()[0] != null && found.seeds()[1] != null) {
      return found;
    }
    waitLonger(timeUs, MAX_WAIT_ONE_WING_US);
    return null;
  }

  private void waitLonger(long timeUs, int longestUs) {
    nextUs = timeUs + waitUs;
    waitUs = Math.min(2 * waitUs, longestUs);
  }
}
