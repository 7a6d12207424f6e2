package haltere.filters.cluster;

import java.util.Arrays;

/**
 * Whether the events of a large cluster are those of several things with a gap between: in a crowd,
 * a cluster that began over several things shares them for as long as they stay within it, however
 * they move.
 *
 * <p>Some of the events of a while are counted by their distance from one of them. Where these
 * distances leave out some, the events nearer than that are at a place of their own, which is
 * followed over further whiles. The edges of one thing in front and behind have a gap between as
 * well, but then each has one polarity, and they keep their distance, also when the thing turns. So
 * the place is another thing's if it is still there a little later and then both it and all the
 * rest have both polarities, or if the distance between them changes. Thread rule: that of its
 * owner.
 */
final class GapProbe {
  /** Bins of distance; the last one is for all that is farther. */
  private static final int BINS = 33;

  private static final double BINS_PER_RADIUS = 16;

  /** A gap is at least as wide as so many bins, and pixels. */
  private static final double GAP_BINS = 2;

  private static final double GAP_PX = 4;

  /** Share of the events that may be noise in a gap. */
  private static final double NOISE = 0.02;

  /** Share of the events that are on either side of it at least. */
  private static final double PLACE = 0.08;

  /** Events of a while: as many as come in the usual time, at least and at most. */
  private static final int FEWEST_EVENTS = 80;

  private static final int MOST_EVENTS = 160;

  /** How long a while is at least and at most. */
  private static final long LEAST_US = 4_000;

  private static final long MOST_US = 60_000;

  /** About as long as a while is to be. */
  private static final double USUAL_S = 0.01;

  /** A place is followed for so long. */
  private static final long FOLLOWED_US = 150_000;

  /** Balance below which events have both polarities. */
  private static final double TWO_SIDED = 0.4;

  /** How long a place is there at least: edges of which few pixels fire at a time have gaps. */
  private static final long LASTING_US = 15_000;

  /** Share by which the distance changes where things part or near. */
  private static final double CHANGED = 0.3;

  /** By what factor its share of the events may change as long as it is the same place. */
  private static final double SAME = 4;

  /** A smaller cluster has no room for several things. */
  private static final double LEAST_RADIUS_PX = 8;

  private static final int NUMBERS = 7;

  private final double[] sums = new double[NUMBERS * BINS];
  private boolean on;
  private boolean placed;
  private double fromX;
  private double fromY;
  private double binsPerPixel;
  private double gapBins;
  private int stride;
  private int wanted;
  private int events;
  private long fromUs;

  // The place as it was first.
  private long followedFromUs;
  private double firstDistance;
  private double firstShare;

  /** The place, as of the last while. */
  final Part near = new Part();

  /** All the rest. */
  final Part far = new Part();

  private boolean following;
  private long beforeUs;

  /** Share of the events that are at the place. */
  double share;

  /** Mean and covariance of some events, their balance, and how they move. */
  static final class Part {
    double count;
    double x;
    double y;
    double xx;
    double xy;
    double yy;

    /** Share of ON events less that of OFF events, -1 to 1. */
    double balance;

    double vx;
    double vy;

    /** Takes some bins, whose sums are of offsets from a place, so long after the ones before. */
    private void of(
        double[] sums, int fromBin, int toBin, double fromX, double fromY, double seconds) {
      count = sum(sums, 0, fromBin, toBin);
      double dx = sum(sums, 1, fromBin, toBin) / count;
      double dy = sum(sums, 2, fromBin, toBin) / count;
      xx = sum(sums, 3, fromBin, toBin) / count - dx * dx;
      xy = sum(sums, 4, fromBin, toBin) / count - dx * dy;
      yy = sum(sums, 5, fromBin, toBin) / count - dy * dy;
      balance = sum(sums, 6, fromBin, toBin) / count;
      vx = (fromX + dx - x) / seconds;
      vy = (fromY + dy - y) / seconds;
      x = fromX + dx;
      y = fromY + dy;
    }

    private boolean isTwoSided() {
      return Math.abs(balance) < TWO_SIDED;
    }

