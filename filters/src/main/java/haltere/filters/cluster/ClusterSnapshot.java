package haltere.filters.cluster;

import java.util.List;

/**
 * All visible clusters at one time.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param clusters each visible cluster once
 */
public record ClusterSnapshot(long timeUs, List<Trail> clusters) {
  /** Copies the list. */
  public ClusterSnapshot {
    clusters = List.copyOf(clusters);
  }

  /**
   * A visible cluster and where it has been.
   *
   * @param path its positions at the last ticks, oldest first; the last one is the present
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
