package haltere.filters.track.kalman;

import haltere.filters.track.LifeSettings;

/** Which tracks end. Thread rule: that of its owner. */
final class TrackEnds {
  private static final double US = 1e-6;

  /** Nearer to the border than this, what loses its cluster is taken to have left. */
  private static final double LEAVING_SPREADS = 1.3;

  /** Standard deviations of its place by which it is outside. */
  private static final double SURE_SIGMAS = 2;

  /** What was not seen for so long does not leave. */
  private static final long UNSEEN_US = 150_000;

  private final Picture picture;
  private final Tracks tracks;
  private final TrackParts parts;
  private final Departures departures = new Departures();

  TrackEnds(Picture picture, Tracks tracks, TrackParts parts) {
    this.picture = picture;
    this.tracks = tracks;
    this.parts = parts;
  }

  void reset() {
    departures.clear();
  }

  /** Whether what appears at a place is no new thing. */
  boolean isRest(Measurement measurement, long timeUs) {
    return departures.isRest(measurement.x, measurement.y, timeUs);
  }

  /** The identity of what has left at a place and was not gone since, or 0. */
  int returning(Measurement measurement, long timeUs) {
    return departures.returning(measurement.x, measurement.y, timeUs);
  }

  /**
   * Ends a track that has left the picture while its cluster has stayed, as that of what comes in
   * where it went out.
   *
   * @return whether it was one
   */
  boolean dropIfReplaced(Track track) {
    double unsure =
        SURE_SIGMAS
            * Math.sqrt(Math.max(track.motion.covariance(0, 0), track.motion.covariance(1, 1)));
    if (picture.contains(track.nowXPx, track.nowYPx, unsure)) {
      return false;
    }
    parts.passOn(track);
    tracks.drop(track);
    return true;
  }

  /** What has left takes no cluster of what is at the border after it. */
  void dropThoseThatLeft(long timeUs) {
    for (int i = tracks.count() - 1; i >= 0; i--) {
      if (tracks.get(i).batch == null && isLeaving(tracks.get(i), timeUs)) {
        leave(i, timeUs);
      }
    }
  }

  private void leave(int index, long timeUs) {
    Track gone = tracks.get(index);
    if (gone.id > 0 && !parts.passOn(gone)) {
      departures.add(gone, timeUs);
    }
    tracks.drop(index);
  }

  /** Drops what is out of the picture, and what has been without its cluster for too long. */
  void dropThoseThatEnd(long timeUs, LifeSettings settings) {
    for (int i = tracks.count() - 1; i >= 0; i--) {
      Track track = tracks.get(i);
      track.look(timeUs);
      if (track.batch != null) {
        if (!track.inView) {
          leave(i, timeUs);
        }
        continue;
      }
      if (isLeaving(track, timeUs)) {
        leave(i, timeUs);
        continue;
      }
      double silentS = (timeUs - track.heardUs) * US;
      boolean coasts = track.inView && silentS <= settings.coastTimeS();
      boolean rests = track.mayRest() && silentS <= settings.restTimeS();
      if (track.id == 0 || !coasts && !rests) {
        parts.passOn(track);
        tracks.drop(i);
      }
    }
  }

  /**
   * Whether a track that has just lost its cluster is at the border of the picture or beyond it.
   * One of which nothing was seen on its way to the border has stopped.
   */
  private boolean isLeaving(Track track, long timeUs) {
    if (timeUs - track.heardUs > UNSEEN_US) {
      return false;
    }
    double border =
        Math.min(LEAVING_SPREADS * track.spreadPx, picture.geometry().longerSide() * 0.1);
    return !picture.contains(track.nowXPx, track.nowYPx, -border);
  }
}
