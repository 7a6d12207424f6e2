package haltere.filters.cluster;

/** What becomes of a cluster whose events are at two places. Thread rule: that of its owner. */
final class ClusterParting {
  /** A part that is nearer to another cluster than this share of its radius is that one's. */
  private static final double TAKEN_RADII = 0.5;

  private final Clusters clusters;
  private final ClusterMerging merging;
  private ClusterMotion motion;
  private ClusterForm form;
  private ClusterLife life;

  ClusterParting(Clusters clusters, ClusterMerging merging) {
    this.clusters = clusters;
    this.merging = merging;
  }

  /** Goes on by other rules. */
  void apply(ClusterMotion newMotion, ClusterForm newForm, ClusterLife newLife) {
    motion = newMotion;
    form = newForm;
    life = newLife;
  }

  /** Makes two of a cluster, if its events are at two places. */
  boolean partIfDue(Cluster cluster, long timeUs) {
    if (form.isParting(cluster, timeUs)) {
      part(cluster, timeUs);
      return true;
    }
    if (form.isSizeFree() && cluster.probe.findsAnother(cluster, timeUs)) {
      partByGap(cluster, timeUs);
      return true;
    }
    return false;
  }

  /**
   * Makes two of a cluster whose spread has two ends. Where one of its two places is that of
   * another cluster, with which it has shared the events there, it goes to the other place and
   * nothing is born: its own thing is there, and that of the other one has its cluster.
   */
  void part(Cluster cluster, long timeUs) {
    Cluster born = clusters.add();
    merging.forget(born);
    life.part(cluster, born, timeUs);
    form.part(cluster, born, timeUs);
    motion.part(cluster, born);
    merging.parted(cluster, born);
    keepWhatIsNotTaken(cluster, born);
  }

  /**
   * Makes two of the place that a cluster's probe has found and all the rest; it has the larger.
   */
  private void partByGap(Cluster cluster, long timeUs) {
    Cluster born = clusters.add();
    merging.forget(born);
    GapProbe probe = cluster.probe;
    boolean staysNear = probe.share > 0.5;
    life.part(cluster, born, Math.min(probe.share, 1 - probe.share), timeUs);
    born.balance = 0;
    become(cluster, staysNear ? probe.near : probe.far, timeUs);
    become(born, staysNear ? probe.far : probe.near, timeUs);
    motion.part(cluster, born);
    merging.parted(cluster, born);
    keepWhatIsNotTaken(cluster, born);
  }

  private void become(Cluster cluster, GapProbe.Part part, long timeUs) {
    cluster.x = part.x;
    cluster.y = part.y;
    cluster.vx = part.vx;
    cluster.vy = part.vy;
    cluster.cxx = part.xx;
    cluster.cxy = part.xy;
    cluster.cyy = part.yy;
    cluster.leadX = 0;
    cluster.leadY = 0;
    form.settle(cluster, timeUs);
  }

  private void keepWhatIsNotTaken(Cluster cluster, Cluster born) {
    boolean isStayTaken = isTaken(cluster, cluster, born);
    if (isStayTaken != isTaken(born, cluster, born)) {
      if (isStayTaken) {
        cluster.takePlaceOf(born);
      }
      clusters.remove(clusters.count - 1);
    }
  }

  private boolean isTaken(Cluster part, Cluster cluster, Cluster born) {
    for (int i = 0; i < clusters.count; i++) {
      Cluster other = clusters.all[i];
      if (other != cluster
          && other != born
          && other.isVisible()
          && Math.hypot(other.x - part.x, other.y - part.y) < TAKEN_RADII * other.radius) {
        return true;
      }
    }
    return false;
  }
}
