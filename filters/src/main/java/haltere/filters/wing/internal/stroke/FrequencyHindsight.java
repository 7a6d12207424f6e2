package haltere.filters.wing.internal.stroke;

/**
 * Estimates the true variance of the frequency in steady flight, where the covariance of the
 * filter, tuned for manoeuvres, is too large. The slope of the phases some beats before and after a
 * time is its frequency without lag; the mean squared difference to the filtered frequency is the
 * variance.
 */
final class FrequencyHindsight {
  /** Samples, about 1 ms apart, before and after the evaluated one. */
  private static final int HALF = FrequencyHistory.SAMPLES / 2;

  private static final int SAMPLES = FrequencyHistory.SAMPLES;

  /** Gap that invalidates an interval, seconds. */
  private static final double GAP_S = 0.02;

  /** Initial variance, as a share of that of the filter. */
  private static final double FIRST_SHARE = 0.2;

  private static final double FIRST_WEIGHT = 30;
  private static final double MAX_WEIGHT = 120;

  /** Samples since the last invalid one. */
  private int steady;

  private double share = FIRST_SHARE;
  private double weight = FIRST_WEIGHT;

  /** Update, about once a millisecond. */
  void update(double dtS, FrequencyHistory history, boolean steadyFlight) {
    steady = !steadyFlight ? 0 : dtS > GAP_S ? 1 : steady + 1;
    if (steady >= SAMPLES) {
      compare(history);
    }
  }

  /** Compares the frequency in the middle with the slope of a line through all phases. */
  private void compare(FrequencyHistory history) {
    double[] timeS = history.timeS;
    double[] phase = history.phase;
    int middle = history.ago(HALF);
    double meanTime = 0;
    double meanPhase = 0;
    for (int i = 0; i < SAMPLES; i++) {
      meanTime += (timeS[i] - timeS[middle]) / SAMPLES;
      meanPhase += (phase[i] - phase[middle]) / SAMPLES;
    }
    double squares = 0;
    double products = 0;
    for (int i = 0; i < SAMPLES; i++) {
      double t = timeS[i] - timeS[middle] - meanTime;
      squares += t * t;
      products += t * (phase[i] - phase[middle] - meanPhase);
    }
    double off = history.omega[middle] - products / squares;
    weight = Math.min(MAX_WEIGHT, weight + 1);
    share += (off * off / history.variance[middle] - share) / weight;
  }

  /** Variance in steady flight as a share of that of the filter, from both wings or this one. */
  double share(FrequencyHindsight other) {
    return other == null
        ? share
        : (weight * share + other.weight * other.share) / (weight + other.weight);
  }
}
