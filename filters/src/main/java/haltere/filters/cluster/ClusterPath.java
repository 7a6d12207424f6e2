package haltere.filters.cluster;

import java.util.ArrayList;
import java.util.List;

/**
 * The last positions of a cluster, as reported: numbers only, so that to report costs no object.
 */
final class ClusterPath {
  private static final int NUMBERS = 9;
  private static final int WHOLE_NUMBERS = 3;

  private double[] numbers = new double[0];
  private long[] wholeNumbers = new long[0];
  private int most;
  private int size;
  private int next;

  /**
   * Makes room for some positions; if that is another number than before, forgets those there are.
   */
  void setMost(int positions) {
    if (positions != most) {
      most = positions;
      numbers = new double[most * NUMBERS];
      wholeNumbers = new long[most * WHOLE_NUMBERS];
      clear();
    }
  }

  void clear() {
    size = 0;
    next = 0;
  }

  boolean isEmpty() {
    return size == 0;
  }

  /** Adds where the cluster is now. */
  void add(Cluster cluster, long timeUs) {
    int at = next * NUMBERS;
    numbers[at++] = cluster.x;
    numbers[at++] = cluster.y;
    numbers[at++] = cluster.vx;
    numbers[at++] = cluster.vy;
    numbers[at++] = cluster.radius;
    numbers[at++] = cluster.radiusA / cluster.radiusB;
    numbers[at++] = cluster.cos == 0 ? Math.PI / 2 : Math.atan(cluster.sin / cluster.cos);
    numbers[at++] = cluster.mass;
    numbers[at] = cluster.rateHz;
    at = next * WHOLE_NUMBERS;
    wholeNumbers[at++] = timeUs;
    wholeNumbers[at++] = cluster.events;
    wholeNumbers[at] = timeUs - cluster.bornUs;
    next = (next + 1) % most;
    size = Math.min(most, size + 1);
  }

  ClusterTrack last(int id) {
    return track(id, (next + most - 1) % most);
  }

  /** Oldest position first. */
  List<ClusterTrack> list(int id) {
    List<ClusterTrack> list = new ArrayList<>(size);
    for (int i = size; i > 0; i--) {
      list.add(track(id, (next + most - i) % most));
    }
    return list;
  }

  private ClusterTrack track(int id, int index) {
    int at = index * NUMBERS;
    int whole = index * WHOLE_NUMBERS;
    return new ClusterTrack(
        wholeNumbers[whole],
        id,
        numbers[at],
        numbers[at + 1],
        numbers[at + 2],
        numbers[at + 3],
        numbers[at + 4],
        numbers[at + 5],
        numbers[at + 6],
        wholeNumbers[whole + 1],
        numbers[at + 7],
        numbers[at + 8],
        wholeNumbers[whole + 2]);
  }
}
