package haltere.filters.track;

import haltere.filters.plane.PlanePoint;
import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * All tracks in the picture at one time.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param tracks each track once
 */
public record TrackSnapshot(long timeUs, List<TrackSnapshot.Shown> tracks) {
  /** Copies the list. */
  public TrackSnapshot {
    tracks = List.copyOf(tracks);
  }

  /**
   * A track and where it has been.
   *
   * @param path where it was at the last reports, oldest first; the last one is the present
   * @param covarianceXyPx2 covariance of column and row, px²
   * @param coasting whether it goes on without a cluster
   * @param onRoad where it is on a road; empty where there is none
   */
  public record Shown(
      List<TrackPoint> path,
      double covarianceXyPx2,
      boolean coasting,
      Optional<PlanePoint> onRoad) {
    /** Copies the list, which has at least one element; nothing may be null. */
    public Shown {
      path = List.copyOf(path);
      Objects.requireNonNull(onRoad, "onRoad");
      if (path.isEmpty()) {
        throw new IllegalArgumentException("a track has at least one position");
      }
    }

    /**
     * Where it is.
     *
     * @return the last element of the path
     */
    public TrackPoint now() {
      return path.get(path.size() - 1);
    }
  }
}
