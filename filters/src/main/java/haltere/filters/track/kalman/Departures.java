package haltere.filters.track.kalman;

/**
 * Where tracks have left the picture a short while ago. A thing that is half outside still makes
 * events at the border when its track is gone: they are the rest of it, and no new thing. Thread
 * rule: that of its owner.
 */
final class Departures {
  /** What appears within this time is the rest of it. */
  private static final long LATEST_US = 100_000;

  /** What makes events for longer was not gone, as long as these pauses are no longer than this. */
  private static final long PAUSE_US = 60_000;

  /** How many radii away the rest may be. */
  private static final double REACH_RADII = 1.5;

  /** The last so many are remembered. */
  private static final int ROOM = 16;

  private final RecentPlaces places = new RecentPlaces(ROOM);

  /** Until when what appears at each place is the rest of what has left there. */
  private final long[] restUntilUs = new long[ROOM];

  private final int[] ids = new int[ROOM];

  void clear() {
    places.clear();
  }

  /** A track has left from where it is now. */
  void add(Track track, long timeUs) {
    double reach = REACH_RADII * Math.max(track.radiusPx, track.part.extent.radiusPx());
    long untilUs = timeUs + LATEST_US;
    int place = places.add(track.nowXPx, track.nowYPx, reach, timeUs, untilUs);
    restUntilUs[place] = untilUs;
    ids[place] = track.id;
  }

  /** Whether what appears at a place is the rest of what has just left. */
  boolean isRest(double xPx, double yPx, long timeUs) {
    int place = places.find(xPx, yPx, timeUs);
    if (place == RecentPlaces.NONE || timeUs >= restUntilUs[place]) {
      return false;
    }
    places.see(place, timeUs, Math.max(restUntilUs[place], timeUs + PAUSE_US));
    return true;
  }

  /** The identity of what has left here and was not gone since, which it has again; or 0. */
  int returning(double xPx, double yPx, long timeUs) {
    int place = places.find(xPx, yPx, timeUs);
    if (place == RecentPlaces.NONE) {
      return 0;
    }
    places.forget(place);
    return ids[place];
  }
}
