package haltere.filters.cluster;

/**
 * Keeps clusters from sliding along lines. Where the events of a cluster lie on a straight line
 * that goes on beyond the cluster, only its motion across the line can be seen (the aperture
 * problem: D. Marr and S. Ullman, "Directional selectivity and its use in early visual processing",
 * 1981); what the events say along it is where more of them happen to be. Such a cluster moves
 * across its line only, at each upkeep.
 *
 * <p>A line goes on where the border of the picture cuts it off or another cluster on it overlaps
 * this one, and if the cluster, though not young, is shorter than its events ask for. Thread rule:
 * that of its owner.
 */
final class ClusterLines {
  /** How many times larger the variance along a line is than that across. */
  private static final double SLENDER = 24;

  /** The same of a cluster on which another's line goes on. */
  private static final double CONTINUING = 6;

  /** Of the pixel, pixels squared. */
  private static final double PIXEL_VARIANCE = 1.0 / 12;

  /** By how much the events ask for more than the cluster has. */
  private static final double LONGER = 1.05;

  /** Cosine of the angle up to which another cluster lies along the line. */
  private static final double ALONG = 0.8;

  /** What is older has entered, and grows only where it is longer than the cluster. */
  private static final long GROWN_US = 400_000;

  private final double right;
  private final double top;

  ClusterLines(int width, int height) {
    right = width - 0.5;
    top = height - 0.5;
  }

  /** Takes away by what a cluster has moved along its line since the upkeep before. */
  void hold(Cluster cluster, Clusters others, long timeUs) {
    double half = 0.5 * (cluster.cxx - cluster.cyy);
    double root = Math.sqrt(half * half + cluster.cxy * cluster.cxy);
    double mean = 0.5 * (cluster.cxx + cluster.cyy);
    double along = mean + root;
    cluster.lineX = 0;
    cluster.lineY = 0;
    if (timeUs - cluster.bornUs > ClusterForm.SETTLED_US
        && along > SLENDER * (mean - root + PIXEL_VARIANCE)
        && !cluster.contour.isPlaced()) {
      double ux = half >= 0 ? half + root : cluster.cxy;
      double uy = half >= 0 ? cluster.cxy : root - half;
      double perLength = 1 / Math.sqrt(ux * ux + uy * uy);
      ux *= perLength;
      uy *= perLength;
      if (goesOn(cluster, others, ux, uy, along, timeUs)) {
        cluster.lineX = ux;
        cluster.lineY = uy;
        double moved = ux * (cluster.x - cluster.heldX) + uy * (cluster.y - cluster.heldY);
        cluster.x -= moved * ux;
        cluster.y -= moved * uy;
        double sliding = ux * cluster.vx + uy * cluster.vy;
        cluster.vx -= sliding * ux;
        cluster.vy -= sliding * uy;
      }
    }
    settle(cluster);
  }

  /** Takes the place where a cluster is now as that from which it moves on. */
  static void settle(Cluster cluster) {
    cluster.heldX = cluster.x;
    cluster.heldY = cluster.y;
  }

  /**
   * Takes out of what a cluster has gathered since the last reading how far along its line that is
   * from the centre.
   */
  static void hold(Cluster cluster, double beforeS) {
    if (cluster.lineX == 0 && cluster.lineY == 0 || !(cluster.batchEvents > 0)) {
      return;
    }
    double dx = cluster.batchX / cluster.batchEvents - (cluster.x - beforeS * cluster.vx);
    double dy = cluster.batchY / cluster.batchEvents - (cluster.y - beforeS * cluster.vy);
    double off = (cluster.lineX * dx + cluster.lineY * dy) * cluster.batchEvents;
    cluster.batchX -= off * cluster.lineX;
    cluster.batchY -= off * cluster.lineY;
  }

  private boolean goesOn(
      Cluster cluster, Clusters others, double ux, double uy, double along, long timeUs) {
    if (cluster.overlapped && isContinued(cluster, others, ux, uy)) {
      return true;
    }
    double reach = cluster.reach(ux, uy);
    double asked = ClusterForm.RADII * ClusterForm.RADII * along;
    return timeUs - cluster.bornUs > GROWN_US && asked > LONGER * LONGER * reach * reach
        || isOutside(cluster.x + reach * ux, cluster.y + reach * uy)
        || isOutside(cluster.x - reach * ux, cluster.y - reach * uy);
  }

  /** Whether another cluster that overlaps this one is on the same line. */
  private static boolean isContinued(Cluster cluster, Clusters others, double ux, double uy) {
    for (int i = 0; i < others.count; i++) {
      Cluster other = others.all[i];
      double dx = other.x - cluster.x;
      double dy = other.y - cluster.y;
      double distance = Math.sqrt(dx * dx + dy * dy);
      if (other != cluster
          && isLine(other, ux, uy)
          && Math.abs(ux * dx + uy * dy) > ALONG * distance
          && distance < ClusterMerging.APART * (cluster.reach(dx, dy) + other.reach(dx, dy))) {
        return true;
      }
    }
    return false;
  }

  /** Whether the events of a cluster are on a line in a direction. */
  private static boolean isLine(Cluster cluster, double ux, double uy) {
    double along = ux * ux * cluster.cxx + 2 * ux * uy * cluster.cxy + uy * uy * cluster.cyy;
    double across = cluster.cxx + cluster.cyy - along;
    return along > CONTINUING * (across + PIXEL_VARIANCE);
  }

  private boolean isOutside(double x, double y) {
    return x < -0.5 || y < -0.5 || x > right || y > top;
  }
}
