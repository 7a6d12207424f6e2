package haltere.filters.wing.stroke;

/**
 * The noise of a wing's frequency: how much process noise the filter gets, more in a manoeuvre
 * ({@link RunAway}), and how sure the frequency really is, which the filter, ready for manoeuvres,
 * puts too low in steady flight ({@link FrequencyHindsight}) and too high just before a manoeuvre
 * is noticed ({@link FrequencyChange}, {@link FrequencySurprise}).
 *
 * <p>Thread rule: one thread at a time.
 */
final class FrequencyNoise {
  private static final double CALM_SHARE = 0.02;

  /** What hindsight is off by as the filter is cannot be seen in what both differ by. */
  private static final double UNSEEN = 1.05;

  /** What is right of the variance that the filter gains in a manoeuvre: it is ready for more. */
  private static final double MANOEUVRE_SHARE = 0.27;

  /** What is added for each square of what the frequency has changed by more than usual. */
  private static final double CHANGE_SHARE = 0.75;

  private final RunAway runAway = new RunAway();
  private final FrequencySurprise surprise = new FrequencySurprise();
  private final FrequencyChange change = new FrequencyChange();
  private final FrequencyHindsight hindsight = new FrequencyHindsight();
  private FrequencyNoise other;

  /** Variance of the angular frequency in steady flight, as the filter thinks. */
  private double calmVariance;

  void launch() {
    runAway.launch();
    surprise.launch();
    change.launch();
    hindsight.launch();
    calmVariance = Double.MAX_VALUE;
  }

  /** Says whose wing is driven together with this one; null if there is none. */
  void besides(FrequencyNoise wing) {
    other = wing;
    runAway.besides(wing == null ? null : wing.runAway);
    change.besides(wing == null ? null : wing.change);
  }

  /** Takes a residual, its weight times the slope, and the slope. */
  void add(double residual, double weight, double slope) {
    runAway.add(residual, weight, slope);
  }

  /**
   * Looks, about once in a millisecond.
   *
   * @param dtS since the last time
   * @param filter of the wing
   * @param most that is added to the density of the noise
   */
  void look(double dtS, StrokeEkf filter, double most) {
    double omega = filter.x[StrokeEkf.OMEGA];
    runAway.look(dtS, omega, most);
    boolean calm = isCalm();
    surprise.look(dtS, omega, filter.x[StrokeEkf.RATE], calm);
    hindsight.look(dtS, filter, calm);
    double p = filter.belief.covariance(StrokeEkf.OMEGA, StrokeEkf.OMEGA);
    change.look(dtS, filter, calm && (other == null || other.isCalm()));
    if (p < calmVariance) {
      calmVariance = p;
    } else if (calm) {
      calmVariance += CALM_SHARE * (p - calmVariance);
    }
  }

  /** What is to be added to the density of the angular frequency's noise. */
  double added() {
    return runAway.density();
  }

  /** Whether the fly flies steadily. */
  private boolean isCalm() {
    return runAway.density() == 0;
  }

  /** Variance of the angular frequency, from what the filter thinks it is. */
  double variance(double p) {
    double manoeuvre = isCalm() ? 0 : Math.max(0, p - calmVariance);
    double share = UNSEEN * hindsight.share(other == null ? null : other.hindsight);
    return share * (p - manoeuvre)
        + MANOEUVRE_SHARE * manoeuvre
        + surprise.variance()
        + CHANGE_SHARE * change.excess();
  }
}
