package haltere.filters.track.kalman;

import java.util.Arrays;

/**
 * Circles in the picture where something has been seen, each remembered until a time; of too many
 * the oldest is forgotten. Thread rule: that of its owner.
 */
final class RecentPlaces {
  /** The index of no place. */
  static final int NONE = -1;

  private final long[] seenUs;
  private final long[] untilUs;

  /** Of each place x, y and radius, pixels. */
  private final double[] circles;

  private int next;

  RecentPlaces(int most) {
    seenUs = new long[most];
    untilUs = new long[most];
    circles = new double[3 * most];
    clear();
  }

  void clear() {
    Arrays.fill(untilUs, Long.MIN_VALUE);
  }

  /** Takes note of a place that is remembered before a time; gives back its index. */
  int add(double xPx, double yPx, double radiusPx, long nowUs, long beforeUs) {
    int index = next;
    next = (next + 1) % seenUs.length;
    circles[3 * index] = xPx;
    circles[3 * index + 1] = yPx;
    resize(index, radiusPx);
    see(index, nowUs, beforeUs);
    return index;
  }

  void resize(int index, double radiusPx) {
    circles[3 * index + 2] = radiusPx;
  }

  /** Something is seen there again, so that it is remembered before another time. */
  void see(int index, long nowUs, long beforeUs) {
    seenUs[index] = nowUs;
    untilUs[index] = beforeUs;
  }

  void forget(int index) {
    untilUs[index] = Long.MIN_VALUE;
  }

  /** The index of a place that is remembered and has a point in it, or {@link #NONE}. */
  int find(double xPx, double yPx, long nowUs) {
    for (int i = 0; i < seenUs.length; i++) {
      if (seenUs[i] <= nowUs
          && nowUs < untilUs[i]
          && Math.hypot(xPx - circles[3 * i], yPx - circles[3 * i + 1]) < circles[3 * i + 2]) {
        return i;
      }
    }
    return NONE;
  }
}
