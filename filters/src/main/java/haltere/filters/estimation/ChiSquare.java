package haltere.filters.estimation;

/**
 * The chi-square distribution: tails and quantiles, accurate to about 1e-12 in both tails, for
 * gates and for the bands of {@link Consistency}.
 */
public final class ChiSquare {
  private static final int MAX_ITERATIONS = 200;

  private ChiSquare() {}

  /**
   * Probability of a value up to x.
   *
   * @param x any
   * @param degrees degrees of freedom, more than 0
   * @return 0 to 1
   */
  public static double cumulative(double x, double degrees) {
    return IncompleteGamma.lower(shape(degrees), x / 2);
  }

  /**
   * Probability of a value above x.
   *
   * @param x any
   * @param degrees degrees of freedom, more than 0
   * @return 0 to 1, accurate where it is tiny
   */
  public static double exceedance(double x, double degrees) {
    return IncompleteGamma.upper(shape(degrees), x / 2);
  }

  /**
   * The value that is not exceeded with a probability.
   *
   * @param probability 0 (the value is 0) up to, not including, 1
   * @param degrees degrees of freedom, more than 0
   * @return at least 0
   */
  public static double quantile(double probability, double degrees) {
    if (!(probability >= 0 && probability < 1)) {
      throw new IllegalArgumentException("probability must be in [0, 1): " + probability);
    }
    if (probability == 0) {
      return 0;
    }
    return 2 * inverse(shape(degrees), probability, 1 - probability, probability <= 0.5);
  }

  /**
   * The value that is exceeded with a probability: for tails too small for {@link #quantile}.
   *
   * @param probability more than 0, up to 1 (the value is 0)
   * @param degrees degrees of freedom, more than 0
   * @return at least 0
   */
  public static double quantileOfExceedance(double probability, double degrees) {
    if (!(probability > 0 && probability <= 1)) {
      throw new IllegalArgumentException("probability must be in (0, 1]: " + probability);
    }
    if (probability == 1) {
      return 0;
    }
    return 2 * inverse(shape(degrees), 1 - probability, probability, probability > 0.5);
  }

  /**
   * The middle interval that holds a value with a probability, the same tail on both sides.
   *
   * @param confidence such as 0.95, between 0 and 1
   * @param degrees degrees of freedom, more than 0
   * @return from the quantile of (1 − confidence)/2 to that of (1 + confidence)/2
   */
  public static Interval band(double confidence, double degrees) {
    if (!(confidence > 0 && confidence < 1)) {
      throw new IllegalArgumentException("confidence must be between 0 and 1: " + confidence);
    }
    double tail = (1 - confidence) / 2;
    return new Interval(quantile(tail, degrees), quantileOfExceedance(tail, degrees));
  }

  private static double shape(double degrees) {
    return Require.positive("degrees of freedom", degrees) / 2;
  }

  /**
   * Solves P(a, x) = p, or Q(a, x) = q, whichever tail is the smaller: Newton's method on the
   * tail's logarithm, kept inside a bracket.
   */
  private static double inverse(double a, double p, double q, boolean lowerTail) {
    double low = 0;
    double high = Double.POSITIVE_INFINITY;
    double x = start(a, p, q, lowerTail);
    for (int i = 0; i < MAX_ITERATIONS; i++) {
      double tail = lowerTail ? IncompleteGamma.lower(a, x) : IncompleteGamma.upper(a, x);
      double excess = Math.log(tail / (lowerTail ? p : q)) * (lowerTail ? 1 : -1);
      if (excess == 0) {
        return x;
      }
      if (excess > 0) {
        high = x;
      } else {
        low = x;
      }
      double next = x - excess * tail / IncompleteGamma.density(a, x);
      if (!(next > low && next < high)) {
        next = Double.isInfinite(high) ? 2 * x + 1 : low + (high - low) / 2;
      }
      if (Math.abs(next - x) <= 4e-16 * x || next == low || next == high) {
        return next;
      }
      x = next;
    }
    return x;
  }

  /** Wilson and Hilferty (1931) in the middle, the leading term of the series near 0. */
  private static double start(double a, double p, double q, boolean lowerTail) {
    double tail = lowerTail ? p : q;
    // Normal quantile to 4.5e-4: Abramowitz and Stegun (1964), 26.2.23.
    double t = Math.sqrt(-2 * Math.log(tail));
    double z =
        t
            - (2.515517 + t * (0.802853 + t * 0.010328))
                / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
    double cube = 1 - 1 / (9 * a) + (lowerTail ? -z : z) / (3 * Math.sqrt(a));
    double wilsonHilferty = a * cube * cube * cube;
    double leading = Math.exp((Math.log(p) + IncompleteGamma.logGamma(a + 1)) / a);
    if (cube > 0.3 && wilsonHilferty > 0) {
      return wilsonHilferty;
    }
    return Math.max(leading, Double.MIN_NORMAL);
  }
}
