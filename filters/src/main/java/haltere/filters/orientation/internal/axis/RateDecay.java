package haltere.filters.orientation.internal.axis;

/**
 * Prediction of decaying rates driven by white noise, and of their integral, an angle: closed
 * integrals (Bar-Shalom, Li and Kirubarajan 2001, section 8.2.3, exponentially correlated). With h
 * = Δt/τ and d = e^(−h) a rate is multiplied by d and adds τ (1 − d) times itself to the angle; the
 * noises are per unit of the rate's own variance. Reused.
 */
final class RateDecay {
  private final double tauS;

  /** d = e^(−h), and τ (1 − d), seconds. */
  double left = 1;

  double reachS;

  /** Variance of the angle, covariance of angle and rate, variance of the rate. */
  double angleNoise;

  double jointNoise;
  double rateNoise;

  RateDecay(double tauS) {
    this.tauS = tauS;
  }

  /** Sets a step in seconds, at least 0. */
  void step(double dtS) {
    double h = dtS / tauS;
    double decayed = -Math.expm1(-h);
    left = 1 - decayed;
    reachS = tauS * decayed;
    rateNoise = decayed * (2 - decayed);
    jointNoise = tauS * decayed * decayed;
    angleNoise = tauS * tauS * angleNoise(h, decayed);
  }

  /** 2h − 3 + 4e^(−h) − e^(−2h), by its series where the terms cancel. */
  private static double angleNoise(double h, double decayed) {
    if (h > 0.05) {
      return 2 * (h - decayed) - decayed * decayed;
    }
    return h * h * h * (2.0 / 3 + h * (-0.5 + h * (7.0 / 30 + h * (-1.0 / 12 + h * 31.0 / 1260))));
  }
}
