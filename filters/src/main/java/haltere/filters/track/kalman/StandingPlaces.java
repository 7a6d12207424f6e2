package haltere.filters.track.kalman;

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

  private final RecentPlaces places = new RecentPlaces(ROOM);

  void clear() {
    places.clear();
  }

  /** A track begins; it stands until it has moved if something has stood there. */
  void begin(Track born, long timeUs) {
    born.part.bornXPx = born.nowXPx;
    born.part.bornYPx = born.nowYPx;
    born.part.moved = false;
    born.part.isStill = places.find(born.nowXPx, born.nowYPx, timeUs) != RecentPlaces.NONE;
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
    int place = places.find(track.nowXPx, track.nowYPx, timeUs);
    long beforeUs = timeUs + REMEMBERED_US;
    if (place == RecentPlaces.NONE) {
      places.add(track.nowXPx, track.nowYPx, track.radiusPx, timeUs, beforeUs);
    } else {
      places.resize(place, track.radiusPx);
      places.see(place, timeUs, beforeUs);
    }
  }
}
