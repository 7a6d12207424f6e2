package haltere.filters.object;

import java.util.List;

/**
 * All objects at one time.
 *
 * @param timeUs time on the clock of the events, microseconds
 * @param paths for each object its last rows, oldest first; the last one is the present
 */
public record ObjectSnapshot(long timeUs, List<List<ObjectTrack>> paths) {
  /** Copies the lists; a path has at least one row. */
  public ObjectSnapshot {
    paths = paths.stream().map(List::copyOf).toList();
    if (paths.stream().anyMatch(List::isEmpty)) {
      throw new IllegalArgumentException("an object has at least one row");
    }
  }
}
