package haltere.filters.cluster;

import java.util.List;
import java.util.Objects;

/**
 * All visible clusters at one time.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param type shape of the clusters
 * @param clusters each visible cluster once
 */
public record ClusterSnapshot(
    long timeUs, ClusterShapeSettings.Type type, List<ClusterSnapshot.Trail> clusters) {
  /** Copies the list; nothing may be null. */
  public ClusterSnapshot {
    Objects.requireNonNull(type, "type");
    clusters = List.copyOf(clusters);
  }

  /**
   * A visible cluster and where it has been.
   *
   * @param path its positions at the last reports, oldest first; the last one is the present
   */
  public record Trail(List<ClusterTrack> path) {
    /** Copies the list, which has at least one element. */
    public Trail {
      path = List.copyOf(path);
      if (path.isEmpty()) {
        throw new IllegalArgumentException("a trail has at least one position");
      }
    }

    /**
     * The present position.
     *
     * @return the last element of the path
     */
    public ClusterTrack now() {
      return path.get(path.size() - 1);
    }
  }
}
