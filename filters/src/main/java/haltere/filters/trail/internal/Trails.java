package haltere.filters.trail.internal;

import haltere.filters.trail.TrailPoint;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Collects the last rows of each object. Thread rule: that of its owner. */
public final class Trails {
  private final Map<Integer, ArrayDeque<TrailPoint>> paths = new LinkedHashMap<>();
  private final Map<Integer, TrailMark> marks = new LinkedHashMap<>();

  /**
   * Adds the latest row of an object.
   *
   * @param row later than the previous ones
   * @param mark its drawing
   * @param maxRows rows of a path at most, at least 1
   */
  public void add(TrailPoint row, TrailMark mark, int maxRows) {
    ArrayDeque<TrailPoint> path = paths.computeIfAbsent(row.id(), id -> new ArrayDeque<>());
    path.add(row);
    while (path.size() > maxRows) {
      path.removeFirst();
    }
    marks.put(row.id(), mark);
  }

  /**
   * Removes the objects without a row at or after a time.
   *
   * @param timeUs time of a report, microseconds
   * @return the other ones
   */
  public TrailSnapshot at(long timeUs) {
    paths.values().removeIf(path -> path.getLast().timeUs() < timeUs);
    marks.keySet().retainAll(paths.keySet());
    List<TrailSnapshot.Trail> trails = new ArrayList<>();
    paths.forEach(
        (id, path) -> trails.add(new TrailSnapshot.Trail(List.copyOf(path), marks.get(id))));
    return new TrailSnapshot(timeUs, trails);
  }

  /** Removes all objects. */
  public void clear() {
    paths.clear();
    marks.clear();
  }
}
