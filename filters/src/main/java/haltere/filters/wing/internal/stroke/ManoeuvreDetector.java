package haltere.filters.wing.internal.stroke;

/**
 * Detects a manoeuvre: the innovation of the phase exceeds its baseline ({@link
 * InnovationBaseline}). The process noise of the frequency then increases with the excess and
 * decays slowly, since manoeuvres last. The mean innovation of both wings is tested with a low
 * threshold, since both are driven together; that of one wing with a higher one.
 */
final class ManoeuvreDetector {
  /** Density of the frequency's noise per squared radian of excess. */
  private static final double DENSITY = 4e8;

  private static final double HOLD_S = 0.03;
  private static final double MIN_DENSITY = 1;

  private final InnovationBaseline together = new InnovationBaseline(20, 1.5, 6);
  private final InnovationBaseline alone = new InnovationBaseline(26, 6, 12);
  private double y;
  private double w;
  private double density;

  /**
   * Adds a residual.
   *
   * @param residual radians
   * @param weight one over its variance, times the slope
   * @param slope derivative of the angle with respect to the phase
   */
  void add(double residual, double weight, double slope) {
    y += weight * residual;
    w += weight * slope;
  }

  /**
   * Update, about once a millisecond, from the residuals of the last beat. The other wing may be
   * null.
   */
  void update(double dtS, double omega, double maxDensity, ManoeuvreDetector other) {
    if (w > 0) {
      double excess = excess(other);
      density = Math.max(density * Math.exp(-dtS / HOLD_S), Math.min(maxDensity, DENSITY * excess));
      if (density < MIN_DENSITY) {
        density = 0;
      }
    }
    double fade = Math.exp(-dtS * omega / (2 * Math.PI));
    y *= fade;
    w *= fade;
  }

  private double excess(ManoeuvreDetector other) {
    boolean calm = density == 0;
    if (other == null) {
      return together.excess(y, w, calm);
    }
    return Math.max(
        alone.excess(y, w, calm),
        together.excess(y + other.y, w + other.w, calm && other.density == 0));
  }

  /** Added density of the process noise of the angular frequency; 0 in steady flight. */
  double density() {
    return density;
  }
}
