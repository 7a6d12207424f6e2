package haltere.filters.wing.internal.stroke;

/** Usual squared innovation of a phase in steady flight, over its expectation, and its excess. */
final class InnovationBaseline {
  /** Number of events of one beat that count as one, since their errors are correlated. */
  private static final double REPEATING = 3;

  private static final double FIRST = 0.25;
  private static final double FIRST_WEIGHT = 60;
  private static final double MAX_WEIGHT = 400;

  private final double factor;
  private final double min;
  private final double max;
  private double baseline = FIRST;
  private double weight = FIRST_WEIGHT;

  /**
   * A baseline without data.
   *
   * @param factor multiple of the baseline above which a square is an excess
   * @param min smallest threshold, as a multiple of the expectation
   * @param max largest threshold, as a multiple of the expectation
   */
  InnovationBaseline(double factor, double min, double max) {
    this.factor = factor;
    this.min = min;
    this.max = max;
  }

  /**
   * Excess of a squared phase innovation over the baseline.
   *
   * @param y weighted sum of residuals
   * @param w sum of weights times slopes
   * @param calm whether the flight is steady, so that the square updates the baseline
   * @return squared radians; 0 without an excess
   */
  double excess(double y, double w, boolean calm) {
    double square = y / w * (y / w);
    double variance = REPEATING / w;
    double threshold = Math.max(min, Math.min(max, factor * baseline));
    if (calm) {
      weight = Math.min(MAX_WEIGHT, weight + 1);
      baseline += (Math.min(square / variance, threshold) - baseline) / weight;
    }
    return Math.max(0, square - threshold * variance);
  }
}
