package haltere.filters.cluster;

import java.util.Arrays;

/**
 * Which clusters become one. Two that are near and move alike are one thing seen twice; two that
 * move differently, or were seen apart from each other before, are two things that meet. Where one
 * has only ON events and the other only OFF events, they are the edges in front and behind.
 */
final class ClusterMerging {
  /** Standard deviations by which two velocities must differ to be different. */
  private static final double SIGMAS = 3;

  /** Two that will be a radius farther apart in this time move differently. */
  private static final double FORESIGHT_S = 0.5;

  /** How many radii apart clusters are seen as two. */
  private static final double APART = 1.2;

  /** How many radii apart the edge in front and the one behind of a thing may be. */
  private static final double EDGES_APART = 2;

  /** Balance from which on a cluster has events of one polarity only. */
  private static final double ONE_SIDED = 0.8;

  private static final long GROWN_UP_US = 50_000;

  private ClusterMergingSettings settings;
  private double differentCos;
  private int slots;

  /** How long each pair has been near and alike, microseconds, by slots. */
  private int[] togetherUs = new int[0];

  private boolean[] apart = new boolean[0];

  void apply(ClusterMergingSettings newSettings, int mostClusters) {
    settings = newSettings;
    differentCos = StrictMath.cos(StrictMath.toRadians(settings.differentAngleDeg()));
    if (slots != mostClusters) {
      slots = mostClusters;
      togetherUs = new int[slots * slots];
      apart = new boolean[slots * slots];
    }
  }

  /** Forgets what was seen of a cluster. */
  void forget(Cluster cluster) {
    for (int other = 0; other < slots; other++) {
      int pair = pair(cluster.slot, other);
      togetherUs[pair] = 0;
      apart[pair] = false;
    }
  }

  void reset() {
    Arrays.fill(togetherUs, 0);
    Arrays.fill(apart, false);
  }

  private int pair(int first, int second) {
    return Math.min(first, second) * slots + Math.max(first, second);
  }

  /**
   * Looks at two clusters at an upkeep, and notes where their regions overlap.
   *
   * @return whether they are to merge now
   */
  boolean unite(Cluster first, Cluster second, int upkeepUs, long timeUs) {
    double dx = second.x - first.x;
    double dy = second.y - first.y;
    boolean edges = areTwoEdges(first, second);
    double far = edges ? EDGES_APART : 1;
    if (Math.abs(dx) > far * (first.extentX + second.extentX)
        || Math.abs(dy) > far * (first.extentY + second.extentY)) {
      note(first, second, timeUs);
      return false;
    }
    double distance = Math.sqrt(dx * dx + dy * dy);
    double reach = distance < 1e-9 ? 1 : first.reach(dx, dy) + second.reach(dx, dy);
    if (distance <= APART * reach) {
      first.overlapped = true;
      second.overlapped = true;
    } else if (!edges) {
      note(first, second, timeUs);
      return false;
    }
    if (!settings.allowed() || !first.mayMerge || !second.mayMerge) {
      return false;
    }
    int pair = pair(first.slot, second.slot);
    double near = edges ? EDGES_APART : settings.overlap();
    if (distance > near * reach || moveDifferently(first, second, reach)) {
      togetherUs[pair] = 0;
      return false;
    }
    togetherUs[pair] = Math.min(1 << 30, togetherUs[pair] + upkeepUs);
    return togetherUs[pair]
        >= (apart[pair] && !edges ? settings.seenApartUs() : settings.seenTogetherUs());
  }

  private void note(Cluster first, Cluster second, long timeUs) {
    int pair = pair(first.slot, second.slot);
    togetherUs[pair] = 0;
    if (!apart[pair]
        && first.isVisible()
        && second.isVisible()
        && timeUs - Math.max(first.bornUs, second.bornUs) > GROWN_UP_US) {
      apart[pair] = true;
    }
  }

  /** Whether one has ON events only and the other OFF events: the two edges of one thing. */
  private static boolean areTwoEdges(Cluster first, Cluster second) {
    return first.balance * second.balance < 0
        && Math.min(Math.abs(first.balance), Math.abs(second.balance)) > ONE_SIDED;
  }

  private boolean moveDifferently(Cluster first, Cluster second, double reach) {
    double dvx = first.vx - second.vx;
    double dvy = first.vy - second.vy;
    double difference = dvx * dvx + dvy * dvy;
    double noise = SIGMAS * SIGMAS * (first.velocityVariance + second.velocityVariance);
    if (difference <= noise) {
      return false;
    }
    if (difference * FORESIGHT_S * FORESIGHT_S > reach * reach) {
      return true;
    }
    double product = first.vx * second.vx + first.vy * second.vy;
    double lengths =
        (first.vx * first.vx + first.vy * first.vy)
            * (second.vx * second.vx + second.vy * second.vy);
    return product < differentCos * Math.sqrt(lengths);
  }

  /** Whether the first of two clusters keeps its identity: a visible one, else the heavier one. */
  static boolean isStronger(Cluster first, Cluster second) {
    if (first.isVisible() != second.isVisible()) {
      return first.isVisible();
    }
    return first.mass >= second.mass;
  }

  /** Puts what another cluster has into the one that stays. */
  void absorb(Cluster kept, Cluster lost) {
    double share = lost.mass / Math.max(1e-9, kept.mass + lost.mass);
    double dx = lost.x - kept.x;
    double dy = lost.y - kept.y;
    kept.x += share * dx;
    kept.y += share * dy;
    kept.vx += share * (lost.vx - kept.vx);
    kept.vy += share * (lost.vy - kept.vy);
    kept.driftX = 0;
    kept.driftY = 0;
    if (settings.joinSize()) {
      double between = share * (1 - share);
      kept.cxx += share * (lost.cxx - kept.cxx) + between * dx * dx;
      kept.cxy += share * (lost.cxy - kept.cxy) + between * dx * dy;
      kept.cyy += share * (lost.cyy - kept.cyy) + between * dy * dy;
    }
    // Not the sum: noise spread over two circles would look like a thing within one.
    kept.mass = Math.max(kept.mass, lost.mass);
    kept.rateHz = Math.max(kept.rateHz, lost.rateHz);
    kept.events += lost.events;
    kept.lastUs = Math.max(kept.lastUs, lost.lastUs);
    kept.supportedUs = Math.max(kept.supportedUs, lost.supportedUs);
  }
}
