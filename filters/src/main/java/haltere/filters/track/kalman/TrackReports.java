package haltere.filters.track.kalman;

import haltere.core.stream.ReportClock;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.MeasurementSource;

/** When tracks are reported, and which of them are shown then. Thread rule: that of its owner. */
final class TrackReports {
  /** A report goes on for so long after the last measurement of a track that is not hidden. */
  static final long SHOWN_WITHOUT_CLUSTER_US = 100_000;

  /**
   * A track is shown when its place is known this well, in standard deviations of its events: a
   * launch of two good measurements is, what gathers events of noise is not.
   */
  private static final double SURE_SPREADS = 0.5;

  /** Without anything to show for so long, times of reports are skipped. */
  private static final long LONGEST_SILENCE_US = 1_000_000;

  private final Picture picture;
  private final Tracks tracks;
  private final TrackListener listener;
  private final ReportClock clock = new ReportClock();
  private KalmanTracksSettings settings;
  private MeasurementPlane plane;
  private boolean showed;

  TrackReports(Picture picture, Tracks tracks, TrackListener listener) {
    this.picture = picture;
    this.tracks = tracks;
    this.listener = listener;
  }

  void apply(KalmanTracksSettings newSettings, MeasurementPlane newPlane) {
    settings = newSettings;
    plane = newPlane;
    clock.setRate(settings.life().reportRateHz());
  }

  void reset() {
    showed = false;
  }

  void skipTo(long timeUs) {
    clock.skipTo(timeUs);
  }

  /**
   * Reports at all times that are due.
   *
   * @param timeUs the last time that may be reported
   * @param lastStepUs when the tracks were last looked after
   */
  void reportUntil(long timeUs, long lastStepUs) {
    while (clock.nextUs() <= timeUs) {
      if (tracks.count() == 0 && !showed) {
        clock.skipTo(timeUs + 1);
        return;
      }
      long reportUs = clock.nextUs();
      clock.advance();
      boolean shows = false;
      for (int i = 0; i < tracks.count() && !shows; i++) {
        shows = shown(i, reportUs) != null;
      }
      if (shows || showed) {
        listener.reported(reportUs);
      } else if (reportUs - lastStepUs > LONGEST_SILENCE_US) {
        clock.skipTo(timeUs + 1);
      }
      showed = shows;
    }
  }

  /** A track if it is to be shown at a time, with its place on the plane, else null. */
  Track shown(int index, long timeUs) {
    Track track = tracks.get(index);
    if (track.id == 0 || track.part.isStill && !settings.things().standing()) {
      return null;
    }
    if (track.batch == null
        && !track.hidden
        && timeUs > Math.max(track.heardUs + SHOWN_WITHOUT_CLUSTER_US, track.shownUntilUs)) {
      return null;
    }
    return plane.toPixels(track.at(timeUs))
            && picture.contains(plane.xPx, plane.yPx, 0.5)
            && isPlaced(track)
        ? track
        : null;
  }

  /**
   * Whether it is known where a track is, off the road, by far better than by one of its events.
   */
  static boolean isSure(Track track) {
    double most = SURE_SPREADS * track.spreadPx;
    return track.motion.covariance(0, 0) + track.motion.covariance(1, 1) < 2 * most * most;
  }

  /**
   * Whether it is known where a track is, by far better than by one of its events; behind another
   * track, to its size.
   */
  private boolean isPlaced(Track track) {
    if (track.stands || settings.measurement().source() == MeasurementSource.CENTRE) {
      return true;
    }
    boolean behind = track.hidden || track.part.isSwollen() || track.contested && track.wasFree();
    boolean cut = !picture.contains(plane.xPx, plane.yPx, -track.radiusPx);
    double most =
        behind
            ? Math.max(track.radiusPx, track.spreadPx)
            : (cut ? 1 : SURE_SPREADS) * track.spreadPx;
    return plane.varianceXPx2 + plane.varianceYPx2 < 2 * most * most;
  }
}
