package haltere.filters.track;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * All tracks that are shown at one time, and the road that they are on.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param tracks each track once
 * @param road what is marked on the road; empty where there is none
 */
public record TrackSnapshot(long timeUs, List<Shown> tracks, Optional<RoadMarks> road) {
  /** Copies the list; nothing may be null. */
  public TrackSnapshot {
    tracks = List.copyOf(tracks);
    Objects.requireNonNull(road, "road");
  }

  /**
   * A track and where it has been.
   *
   * @param path where it was at the last reports, oldest first; the last one is the present
   * @param covarianceXyPx2 covariance of column and row, px²
   * @param coasting whether it goes on without events
   * @param speedKmH speed on a road in kilometres an hour; NaN where there is no road
   * @param sdSpeedKmH its standard deviation, kilometres an hour; NaN where there is no road
   */
  public record Shown(
      List<TrackPoint> path,
      double covarianceXyPx2,
      boolean coasting,
      double speedKmH,
      double sdSpeedKmH) {
    /** Copies the list, which has at least one element. */
    public Shown {
      path = List.copyOf(path);
      if (path.isEmpty()) {
        throw new IllegalArgumentException("a track has at least one place");
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
