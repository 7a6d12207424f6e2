package haltere.filters.wing.internal.stroke;

/**
 * Residuals of the events of a wing in mid stroke, in rings of equal area about the hinge. They
 * show whether the distance between the edges is a chord, whose angle decreases towards the tip
 * (Ellington 1984, part II, section 3), or a lag, which is constant. The mean residual of a ring is
 * a time: the regression of its residuals on the speed of the wing.
 */
final class RadialResiduals {
  private static final int RINGS = 8;
  private static final double MEMORY_S = 0.25;

  /** Variation over the radius, as a share of the distance, with equal odds of chord and lag. */
  private static final double AMBIGUOUS_VARIATION = 0.1;

  /** 95 % quantile of χ² over its 7 degrees of freedom. */
  private static final double SIGNIFICANT = 2.01;

  private static final double FREEDOM = RINGS - 1;

  private final double[][] moment = new double[2][RINGS];
  private final double[][] weight = new double[2][RINGS];
  private final double ringsPerSquarePx;
  private double wideTime = 0.5;

  /** Degree, 0 to 1, to which the distance of the edges varies over the radius like a chord. */
  double chordShare;

  /** Degree, 0 to 1, to which passages have events of both edges; slow pixels miss an edge. */
  double answeredShare;

  /** Share of the time, 0 to 1, in which radius or times show a wide wing; 0.5 at first. */
  double wideShare = 0.5;

  /** Share of the time, 0 to 1, in which radius and times do not show a narrow wing. */
  double notNarrowShare = 1;

  /** Variance over the radius of the middle between the edges, squared seconds. */
  double bendVariance;

  /** Residuals up to a distance from the hinge, squared pixels. */
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
   * Compares the rings, about once a millisecond.
   *
   * @param dtS since the last time
   * @param apartS half of the mean time between the edges in mid stroke, seconds
   * @param variances of the angle of an event of each edge, squared radians, inflated for repeating
   *     errors
   * @param isSpread whether the times of events show a wide wing
   */
  void update(double dtS, double apartS, double[] variances, boolean isSpread) {
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
    double max = Math.max(sum[0], sum[1]);
    answeredShare = max == 0 ? 0 : Math.max(0, 2 * Math.min(sum[0], sum[1]) / max - 1);
    double decay = Math.exp(-dtS / MEMORY_S);
    double seen = isSpread || variation > 0 ? 1 : apart.probability(ambiguous * ambiguous);
    wideTime += (1 - decay) * (seen - wideTime);
    wideShare = Math.max(0, 2 * wideTime - 1);
    notNarrowShare = Math.min(1, 2 * wideTime);
    for (int ring = 0; ring < RINGS; ring++) {
      for (int edge = 0; edge < 2; edge++) {
        moment[edge][ring] *= decay;
        weight[edge][ring] *= decay;
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

    /** Probability that the rings vary by this variance beyond noise; prior 0.5. */
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
