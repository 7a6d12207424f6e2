package haltere.filters.track.kalman;

import haltere.filters.cluster.ClusterReadings;
import haltere.filters.track.KalmanTracksSettings;

/**
 * What tracks know better than clusters: which may not merge, which must not die now, and, if it is
 * asked for, where each is.
 */
final class ClusterFeedback {
  private ClusterFeedback() {}

  /** Says it to the clusters that are read at a time. */
  static void give(
      Tracks tracks, KalmanTracksSettings settings, long timeUs, ClusterReadings readings) {
    boolean always = settings.life().feedbackToCluster();
    for (int i = 0; i < tracks.count(); i++) {
      Track track = tracks.get(i);
      if (!track.hasSeenCluster()) {
        continue;
      }
      int index = track.batch.index;
      boolean heard = timeUs - track.heardUs <= EventBatches.LONGEST_US && track.gatedInARow == 0;
      if (always && heard) {
        readings.feedBack(index, track.nowXPx, track.nowYPx, track.nowVxPxS, track.nowVyPxS);
      }
      for (int j = i + 1; track.nearUnlike && j < tracks.count(); j++) {
        Track other = tracks.get(j);
        if (other.nearUnlike
            && TrackPairs.areNear(track, other)
            && other.hasSeenCluster()
            && track.movesUnlike(other)) {
          readings.keepApart(index, other.batch.index, timeUs + settings.updateIntervalUs());
        }
      }
      if (track.contested && track.wasFree()) {
        readings.keepAlive(index, timeUs + TrackReports.SHOWN_WITHOUT_CLUSTER_US);
      }
    }
  }
}
