package haltere.filters.wing.internal.search;

import haltere.filters.wing.WingSearchSettings;

/** Searches for the fly in the newest events. */
public interface FlySearch {
  /**
   * Begins with the first event.
   *
   * @param timeUs time of the event, microseconds
   * @param settings how the fly is searched for
   */
  void begin(long timeUs, WingSearchSettings settings);

  /**
   * Searches at a time next, whatever was found before.
   *
   * @param timeUs microseconds
   */
  void startAt(long timeUs);

  /**
   * Looks for a fly if it is time to. Called for each event while none is tracked.
   *
   * @param timeUs time of the event, microseconds
   * @param settings how it is searched for
   * @return the fly; null if there is none or it is not time
   */
  FoundFly look(long timeUs, WingSearchSettings settings);

  /**
   * The same for a fly of which one wing is tracked; only both are worth it.
   *
   * @param timeUs now, microseconds
   * @param settings how it is searched for
   * @return a fly with both wings, or null
   */
  FoundFly lookForBoth(long timeUs, WingSearchSettings settings);
}
