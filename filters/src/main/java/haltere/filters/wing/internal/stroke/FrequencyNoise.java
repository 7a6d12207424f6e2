package haltere.filters.wing.internal.stroke;

/**
 * The noise of a wing's frequency: how much process noise the filter gets, more in a manoeuvre
 * ({@link RunAway}), and how sure the frequency really is, which the filter, ready for manoeuvres,
 * puts too low in steady flight ({@link FrequencyHindsight}) and too high just before a manoeuvre
 * is noticed ({@link FrequencyChange}, and how far it was off when manoeuvres were noticed of
 * late).
 */
final class FrequencyNoise {
  private static final double CALM_SHARE = 0.02;

  /** What hindsight is off by as the filter is cannot be seen in what both differ by. */
  private static final double UNSEEN = 1.05;

  /** What is right of the variance that the filter gains in a manoeuvre: it is ready for more. */
  private static final double MANOEUVRE_SHARE = 0.27;

  /** What is added for each square of what the frequency has changed by more than usual. */
  private static final double CHANGE_SHARE = 0.75;

  /** Looks, of about a millisecond, that it takes to notice a manoeuvre. */
  private static final int SURPRISE_LOOKS = 12;

  private static final double SURPRISE_S = 1.5;

  /** What is added for the mean square of the changes that manoeuvres are noticed by. */
  private static final double SURPRISE_SHARE = 0.028;

  private final RunAway runAway = new RunAway();
  private final FrequencyHistory history = new FrequencyHistory();
  private final FrequencyChange changes = new FrequencyChange();
  private final FrequencyHindsight hindsight = new FrequencyHindsight();
  private FrequencyNoise other;

  /** Variance of the angular frequency in steady flight, as the filter thinks. */
  private double calmVariance = Double.MAX_VALUE;

  /** Mean square of the changes that were surprises, over the last seconds. */
  private double surprise;

  private double sinceS;

  /** Says whose wing is driven together with this one; null if there is none. */
  void besides(FrequencyNoise wing) {
    other = wing;
  }

  /** Takes a residual, its weight times the slope, and the slope. */
  void add(double residual, double weight, double slope) {
    runAway.add(residual, weight, slope);
  }

  /**
   * Looks, about once in a millisecond, and adds no more than the most to the density of the noise.
   */
  void look(double dtS, StrokeEkf filter, double most) {
    double omega = filter.x[StrokeEkf.OMEGA];
    runAway.look(dtS, omega, most, other == null ? null : other.runAway);
    boolean calm = isCalm();
    history.add(dtS, filter);
    // a fly that has surprised does so again
    double change = calm ? 0 : history.change(SURPRISE_LOOKS);
    sinceS = Math.min(SURPRISE_S, sinceS + dtS);
    surprise += dtS / sinceS * (change * change - surprise);
    hindsight.look(dtS, history, calm);
    double p = filter.belief.covariance(StrokeEkf.OMEGA, StrokeEkf.OMEGA);
    boolean isCalmFly = calm && (other == null || other.isCalm());
    changes.look(history, isCalmFly, other == null ? null : other.changes);
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
        + SURPRISE_SHARE * surprise
        + CHANGE_SHARE * changes.excess;
  }
}
