package haltere.filters.cluster;

/**
 * What happens to the clusters of a {@link ClusterTracker} at each upkeep: they die, take on
 * another size and motion, part, merge and become visible. Thread rule: that of its owner.
 */
final class ClusterUpkeep {
  private final Clusters clusters;
  private final ClusterMerging merging;
  private final ClusterParting parting;
  private final ClusterLines lines;
  private ClusterMotion motion;
  private ClusterForm form;
  private ClusterLife life;
  private SpeedLimit speedLimit;
  private int upkeepUs;

  /** The last identity that was given out; none is given out twice. */
  private int lastId;

  ClusterUpkeep(Clusters clusters, ClusterMerging merging, ClusterLines lines) {
    this.lines = lines;
    this.clusters = clusters;
    this.merging = merging;
    parting = new ClusterParting(clusters, merging);
  }

  /** Goes on by other rules. */
  void apply(
      ClusterMotion newMotion,
      ClusterForm newForm,
      ClusterLife newLife,
      SpeedLimit newSpeedLimit,
      int newUpkeepUs) {
    speedLimit = newSpeedLimit;
    motion = newMotion;
    form = newForm;
    life = newLife;
    upkeepUs = newUpkeepUs;
    parting.apply(newMotion, newForm, newLife);
  }

  /**
   * Does what is due at a time.
   *
   * @param observer hears of visible clusters that become one or two; null for nobody
   */
  void run(long timeUs, ClusterObserver observer) {
    for (int i = 0; i < clusters.count; i++) {
      clusters.all[i].moveTo(timeUs);
    }
    life.measureNoise(clusters);
    for (int i = clusters.count - 1; i >= 0; i--) {
      Cluster cluster = clusters.all[i];
      if (life.isOver(cluster, timeUs)) {
        clusters.remove(i);
      } else {
        motion.upkeep(cluster, timeUs);
        form.upkeep(cluster, timeUs, life.noiseShare(cluster));
        lines.hold(cluster, clusters, timeUs);
        if (!clusters.isFull() && parting.partIfDue(cluster, timeUs)) {
          ClusterLines.settle(cluster);
          if (observer != null && cluster.isVisible()) {
            observer.clusterParted(timeUs, cluster.id);
          }
        }
      }
    }
    speedLimit.apply(clusters);
    merge(timeUs, observer);
    for (int i = 0; i < clusters.count; i++) {
      Cluster cluster = clusters.all[i];
      if (!cluster.isVisible() && life.isToBeSeen(cluster, clusters, timeUs)) {
        cluster.id = ++lastId;
      }
    }
  }

  private void merge(long timeUs, ClusterObserver observer) {
    for (int i = 0; i < clusters.count; i++) {
      clusters.all[i].overlapped = false;
    }
    for (int i = 0; i < clusters.count; i++) {
      for (int j = i + 1; j < clusters.count; j++) {
        Cluster first = clusters.all[i];
        Cluster second = clusters.all[j];
        if (!merging.areFarApart(first, second) && merging.unite(first, second, timeUs, upkeepUs)) {
          boolean firstStays = merging.isStronger(first, second);
          mergeInto(firstStays ? first : second, firstStays ? second : first, timeUs, observer);
          clusters.remove(firstStays ? j : i);
          // The others are looked at in the next upkeep.
          return;
        }
      }
    }
  }

  private void mergeInto(Cluster kept, Cluster lost, long timeUs, ClusterObserver observer) {
    merging.absorb(kept, lost);
    form.settle(kept, timeUs);
    ClusterLines.settle(kept);
    if (observer != null && kept.isVisible() && lost.isVisible()) {
      observer.clustersMerged(timeUs, kept.id, lost.id);
    }
  }
}
