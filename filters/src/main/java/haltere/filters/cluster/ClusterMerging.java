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

  /** Two that will be their radii farther apart in this time move differently. */
  private static final double FORESIGHT_S = 0.5;

  /** The same for two that were never seen apart: parts of one thing move differently as well. */
  private static final double ONE_FORESIGHT_S = 0.2;

  /** How much nearer two that were seen apart must be to be one after all. */
  private static final double TWO_NEAR = 0.85;

  /** How many radii apart clusters are seen as two. */
  static final double APART = 1.2;

  /** How many radii apart the edge in front and the one behind of a thing may be. */
  private static final double EDGES_APART = 2;

  /** Balance from which on a cluster has events of one polarity only. */
  private static final double ONE_SIDED = 0.8;

  /** Two that were apart for this time are two things. */
  private static final int SEEN_APART_US = 60_000;

  /** Two that parted and have stayed in one place since become one again after this time. */
  private static final int PARTED_TOGETHER_US = 200_000;

  /** Up to how much of their radii apart that is. */
  private static final double ONE_PLACE = 0.35;

  private ClusterMergingSettings settings;
  private double differentCos;
  private int slots;

  /** How long each pair has been near and alike, microseconds, by slots. */
  private int[] togetherUs = new int[0];

  /** How long each pair has been apart, both visible, microseconds, by slots. */
  private int[] apartUs = new int[0];

  /** Until when each pair is kept from merging, microseconds, by slots. */
  private long[] keptApartUntilUs = new long[0];

  /** Which pairs have parted and were not seen apart since, by slots. */
  private boolean[] onlyParted = new boolean[0];

  void apply(ClusterMergingSettings newSettings, int mostClusters) {
    settings = newSettings;
    differentCos = StrictMath.cos(StrictMath.toRadians(settings.differentAngleDeg()));
    if (slots != mostClusters) {
      slots = mostClusters;
      togetherUs = new int[slots * slots];
      apartUs = new int[slots * slots];
      onlyParted = new boolean[slots * slots];
      keptApartUntilUs = new long[slots * slots];
      Arrays.fill(keptApartUntilUs, Long.MIN_VALUE);
    }
  }

  /** Forgets what was seen of a cluster. */
  void forget(Cluster cluster) {
    for (int other = 0; other < slots; other++) {
      int pair = pair(cluster.slot, other);
      togetherUs[pair] = 0;
      apartUs[pair] = 0;
      onlyParted[pair] = false;
      keptApartUntilUs[pair] = Long.MIN_VALUE;
    }
  }

  /** Two are known to be two until a time. */
  void keepApart(Cluster first, Cluster second, long untilUs) {
    keptApartUntilUs[pair(first.slot, second.slot)] = untilUs;
  }

  /** Two that have just parted are two, unless they turn out to stay in one place. */
  void parted(Cluster first, Cluster second) {
    int pair = pair(first.slot, second.slot);
    apartUs[pair] = SEEN_APART_US;
    onlyParted[pair] = true;
  }

  void reset() {
    Arrays.fill(togetherUs, 0);
    Arrays.fill(apartUs, 0);
    Arrays.fill(onlyParted, false);
    Arrays.fill(keptApartUntilUs, Long.MIN_VALUE);
  }

  private int pair(int first, int second) {
    return Math.min(first, second) * slots + Math.max(first, second);
  }

  /** Whether two are known to be two and are so far from each other that nothing changes. */
  boolean areFarApart(Cluster first, Cluster second) {
    if (Math.abs(second.x - first.x) > EDGES_APART * (first.extentX + second.extentX)
        || Math.abs(second.y - first.y) > EDGES_APART * (first.extentY + second.extentY)) {
      int pair = pair(first.slot, second.slot);
      return apartUs[pair] >= SEEN_APART_US && togetherUs[pair] == 0;
    }
    return false;
  }

  /**
   * Looks at two clusters at an upkeep, and notes where their regions overlap.
   *
   * @return whether they are to merge now
   */
  boolean unite(Cluster first, Cluster second, long timeUs, int upkeepUs) {
    double dx = second.x - first.x;
    double dy = second.y - first.y;
    boolean edges = areTwoEdges(first, second);
    double far = edges ? EDGES_APART : 1;
    if (Math.abs(dx) > far * (first.extentX + second.extentX)
        || Math.abs(dy) > far * (first.extentY + second.extentY)) {
      note(first, second, upkeepUs);
      return false;
    }
    double distance = Math.sqrt(dx * dx + dy * dy);
    double reach = distance < 1e-9 ? 1 : first.reach(dx, dy) + second.reach(dx, dy);
    if (distance <= APART * reach) {
      first.overlapped = true;
      second.overlapped = true;
    } else if (!edges) {
      note(first, second, upkeepUs);
      return false;
    }
    int pair = pair(first.slot, second.slot);
    if (!settings.allowed() || !edges && timeUs <= keptApartUntilUs[pair]) {
      return false;
    }
    boolean two = apartUs[pair] >= SEEN_APART_US && !edges;
    double near = edges ? EDGES_APART : two ? TWO_NEAR * settings.overlap() : settings.overlap();
    if (distance > near * reach || moveDifferently(first, second, reach, two)) {
      togetherUs[pair] = 0;
      return false;
    }
    togetherUs[pair] = Math.min(1 << 30, togetherUs[pair] + upkeepUs);
    if (onlyParted[pair] && distance < ONE_PLACE * reach) {
      return togetherUs[pair] >= PARTED_TOGETHER_US;
    }
    return togetherUs[pair] >= (two ? settings.seenApartUs() : settings.seenTogetherUs());
  }

  private void note(Cluster first, Cluster second, int upkeepUs) {
    int pair = pair(first.slot, second.slot);
    togetherUs[pair] = 0;
    onlyParted[pair] = false;
    if (apartUs[pair] < SEEN_APART_US && first.isVisible() && second.isVisible()) {
      apartUs[pair] += upkeepUs;
    }
  }

  /** Whether one has ON events only and the other OFF events: the two edges of one thing. */
  private static boolean areTwoEdges(Cluster first, Cluster second) {
    return first.balance * second.balance < 0
        && Math.min(Math.abs(first.balance), Math.abs(second.balance)) > ONE_SIDED;
  }

  private boolean moveDifferently(Cluster first, Cluster second, double reach, boolean two) {
    double dvx = first.vx - second.vx;
    double dvy = first.vy - second.vy;
    double difference = dvx * dvx + dvy * dvy;
    double noise = SIGMAS * SIGMAS * (first.velocityVariance + second.velocityVariance);
    if (difference <= noise) {
      return false;
    }
    double foresightS = two ? FORESIGHT_S : ONE_FORESIGHT_S;
    if (difference * foresightS * foresightS > reach * reach) {
      return true;
    }
    double product = first.vx * second.vx + first.vy * second.vy;
    double lengths =
        (first.vx * first.vx + first.vy * first.vy)
            * (second.vx * second.vx + second.vy * second.vy);
    return two && product < differentCos * Math.sqrt(lengths);
  }

  /**
   * Whether the first of two clusters keeps its identity: a visible one, of two that had parted the
   * one whose it was, else the heavier one.
   */
  boolean isStronger(Cluster first, Cluster second) {
    if (first.isVisible() != second.isVisible()) {
      return first.isVisible();
    }
    if (onlyParted[pair(first.slot, second.slot)]) {
      return first.id < second.id;
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
