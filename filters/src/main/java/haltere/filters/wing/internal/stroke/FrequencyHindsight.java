package haltere.filters.wing.internal.stroke;

/**
 * How far off the frequency was, as seen in hindsight: the phases some beats before and after a
 * time tell the frequency at that time far better than it could be told then, and without lag. The
 * mean square of what both differ by says how sure the frequency really is: it holds what noise
 * does and what the filter lags behind the fly's own changes alike, which its covariance, made for
 * manoeuvres, does not.
 *
 * <p>Manoeuvres are left out here: in them the frequency changes too fast to be told by a line.
 */
final class FrequencyHindsight {
  /** Looks of about a millisecond before and after the one that is judged. */
  private static final int HALF = FrequencyHistory.LOOKS / 2;

  private static final int LOOKS = FrequencyHistory.LOOKS;

  /** A stretch with a gap of so much tells nothing. */
  private static final double GAP_S = 0.02;

  /** Variance, as a share of what the filter thinks, before anything was judged. */
  private static final double FIRST_SHARE = 0.2;

  private static final double FIRST_WEIGHT = 30;
  private static final double MAX_WEIGHT = 120;

  /** Looks since the last one that tells nothing. */
  private int steady;

  private double share = FIRST_SHARE;
  private double weight = FIRST_WEIGHT;

  /** Looks, about once in a millisecond. */
  void look(double dtS, FrequencyHistory history, boolean calm) {
    steady = !calm ? 0 : dtS > GAP_S ? 1 : steady + 1;
    if (steady >= LOOKS) {
      judge(history);
    }
  }

  /** Holds the frequency in the middle against the slope of the line through all phases. */
  private void judge(FrequencyHistory history) {
    double[] timeS = history.timeS;
    double[] phase = history.phase;
    int middle = history.ago(HALF);
    double meanTime = 0;
    double meanPhase = 0;
    for (int i = 0; i < LOOKS; i++) {
      meanTime += (timeS[i] - timeS[middle]) / LOOKS;
      meanPhase += (phase[i] - phase[middle]) / LOOKS;
    }
    double squares = 0;
    double products = 0;
    for (int i = 0; i < LOOKS; i++) {
      double t = timeS[i] - timeS[middle] - meanTime;
      squares += t * t;
      products += t * (phase[i] - phase[middle] - meanPhase);
    }
    double off = history.omega[middle] - products / squares;
    weight = Math.min(MAX_WEIGHT, weight + 1);
    share += (off * off / history.variance[middle] - share) / weight;
  }

  /**
   * Variance in steady flight as a share of what a filter thinks, as both wings tell it, or this
   * one alone.
   */
  double share(FrequencyHindsight other) {
    return other == null
        ? share
        : (weight * share + other.weight * other.share) / (weight + other.weight);
  }
}
