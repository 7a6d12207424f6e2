package haltere.filters.estimation;

import org.apache.commons.statistics.distribution.ChiSquaredDistribution;

/**
 * A gate for innovations: accepts those whose normalised square yᵀ S⁻¹ y is at most a threshold.
 *
 * <p>For a scalar that is y² ≤ g² S. For a vector the threshold is the chi-square quantile of the
 * same probability for its dimension (Bar-Shalom, Li and Kirubarajan 2001, section 3.7.2), so that
 * a gate of 3 sigma accepts the same share of inliers in any dimension.
 */
public final class Gate {
  /** An open gate. */
  public static final Gate OPEN = new Gate(0);

  private static final int CACHED_DIMENSIONS = 8;

  private final double rejected;
  private final double[] thresholds = new double[CACHED_DIMENSIONS + 1];

  private Gate(double rejected) {
    this.rejected = rejected;
    for (int m = 1; m <= CACHED_DIMENSIONS; m++) {
      thresholds[m] = computed(m);
    }
  }

  /**
   * A gate of g standard deviations.
   *
   * @param g more than 0, at most 30; a scalar passes if y² ≤ g² S
   * @return the gate
   */
  public static Gate sigmas(double g) {
    if (!(g > 0 && g <= 30)) {
      throw new IllegalArgumentException("a gate must have more than 0 and up to 30 sigma: " + g);
    }
    Gate gate = new Gate(ChiSquaredDistribution.of(1).survivalProbability(g * g));
    gate.thresholds[1] = g * g;
    return gate;
  }

  /**
   * A gate that a good measurement passes with a probability.
   *
   * @param probability such as 0.99, between 0 and 1
   * @return the gate
   */
  public static Gate probability(double probability) {
    if (!(probability > 0 && probability < 1)) {
      throw new IllegalArgumentException("probability must be between 0 and 1: " + probability);
    }
    return new Gate(1 - probability);
  }

  /**
   * The largest normalised innovation squared that passes.
   *
   * @param dimension of the measurement, at least 1
   * @return infinite for {@link #OPEN}
   */
  public double threshold(int dimension) {
    return dimension <= CACHED_DIMENSIONS ? thresholds[dimension] : computed(dimension);
  }

  /**
   * Whether an innovation is accepted.
   *
   * @param nis normalised innovation squared
   * @param dimension of the measurement, at least 1
   * @return false beyond the threshold, and for NaN
   */
  public boolean passes(double nis, int dimension) {
    return nis <= threshold(dimension);
  }

  private double computed(int dimension) {
    return rejected == 0
        ? Double.POSITIVE_INFINITY
        : ChiSquaredDistribution.of(dimension).inverseSurvivalProbability(rejected);
  }
}
