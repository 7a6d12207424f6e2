package haltere.filters.track.kalman;

/**
 * Those that have crossed a line of late. Two vehicles are never at one place: what crosses within
 * the length and the width of one that was counted is a part of it, or it again under another name.
 *
 * <p>Thread rule: that of its owner.
 */
final class RecentCrossings {
  private static final int MOST = 16;
  private static final double US = 1e-6;

  /** A motorcycle may be followed nearer than a car. */
  private static final double NARROW_HALF_M = 0.55;

  private static final double NARROW_LENGTH_M = 3;

  /** What crosses so nearly at once is one edge, if that is not wider than a lorry. */
  private static final double AT_ONCE_M = 0.3;

  private static final double WIDEST_HALF_M = 1.35;

  private final long[] timeUs = new long[MOST];
  private final double[] xM = new double[MOST];
  private final double[] halfM = new double[MOST];
  private final double[] lengthM = new double[MOST];
  private final double[] speedMS = new double[MOST];
  private final boolean[] away = new boolean[MOST];
  private int count;
  private int next;

  /** Takes note of one that is counted. */
  void add(long atUs, double x, boolean isAway, double atMS, RoadLine line) {
    timeUs[next] = atUs;
    xM[next] = x;
    away[next] = isAway;
    speedMS[next] = Math.abs(atMS);
    halfM[next] = line.halfWidthM;
    lengthM[next] =
        line.halfWidthM < NARROW_HALF_M
            ? Math.min(NARROW_LENGTH_M, line.lengthM())
            : line.lengthM();
    next = (next + 1) % MOST;
    count = Math.min(MOST, count + 1);
  }

  /**
   * Whether what crosses is one that was counted, or a part of it.
   *
   * @param gapM how far apart two vehicles are at least
   */
  boolean contain(long atUs, double x, boolean isAway, double atMS, double half, double gapM) {
    for (int i = 0; i < count; i++) {
      double apartM = Math.abs(atUs - timeUs[i]) * US * Math.max(speedMS[i], Math.abs(atMS));
      double asideM = Math.abs(x - xM[i]);
      boolean within = apartM < lengthM[i] + gapM && asideM < Math.max(half, halfM[i]);
      boolean atOnce = apartM < AT_ONCE_M && (asideM + half + halfM[i]) / 2 < WIDEST_HALF_M;
      if (away[i] == isAway && (within || atOnce)) {
        return true;
      }
    }
    return false;
  }
}
