package haltere.filters.track.kalman;

import java.util.Arrays;

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

  private final long[] timesUs = new long[ROOM];
  private final long[] seenUs = new long[ROOM];
  private final int[] ids = new int[ROOM];
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
    seenUs[next] = timeUs;
    ids[next] = track.id;
    places[3 * next] = track.nowXPx;
    places[3 * next + 1] = track.nowYPx;
    places[3 * next + 2] = REACH_RADII * Math.max(track.radiusPx, track.part.extent.radiusPx());
    next = (next + 1) % ROOM;
  }

  /** Whether what appears at a place is the rest of what has just left. */
  boolean isRest(double xPx, double yPx, long timeUs) {
    int i = find(xPx, yPx, timeUs);
    if (i == ROOM || timesUs[i] <= timeUs - LATEST_US) {
      return false;
    }
    seenUs[i] = timeUs;
    return true;
  }

  /** The identity of what has left here and was not gone since, which it has again; or 0. */
  int returning(double xPx, double yPx, long timeUs) {
    int i = find(xPx, yPx, timeUs);
    if (i == ROOM) {
      return 0;
    }
    timesUs[i] = Long.MIN_VALUE;
    return ids[i];
  }

  private int find(double xPx, double yPx, long timeUs) {
    int i = 0;
    while (i < ROOM
        && !(timesUs[i] > Long.MIN_VALUE
            && seenUs[i] <= timeUs
            && timeUs - seenUs[i] < Math.max(PAUSE_US, timesUs[i] + LATEST_US - seenUs[i])
            && Math.hypot(xPx - places[3 * i], yPx - places[3 * i + 1]) < places[3 * i + 2])) {
      i++;
    }
    return i;
  }
}
