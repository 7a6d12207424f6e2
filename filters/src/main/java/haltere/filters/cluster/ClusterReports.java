package haltere.filters.cluster;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongConsumer;

/** What is reported of clusters, as of the last report. Thread rule: that of its owner. */
final class ClusterReports {
  private final Clusters clusters;
  private final LongConsumer atReport;
  private boolean showing;

  ClusterReports(Clusters clusters, LongConsumer atReport) {
    this.clusters = clusters;
    this.atReport = atReport;
  }

  void reset() {
    showing = false;
  }

  /** Whether there was a visible cluster at the last report. */
  boolean isShowing() {
    return showing;
  }

  /** Moves the visible clusters on to a time and says where they are. */
  void report(long timeUs) {
    boolean shows = false;
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      if (cluster.isVisible()) {
        shows = true;
        cluster.moveTo(timeUs);
        cluster.path.add(cluster, timeUs);
      }
    }
    if (shows || showing) {
      showing = shows;
      atReport.accept(timeUs);
    }
  }

  List<ClusterTrack> tracks() {
    List<ClusterTrack> tracks = new ArrayList<>(clusters.count);
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      if (isReported(cluster)) {
        tracks.add(cluster.path.last(cluster.id));
      }
    }
    return tracks;
  }

  ClusterSnapshot snapshot(long timeUs) {
    List<ClusterSnapshot.Trail> trails = new ArrayList<>(clusters.count);
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      if (isReported(cluster)) {
        trails.add(new ClusterSnapshot.Trail(cluster.path.list(cluster.id)));
      }
    }
    return new ClusterSnapshot(timeUs, trails);
  }

  private static boolean isReported(Cluster cluster) {
    return cluster.isVisible() && !cluster.path.isEmpty();
  }
}
