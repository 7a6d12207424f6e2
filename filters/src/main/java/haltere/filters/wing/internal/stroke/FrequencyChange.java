package haltere.filters.wing.internal.stroke;

/**
 * Excess of the change of the frequency within some milliseconds over its baseline. If the
 * frequency changes faster than the filter follows, its error is about this change. This is visible
 * before the phase diverges ({@link ManoeuvreDetector}). The mean change of both wings counts.
 */
final class FrequencyChange {
  /** Samples, about 1 ms apart, over which a change counts. */
  private static final int SAMPLES = 6;

  /** Multiple of the mean square up to which a square is usual. */
  private static final double BASELINE_FACTOR = 2;

  /** Initial mean square, as a share of the variance of the filter. */
  private static final double FIRST_SHARE = 0.2;

  private static final double FIRST_WEIGHT = 30;
  private static final double MAX_WEIGHT = 400;

  private double change;
  private double baseline;
  private double weight;

  /** Excess of the squared change over the usual one, squared radians a squared second. */
  double excess;

  /**
   * Update about once a millisecond; in steady flight the change counts as usual. Other: or null.
   */
  void update(FrequencyHistory history, boolean steady, FrequencyChange other) {
    if (weight == 0) {
      baseline = FIRST_SHARE * history.variance[history.ago(0)];
      weight = FIRST_WEIGHT;
    }
    change = history.change(SAMPLES);
    double mean = other == null ? change : (change + other.change) / 2;
    double threshold = BASELINE_FACTOR * baseline;
    excess = Math.max(0, mean * mean - threshold);
    if (steady && change != 0) {
      weight = Math.min(MAX_WEIGHT, weight + 1);
      baseline += (Math.min(mean * mean, threshold) - baseline) / weight;
    }
  }
}
