package haltere.filters.cluster;

import java.util.ArrayList;
import java.util.List;

/** The last positions of a cluster, as reported. */
final class ClusterPath {
  private ClusterTrack[] positions = new ClusterTrack[0];
  private int size;
  private int next;

  void clear() {
    size = 0;
    next = 0;
  }

  boolean isEmpty() {
    return size == 0;
  }

  /** Adds a position; of the older ones as many stay as there may be. */
  void add(ClusterTrack track, int most) {
    if (positions.length != most) {
      List<ClusterTrack> kept = list();
      kept = kept.subList(Math.max(0, kept.size() - most), kept.size());
      positions = kept.toArray(new ClusterTrack[most]);
      size = kept.size();
      next = size % most;
    }
    positions[next] = track;
    next = (next + 1) % most;
    size = Math.min(most, size + 1);
  }

  ClusterTrack last() {
    return positions[(next + positions.length - 1) % positions.length];
  }

  /** Oldest position first. */
  List<ClusterTrack> list() {
    List<ClusterTrack> list = new ArrayList<>(size);
    for (int i = size; i > 0; i--) {
      list.add(positions[(next + positions.length - i) % positions.length]);
    }
    return list;
  }
}
