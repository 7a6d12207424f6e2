package haltere.filters.cluster;

import haltere.filters.cluster.ClusterMotionSettings.Mixing;

/**
 * The gains with which events move a cluster, set at each upkeep.
 *
 * <p>Adaptive: a line is fitted to the events of the last T seconds. For n events at equal
 * intervals, the newest last, the fit of least squares moves the end of the line by a = 4 / n of
 * what is left and its slope by b = 6 / (n T) (leading terms of the growing memory filter, N.
 * Morrison, "Introduction to Sequential Smoothing and Prediction", 1969). With T as old as the
 * cluster the fit uses everything; later T is held. What is left, averaged over a third of T, has a
 * known variance as long as a line fits; where it is larger the motion turns and T is made shorter,
 * otherwise T grows again.
 */
final class ClusterMotion {
  /**
   * Squared length of the averaged rest, over its expectation, from which the line does not fit.
   */
  private static final double MISFIT = 3;

  /** How much faster a memory shortens than it grows. */
  private static final double HASTE = 4;

  private static final double PARTED_MEMORY_S = 0.05;

  /** The first events, within a short time, say little about the velocity. */
  private static final double FIRST_MEMORY_S = 0.01;

  private static final double LEAST_MEMORY_S = 0.02;
  private static final double LEAST_EVENTS = 12;
  private static final double GREATEST_GAIN = 0.5;

  private final ClusterMotionSettings settings;
  private final double upkeepS;
  private final double weightDecay;
  private final double velocityDecay;
  private final double rateGain;
  private final double threshold;

  ClusterMotion(ClusterTrackerSettings all) {
    settings = all.motion();
    double upkeepUs = all.output().upkeepUs();
    threshold = all.life().visibleRateHz();
    upkeepS = upkeepUs * 1e-6;
    weightDecay = StrictMath.exp(-upkeepUs / settings.mixingTimeUs());
    double velocityTimeUs =
        settings.predict()
            ? settings.velocity().frictionTimeUs() == 0
                ? Double.POSITIVE_INFINITY
                : settings.velocity().frictionTimeUs()
            : settings.velocity().timeUs();
    velocityDecay = StrictMath.exp(-upkeepUs / velocityTimeUs);
    rateGain = 1 - StrictMath.exp(-upkeepUs / all.life().recentUs());
  }

  /** Begins a motion with what is known of the events that made the cluster. */
  void begin(Cluster cluster, double events, double ageS) {
    cluster.memoryS = Math.max(FIRST_MEMORY_S, ageS);
    cluster.rateHz = events / Math.max(upkeepS, ageS);
    cluster.weights = events;
    cluster.driftX = 0;
    cluster.driftY = 0;
    cluster.fresh = 0;
    setGains(cluster);
  }

  /** Lets both parts of a cluster find their own motion, beginning with what it had. */
  void part(Cluster cluster, Cluster born) {
    begin(born, 0.5 * cluster.rateHz * PARTED_MEMORY_S, PARTED_MEMORY_S);
    begin(cluster, 0.5 * cluster.rateHz * PARTED_MEMORY_S, PARTED_MEMORY_S);
  }

  /** Takes over new settings. */
  void setGains(Cluster cluster) {
    cluster.carry = settings.predict() ? 1e-6 : 0;
    cluster.velocityShare = 1e6 / settings.velocity().timeUs();
    cluster.gainByWeights = settings.mixing() == Mixing.PER_TIME;
    double events = Math.max(1, cluster.rateHz * cluster.memoryS);
    switch (settings.mixing()) {
      case PER_EVENT, PER_EVENT_AND_RATE -> {
        cluster.gain = settings.mixingFactor() * lessByRate(cluster);
        cluster.velocityGain = cluster.gain * cluster.velocityShare;
      }
      case PER_TIME -> {
        cluster.gain = 1 / Math.max(1, cluster.weights);
        cluster.velocityGain = cluster.gain * cluster.velocityShare;
      }
      default -> {
        cluster.gain = Math.min(GREATEST_GAIN, 4 / events);
        cluster.velocityGain = 1.5 * cluster.gain / cluster.memoryS;
      }
    }
    cluster.driftGain = Math.min(GREATEST_GAIN, 1.5 * cluster.gain);
    // Of the slope of the line, 12 variance / (n T T), in terms of the gains.
    double variance = 0.5 * (cluster.cxx + cluster.cyy);
    cluster.velocityVariance =
        4 * variance * cluster.velocityGain * cluster.velocityGain / (3 * cluster.gain);
  }

  /** By what the weight of an event is less because there are many. */
  private double lessByRate(Cluster cluster) {
    double usual = threshold * Math.PI * cluster.radiusA * cluster.radiusB;
    return settings.mixing() == Mixing.PER_EVENT || cluster.rateHz <= usual
        ? 1
        : usual / cluster.rateHz;
  }

  /** Attends to a cluster that has been moved to the time of the upkeep. */
  void upkeep(Cluster cluster, long timeUs) {
    double ageS = (timeUs - cluster.bornUs) * 1e-6;
    double share = Math.max(rateGain, upkeepS / (ageS + upkeepS));
    cluster.rateHz += share * (cluster.fresh / upkeepS - cluster.rateHz);
    cluster.fresh = 0;
    cluster.weights *= weightDecay;
    cluster.vx *= velocityDecay;
    cluster.vy *= velocityDecay;
    if (settings.mixing() == Mixing.ADAPTIVE) {
      adaptMemory(cluster);
    }
    setGains(cluster);
  }

  private void adaptMemory(Cluster cluster) {
    double g = cluster.driftGain;
    double misfit =
        (cluster.driftX * (cluster.ixx * cluster.driftX + 2 * cluster.ixy * cluster.driftY)
                + cluster.iyy * cluster.driftY * cluster.driftY)
            * (2 - g)
            / (2 * g);
    // Where clusters overlap, what is left over is the other's.
    double step =
        cluster.overlapped
            ? 0
            : misfit > MISFIT ? -HASTE * upkeepS * Math.min(4, misfit / MISFIT) : upkeepS;
    double least = Math.max(LEAST_MEMORY_S, LEAST_EVENTS / Math.max(1, cluster.rateHz));
    double most = Math.max(least, settings.longestMemoryUs() * 1e-6);
    cluster.memoryS = Math.min(most, Math.max(least, cluster.memoryS + step));
  }
}
