package haltere.filters.wing.internal.stroke;

/**
 * Process noise of the frequency, larger in a manoeuvre ({@link ManoeuvreDetector}), and its
 * variance. That of the filter is too large in steady flight ({@link FrequencyHindsight}) and too
 * small just before a manoeuvre is detected ({@link FrequencyChange}, and the changes at recent
 * detections).
 */
final class FrequencyNoise {
  private static final double STEADY_SHARE = 0.02;

  /** Factor for the part of the error that hindsight shares with the filter. */
  private static final double HINDSIGHT_FACTOR = 1.05;

  /** True share of the variance that the filter gains in a manoeuvre. */
  private static final double MANOEUVRE_SHARE = 0.27;

  /** Share of the excess change that is added to the variance. */
  private static final double CHANGE_SHARE = 0.75;

  /** Samples, about 1 ms apart, until a manoeuvre is detected. */
  private static final int DETECTION_SAMPLES = 12;

  private static final double DETECTION_MEMORY_S = 1.5;

  /** Share of the mean squared change at detections that is added to the variance. */
  private static final double DETECTION_SHARE = 0.028;

  private final ManoeuvreDetector detector = new ManoeuvreDetector();
  private final FrequencyHistory history = new FrequencyHistory();
  private final FrequencyChange changes = new FrequencyChange();
  private final FrequencyHindsight hindsight = new FrequencyHindsight();
  private FrequencyNoise other;

  /** Variance of the angular frequency in steady flight, in the filter. */
  private double steadyVariance = Double.MAX_VALUE;

  /** Mean squared change at detections, over the last seconds. */
  private double detectedChange;

  private double sinceS;

  /** Sets the other wing of the fly, or null. */
  void besides(FrequencyNoise wing) {
    other = wing;
  }

  /** Adds a residual, its weight times the slope, and the slope. */
  void add(double residual, double weight, double slope) {
    detector.add(residual, weight, slope);
  }

  /** Update, about once a millisecond, with the largest added density. */
  void update(double dtS, StrokeEkf filter, double maxDensity) {
    double omega = filter.x[StrokeEkf.OMEGA];
    detector.update(dtS, omega, maxDensity, other == null ? null : other.detector);
    boolean steady = isSteady();
    history.add(dtS, filter);
    // manoeuvres come in series
    double change = steady ? 0 : history.change(DETECTION_SAMPLES);
    sinceS = Math.min(DETECTION_MEMORY_S, sinceS + dtS);
    detectedChange += dtS / sinceS * (change * change - detectedChange);
    hindsight.update(dtS, history, steady);
    double p = filter.belief.covariance(StrokeEkf.OMEGA, StrokeEkf.OMEGA);
    boolean isSteadyFly = steady && (other == null || other.isSteady());
    changes.update(history, isSteadyFly, other == null ? null : other.changes);
    if (p < steadyVariance) {
      steadyVariance = p;
    } else if (steady) {
      steadyVariance += STEADY_SHARE * (p - steadyVariance);
    }
  }

  /** Added density of the process noise of the angular frequency. */
  double added() {
    return detector.density();
  }

  private boolean isSteady() {
    return detector.density() == 0;
  }

  /** Variance of the angular frequency, from that of the filter. */
  double variance(double p) {
    double manoeuvre = isSteady() ? 0 : Math.max(0, p - steadyVariance);
    double share = HINDSIGHT_FACTOR * hindsight.share(other == null ? null : other.hindsight);
    return share * (p - manoeuvre)
        + MANOEUVRE_SHARE * manoeuvre
        + DETECTION_SHARE * detectedChange
        + CHANGE_SHARE * changes.excess;
  }
}