    private static double sum(double[] sums, int number, int fromBin, int toBin) {
      double sum = 0;
      for (int bin = fromBin; bin < toBin; bin++) {
        sum += sums[NUMBERS * bin + number];
      }
      return sum;
    }
  }

  void end() {
    on = false;
    following = false;
  }

  private void begin(Cluster cluster, long timeUs) {
    on = true;
    placed = following;
    events = 0;
    fromUs = timeUs;
    Arrays.fill(sums, 0);
    if (!following) {
      binsPerPixel = BINS_PER_RADIUS / cluster.radius;
      gapBins = Math.max(GAP_BINS, GAP_PX * binsPerPixel);
      double usual = cluster.rateHz * USUAL_S;
      wanted = (int) Math.max(FEWEST_EVENTS, Math.min(MOST_EVENTS, usual));
      stride = (int) Math.max(1, usual / wanted);
    }
  }

  /** Takes an event, and says how many later the next one is to be taken. */
  int take(double x, double y, int sign) {
    if (!on) {
      return Integer.MAX_VALUE;
    }
    if (!placed) {
      placed = true;
      fromX = x;
      fromY = y;
    }
    double dx = x - fromX;
    double dy = y - fromY;
    int bin = (int) Math.min(BINS - 1, binsPerPixel * Math.sqrt(dx * dx + dy * dy));
    int at = NUMBERS * bin;
    sums[at]++;
    sums[at + 1] += dx;
    sums[at + 2] += dy;
    sums[at + 3] += dx * dx;
    sums[at + 4] += dx * dy;
    sums[at + 5] += dy * dy;
    sums[at + 6] += sign;
    events++;
    return stride;
  }

  /** Looks at a cluster at an upkeep, and says whether a place in it is another thing's. */
  boolean findsAnother(Cluster cluster, long timeUs) {
    if (timeUs - cluster.bornUs < ClusterForm.SETTLED_US || cluster.radius < LEAST_RADIUS_PX) {
      end();
      return false;
    }
    if (!on) {
      begin(cluster, timeUs);
      cluster.sampleSoon();
      return false;
    }
    long lastedUs = timeUs - fromUs;
    if (events < wanted || lastedUs < LEAST_US) {
      if (lastedUs > MOST_US) {
        following = false;
        begin(cluster, timeUs);
      }
      return false;
    }
    boolean found = compare(timeUs);
    begin(cluster, timeUs);
    return found;
  }

  private boolean compare(long timeUs) {
    int bin = gap();
    if (bin == 0) {
      following = false;
      return false;
    }
    long middleUs = (fromUs + timeUs) / 2;
    double seconds = (middleUs - beforeUs) * 1e-6;
    near.of(sums, 0, bin, fromX, fromY, seconds);
    far.of(sums, bin, BINS, fromX, fromY, seconds);
    share = near.count / events;
    double distance = Math.hypot(near.x - far.x, near.y - far.y);
    boolean another = false;
    if (!following) {
      following = true;
      followedFromUs = timeUs;
      firstDistance = distance;
      firstShare = share;
    } else {
      boolean same = share < SAME * firstShare && firstShare < SAME * share;
      boolean lasts = timeUs - followedFromUs >= LASTING_US;
      boolean areTwo = lasts && near.isTwoSided() && far.isTwoSided();
      double changed = Math.abs(distance - firstDistance);
      another = same && (areTwo || changed > CHANGED * Math.max(distance, firstDistance));
      following = same && !another && timeUs - followedFromUs < FOLLOWED_US;
    }
    beforeUs = middleUs;
    fromX = near.x;
    fromY = near.y;
    return another;
  }

  /** The first bin of the first gap that has enough events on both sides, or 0. */
  private int gap() {
    double least = PLACE * events;
    double noise = NOISE * events;
    double before = 0;
    double within = 0;
    int from = 0;
    for (int bin = 0; bin < BINS && events - before - within >= least; bin++) {
      double here = sums[NUMBERS * bin];
      if (within + here > noise) {
        before += within + here;
        within = 0;
        from = bin + 1;
        continue;
      }
      within += here;
      if (before >= least && bin + 1 - from >= gapBins && events - before - within >= least) {
        return from;
      }
    }
    return 0;
  }
}
