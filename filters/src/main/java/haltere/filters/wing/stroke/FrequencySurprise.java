package haltere.filters.wing.stroke;

/**
 * How far off the frequency is because a manoeuvre is not noticed at once. When one has been
 * noticed, the frequency has changed against what was expected some time before; a fly that has
 * surprised does so again, so that the mean square of such changes in the last seconds counts for
 * the time when nothing is noticed.
 *
 * <p>Thread rule: one thread at a time.
 */
final class FrequencySurprise {
  /** Looks, of about a millisecond, that it takes to notice a manoeuvre. */
  private static final int LOOKS = 12;

  private static final double MEMORY_S = 1.5;
  private static final double SHARE = 0.028;

  private final double[] expected = new double[LOOKS];
  private int next;
  private int filled;
  private double sinceS;
  private double mean;

  void launch() {
    next = 0;
    filled = 0;
    sinceS = 0;
    mean = 0;
  }

  /**
   * Looks, about once in a millisecond.
   *
   * @param dtS since the last time
   * @param omega angular frequency
   * @param rate at which it changes
   * @param calm whether no manoeuvre is noticed
   */
  void look(double dtS, double omega, double rate, boolean calm) {
    double change = filled == LOOKS && !calm ? omega - expected[next] : 0;
    expected[next] = omega + rate * LOOKS * dtS;
    next = (next + 1) % LOOKS;
    filled = Math.min(LOOKS, filled + 1);
    sinceS = Math.min(MEMORY_S, sinceS + dtS);
    mean += dtS / sinceS * (change * change - mean);
  }

  /** What it adds to the variance of the angular frequency. */
  double variance() {
    return SHARE * mean;
  }
}
