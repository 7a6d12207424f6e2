package haltere.filters.trail.internal;

import haltere.filters.trail.TrailPoint;
import java.util.List;
import java.util.Objects;

/**
 * All objects of a tracker at one time.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param trails each object once
 */
public record TrailSnapshot(long timeUs, List<TrailSnapshot.Trail> trails) {
  /** Copies the list. */
  public TrailSnapshot {
    trails = List.copyOf(trails);
  }

  /**
   * An object and its path.
   *
   * @param path its last rows, oldest first; the last one is the present
   * @param mark its drawing
   */
  public record Trail(List<TrailPoint> path, TrailMark mark) {
    /** Copies the list, which has at least one row; nothing may be null. */
    public Trail {
      path = List.copyOf(path);
      Objects.requireNonNull(mark, "mark");
      if (path.isEmpty()) {
        throw new IllegalArgumentException("a trail has at least one row");
      }
    }

    /** {@return the present row} */
    public TrailPoint now() {
      return path.get(path.size() - 1);
    }
  }
}
