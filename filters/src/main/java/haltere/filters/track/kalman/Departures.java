package haltere.filters.track.kalman;

import java.util.Arrays;

/**
 * Where tracks have left the picture a short while ago. A thing that is half outside still makes
 * events at the border when its track is gone: they are the rest of it, and no new thing. Thread
 * rule: that of its owner.
 */
final class Departures {
  /** What appears later than this is something else. */
  private static final long LATEST_US = 100_000;

  /** How many radii away the rest may be. */
  private static final double REACH_RADII = 1.5;

  /** The last so many are remembered. */
  private static final int ROOM = 16;

  private final long[] timesUs = new long[ROOM];
  private final double[] places = new double[3 * ROOM];
  private int next;

  Departures() {
    clear();
  }

  void clear() {
    Arrays.fill(timesUs, Long.MIN_VALUE);
  }

  /** A track has left from where it is now. */
  void add(Track track, long timeUs) {
    timesUs[next] = timeUs;
    places[3 * next] = track.nowXPx;
    places[3 * next + 1] = track.nowYPx;
    places[3 * next + 2] = REACH_RADII * track.radiusPx;
    next = (next + 1) % ROOM;
  }

  /** Whether what appears at a place is the rest of what has just left. */
  boolean isRest(double xPx, double yPx, long timeUs) {
    for (int i = 0; i < ROOM; i++) {
      boolean justLeft = timesUs[i] <= timeUs && timesUs[i] > timeUs - LATEST_US;
      if (justLeft
          && Math.hypot(xPx - places[3 * i], yPx - places[3 * i + 1]) < places[3 * i + 2]) {
        return true;
      }
    }
    return false;
  }
}
