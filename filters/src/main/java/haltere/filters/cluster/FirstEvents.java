package haltere.filters.cluster;

/**
 * The last events that belonged to no cluster, one by one, so that a newborn cluster may begin with
 * the velocity of those that made it: the slope of a line fitted to them by least squares. Of few
 * events within a short time that is a rough estimate. Thread rule: that of its owner.
 */
final class FirstEvents {
  /** A power of two. */
  private static final int ROOM = 1024;

  /** Fewer events tell nothing. */
  private static final int LEAST_EVENTS = 6;

  /** Standard deviation of their times below which they tell nothing, seconds. */
  private static final double LEAST_SPREAD_S = 0.0005;

  private final int[] xs = new int[ROOM];
  private final int[] ys = new int[ROOM];
  private final long[] timesUs = new long[ROOM];
  private long added;

  void clear() {
    added = 0;
  }

  void add(int x, int y, long timeUs) {
    int at = (int) (added++ & ROOM - 1);
    xs[at] = x;
    ys[at] = y;
    timesUs[at] = timeUs;
  }

  /**
   * Gives a cluster the velocity of the events within a rectangle of pixels since a time; none
   * where these are too few.
   */
  void setVelocity(Cluster born, int left, int bottom, int right, int top, long fromUs) {
    double n = 0;
    double t = 0;
    double x = 0;
    double y = 0;
    double tt = 0;
    double tx = 0;
    double ty = 0;
    for (long i = Math.max(0, added - ROOM); i < added; i++) {
      int at = (int) (i & ROOM - 1);
      boolean inside = xs[at] >= left && xs[at] <= right && ys[at] >= bottom && ys[at] <= top;
      if (inside && timesUs[at] >= fromUs) {
        double seconds = (timesUs[at] - fromUs) * 1e-6;
        n++;
        t += seconds;
        x += xs[at];
        y += ys[at];
        tt += seconds * seconds;
        tx += seconds * xs[at];
        ty += seconds * ys[at];
      }
    }
    double spread = tt - t * t / n;
    if (n >= LEAST_EVENTS && spread > n * LEAST_SPREAD_S * LEAST_SPREAD_S) {
      born.vx = (tx - t * x / n) / spread;
      born.vy = (ty - t * y / n) / spread;
    }
  }
}
