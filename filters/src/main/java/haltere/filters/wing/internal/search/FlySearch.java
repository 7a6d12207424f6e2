package haltere.filters.wing.internal.search;

import haltere.filters.wing.WingSearchSettings;

/** Searches the fly in the newest events. */
public interface FlySearch {
  /**
   * Starts at the first event.
   *
   * @param timeUs time of the event, microseconds
   * @param settings of the search
   */
  void begin(long timeUs, WingSearchSettings settings);

  /**
   * Sets the time of the next search, whatever was found before.
   *
   * @param timeUs microseconds
   */
  void startAt(long timeUs);

  /**
   * Searches if it is time to. Called for each event while no fly is tracked.
   *
   * @param timeUs time of the event, microseconds
   * @param settings of the search
   * @return the fly; null if there is none or it is not time
   */
  FoundFly look(long timeUs, WingSearchSettings settings);

  /**
   * The same for a fly of which one wing is tracked; accepts a fly with both wings only.
   *
   * @param timeUs now, microseconds
   * @param settings of the search
   * @return a fly with both wings, or null
   */
  FoundFly findBoth(long timeUs, WingSearchSettings settings);
}
