package haltere.filters.wing.internal.stroke;

/**
 * Residuals of the events of a wing in mid stroke over the distance from the hinge, in rings of
 * equal area. Tells whether the distance between the edges is that of a chord or that of a lag: the
 * angle of a chord falls towards the tip (Ellington 1984, part II, section 3), a lag is the same at
 * all distances.
 *
 * <p>The mean residual of a ring is a time: the regression of its residuals on the wing's speed.
 */
final class RadialResiduals {
  private static final int RINGS = 8;
  private static final double MEMORY_S = 0.25;

  /**
   * Variation over the radius, as a share of the distance, at which chord and lag are as likely.
   */
  private static final double AMBIGUOUS_VARIATION = 0.1;

  /** 95 % quantile of chi-square over its degrees of freedom, 7: more than noise explains. */
  private static final double SIGNIFICANT = 2.01;

  private static final double FREEDOM = RINGS - 1;

  private final double[][] moment = new double[2][RINGS];
  private final double[][] weight = new double[2][RINGS];
  private final double ringsPerSquarePx;
  private double wideTime = 0.5;

  /**
   * Degree, 0 to 1, to which the distance of the edges varies over the radius as a chord's does.
   */
  double chordShare;

  /**
   * Degree, 0 to 1, to which passages are answered at both edges beyond what chance pairs; slow
   * pixels and blind ones miss an edge.
   */
  double answeredShare;

  /**
   * Share of the time, 0 to 1, in which radius or times tell of a wide wing; even odds at first.
   */
  double wideShare = 0.5;

  /** Share of the time, 0 to 1, in which radius and times do not tell that the wing is narrow. */
  double notNarrowShare = 1;

  /** Variance over the radius of the middle between the edges in mid stroke, squared seconds. */
  double bendVariance;

  /** Of a wing whose region of interest ends at a distance from the hinge, squared pixels. */
  RadialResiduals(double outerSquarePx) {
    ringsPerSquarePx = RINGS / outerSquarePx;
  }

  /**
   * Adds a residual.
   *
   * @param edge 0 leading, 1 trailing
   * @param squarePx square of the distance from the hinge, squared pixels
   * @param y residual, radians
   * @param speed of the wing, radians a second
   */
  void add(int edge, double squarePx, double y, double speed) {
    int ring = Math.min(RINGS - 1, (int) (squarePx * ringsPerSquarePx));
    moment[edge][ring] += y * speed;
    weight[edge][ring] += speed * speed;
  }

  /**
   * Compares the rings, about once in a millisecond.
   *
   * @param dtS since the last time
   * @param apartS half of the mean time between the edges in mid stroke, seconds
   * @param variances of the angle of an event of each edge, squared radians, inflated where errors
   *     repeat
   * @param isSpread whether the times of events tell of a wide wing
   */
  void look(double dtS, double apartS, double[] variances, boolean isSpread) {
    double[] sum = new double[2];
    RingMoments apart = new RingMoments();
    RingMoments middle = new RingMoments();
    for (int ring = 0; ring < RINGS; ring++) {
      double leading = weight[0][ring];
      double trailing = weight[1][ring];
      sum[0] += leading;
      sum[1] += trailing;
      if (leading > 0 && trailing > 0) {
        double first = moment[0][ring] / leading / 2;
        double second = moment[1][ring] / trailing / 2;
        double noise = (variances[0] / leading + variances[1] / trailing) / 4;
        double w = leading * trailing / (leading + trailing);
        apart.add(w, first - second, noise);
        middle.add(w, first + second, noise);
      }
    }
    double variation = apart.variance();
    double ambiguous = AMBIGUOUS_VARIATION * apartS;
    chordShare = variation == 0 ? 0 : variation / (variation + ambiguous * ambiguous);
    bendVariance = middle.variance();
    double most = Math.max(sum[0], sum[1]);
    answeredShare = most == 0 ? 0 : Math.max(0, 2 * Math.min(sum[0], sum[1]) / most - 1);
    double kept = Math.exp(-dtS / MEMORY_S);
    double seen = isSpread || variation > 0 ? 1 : apart.probability(ambiguous * ambiguous);
    wideTime += (1 - kept) * (seen - wideTime);
    wideShare = Math.max(0, 2 * wideTime - 1);
    notNarrowShare = Math.min(1, 2 * wideTime);
    for (int ring = 0; ring < RINGS; ring++) {
      for (int edge = 0; edge < 2; edge++) {
        moment[edge][ring] *= kept;
        weight[edge][ring] *= kept;
      }
    }
  }

  /** Weighted variance of the rings without their noise. */
  private static final class RingMoments {
    private double all;
    private double first;
    private double second;
    private double noise;

    void add(double w, double value, double variance) {
      all += w;
      first += w * value;
      second += w * value * value;
      noise += w * variance;
    }

    double variance() {
      return all == 0 ? 0 : Math.max(0, (second - first * first / all - SIGNIFICANT * noise) / all);
    }

    /** Probability that the rings vary by that much more than noise; even odds before. */
    double probability(double variance) {
      if (all == 0) {
        return 0.5;
      }
      double ratio = variance * all / noise;
      double measured = (second - first * first / all) / noise;
      return 1 / (1 + Math.exp(FREEDOM / 2 * (Math.log1p(ratio) - measured * ratio / (1 + ratio))));
    }
  }
}
