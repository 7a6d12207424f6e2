package haltere.filters.track.kalman;

import java.util.Arrays;

/**
 * Which tracks have never moved: places that flicker make events and are no things that move. A
 * track that has not left its place for a second is at such a place, which is remembered: what
 * begins there later has to leave it first. What has moved or turned before it stands is a thing.
 * Thread rule: that of its owner.
 */
final class StandingPlaces {
  /** What moves has moved after this time. */
  private static final long STANDING_US = 1_000_000;

  /** By how many of its radii it has, beside what its place is uncertain by. */
  private static final double MOVED_RADII = 0.15;

  /** Standard deviations of its place. */
  private static final double MOVED_SIGMAS = 4;

  /** The same where something has stood before. */
  private static final double LEFT_RADII = 0.75;

  private static final long REMEMBERED_US = 10_000_000;

  /** The last so many are remembered. */
  private static final int ROOM = 32;

  private final long[] seenUs = new long[ROOM];
  private final double[] places = new double[3 * ROOM];
  private int next;

  StandingPlaces() {
    clear();
  }

  void clear() {
    Arrays.fill(seenUs, Long.MIN_VALUE);
  }

  /** A track begins; it stands until it has moved if something has stood there. */
  void begin(Track born, long timeUs) {
    born.part.bornXPx = born.nowXPx;
    born.part.bornYPx = born.nowYPx;
    born.part.moved = false;
    born.part.isStill = find(born.nowXPx, born.nowYPx, timeUs) < ROOM;
  }

  /** Looks who has moved and who has not. */
  void step(Tracks tracks, long timeUs) {
    for (int i = 0; i < tracks.count(); i++) {
      Track track = tracks.get(i);
      if (track.part.moved || track.batch == null) {
        continue;
      }
      double dx = track.nowXPx - track.part.bornXPx;
      double dy = track.nowYPx - track.part.bornYPx;
      double way = Math.sqrt(dx * dx + dy * dy);
      double unsure = Math.sqrt(track.motion.covariance(0, 0) + track.motion.covariance(1, 1));
      double least =
          track.part.isStill
              ? LEFT_RADII * track.radiusPx
              : MOVED_RADII * track.radiusPx + MOVED_SIGMAS * unsure;
      if (way > least || track.part.hasTurned() || track.part.extent.radiusPx() > 0) {
        track.part.moved = true;
        track.part.isStill = false;
      } else if (timeUs - track.bornUs >= STANDING_US) {
        track.part.isStill = true;
        remember(track, timeUs);
      }
    }
  }

  private void remember(Track track, long timeUs) {
    int i = find(track.nowXPx, track.nowYPx, timeUs);
    if (i == ROOM) {
      i = next;
      next = (next + 1) % ROOM;
      places[3 * i] = track.nowXPx;
      places[3 * i + 1] = track.nowYPx;
    }
    places[3 * i + 2] = track.radiusPx;
    seenUs[i] = timeUs;
  }

  private int find(double xPx, double yPx, long timeUs) {
    int i = 0;
    while (i < ROOM
        && !(seenUs[i] > Long.MIN_VALUE
            && seenUs[i] <= timeUs
            && timeUs - seenUs[i] < REMEMBERED_US
            && Math.hypot(xPx - places[3 * i], yPx - places[3 * i + 1]) < places[3 * i + 2])) {
      i++;
    }
    return i;
  }
}
