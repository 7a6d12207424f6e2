package haltere.filters.cluster;

/** Selects and merges clusters. Thread rule: immutable. */
final class ClusterMerging {
  /** Motion from which on a direction is known, within the averaging time of the velocity. */
  private static final double MIN_MOTION_PX = 1;

  private final ClusterMergingSettings settings;
  private final ClusterShape shape;
  private final double overlap;
  private final double differentCos;
  private final double minSpeed2;
  private final int velocityTimeUs;

  ClusterMerging(ClusterTrackerSettings all, ClusterShape shape) {
    settings = all.merging();
    this.shape = shape;
    overlap = settings.overlap() / shape.surround();
    differentCos = StrictMath.cos(StrictMath.toRadians(settings.differentAngleDeg()));
    velocityTimeUs = all.motion().velocityTimeUs();
    double minSpeed = MIN_MOTION_PX / (1e-6 * velocityTimeUs);
    minSpeed2 = minSpeed * minSpeed;
  }

  /** Whether two clusters are to merge now. */
  boolean areOne(Cluster first, Cluster second, long timeUs) {
    return settings.allowed()
        && Math.abs(first.x - second.x) < overlap * (first.extentX + second.extentX)
        && Math.abs(first.y - second.y) < overlap * (first.extentY + second.extentY)
        && !moveDifferently(first, second, timeUs);
  }

  private boolean moveDifferently(Cluster first, Cluster second, long timeUs) {
    boolean isYoung = timeUs - Math.max(first.bornUs, second.bornUs) < velocityTimeUs;
    if (settings.differentAngleDeg() >= 180 || isYoung) {
      return false;
    }
    double first2 = first.vx * first.vx + first.vy * first.vy;
    double second2 = second.vx * second.vx + second.vy * second.vy;
    double product = first.vx * second.vx + first.vy * second.vy;
    return Math.min(first2, second2) > minSpeed2
        && product < differentCos * Math.sqrt(first2 * second2);
  }

  /** Whether the first of two merging clusters is kept: one with an identity, or the heavier. */
  static boolean isStronger(Cluster first, Cluster second) {
    boolean sameKind = first.id > 0 == second.id > 0;
    return sameKind ? first.mass >= second.mass : first.id > 0;
  }

  /** Merges a cluster into a stronger one, which keeps its identity. */
  void merge(Cluster survivor, Cluster lost) {
    double share = lost.mass / Math.max(Double.MIN_NORMAL, survivor.mass + lost.mass);
    survivor.x += share * (lost.x - survivor.x);
    survivor.y += share * (lost.y - survivor.y);
    survivor.vx += share * (lost.vx - survivor.vx);
    survivor.vy += share * (lost.vy - survivor.vy);
    survivor.mass += lost.mass;
    survivor.events += lost.events;
    survivor.bornUs = Math.min(survivor.bornUs, lost.bornUs);
    survivor.supportedUs = Math.max(survivor.supportedUs, lost.supportedUs);
    if (settings.joinSize()) {
      shape.join(survivor, lost);
    }
  }
}
