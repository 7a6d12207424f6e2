package haltere.filters.cluster;

/**
 * Keeps a cluster from being much faster than all visible ones around it: in swarms and on roads
 * what is next to each other moves alike, and a velocity that is far greater is a mistake. Where
 * all neighbours stand still, so does the cluster. Thread rule: that of its owner.
 */
final class SpeedLimit {
  /**
   * By how many standard deviations of its own velocity a neighbour may be faster than it seems.
   */
  private static final double SIGMAS = 2;

  private final double reachRadii;

  /** A limit by neighbours that are nearer than this many times the sum of both radii; 0: none. */
  SpeedLimit(double reachRadii) {
    this.reachRadii = reachRadii;
  }

  void apply(Clusters clusters) {
    for (int i = 0; reachRadii > 0 && i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      double most = fastestNear(cluster, clusters);
      double speed = Math.sqrt(cluster.vx * cluster.vx + cluster.vy * cluster.vy);
      if (most >= 0 && speed > most) {
        cluster.vx *= most / speed;
        cluster.vy *= most / speed;
      }
    }
  }

  /** Speed of the fastest visible neighbour, less than 0 if there is none. */
  private double fastestNear(Cluster cluster, Clusters clusters) {
    double fastest = -1;
    for (int j = 0; j < clusters.count; j++) {
      Cluster other = clusters.all[j];
      double dx = other.x - cluster.x;
      double dy = other.y - cluster.y;
      double reach = reachRadii * (cluster.radius + other.radius);
      if (other != cluster && other.isVisible() && dx * dx + dy * dy < reach * reach) {
        double speed = Math.sqrt(other.vx * other.vx + other.vy * other.vy);
        fastest = Math.max(fastest, speed + SIGMAS * Math.sqrt(other.velocityVariance));
      }
    }
    return fastest;
  }
}
