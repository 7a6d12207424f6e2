package haltere.filters.wing.internal.stroke;

/**
 * Time from the passage of an edge to the time stamp of its OFF event: a constant delay, which is
 * not observable, and the delay of the photoreceptor, which the lag of ON behind OFF events shows.
 * Without a lag, the pixel is assumed to be ideal. A fast wing delays ON events as well, since it
 * leaves the pixel before its next event.
 */
final class CameraLatency {
  /** Width of a wing in mid stroke as seen from its hinge, radians. */
  private static final double WING_RAD = 0.05;

  /** Delay of a slow pixel as a share of the time for which the wing covers it. */
  private static final double SLOW_SHARE = 0.35;

  /** Lag of ON events above which a pixel is slow. */
  private static final double SLOW_LAG_S = 18e-6;

  /**
   * Lag of ON events due to the refractory time of a pixel, times the time for which the wing
   * covers it; from simulated flies.
   */
  private static final double BLIND_S2 = 320e-12;

  /** Standard deviation of the delay and of the shape of the stroke; from simulated flies. */
  private static final double LEFT_S = 6e-6;

  /** Standard deviation of a lag that is held with events of one edge only, as a share of it. */
  private static final double HELD_SHARE = 0.1;

  /**
   * Mismatch of the thresholds of pixels as a share of the threshold: 2.1 % of contrast at a
   * threshold of 15 % (Lichtsteiner, Posch and Delbruck 2008).
   */
  private static final double THRESHOLD_MISMATCH = 0.14;

  private CameraLatency() {}

  /** Time for which the wing covers a pixel at its root mean square speed. */
  private static double overPixelS(double fullSpeed) {
    return WING_RAD * Math.sqrt(2) / Math.max(1, fullSpeed);
  }

  /**
   * Lag of ON behind OFF events, seconds: the mean of both wings weighted by their variances, since
   * both have the same pixels. The own lag if it is held, without variance, or other is null.
   */
  static double lagS(StrokeEkf own, StrokeEkf other) {
    double lag = own.x[StrokeEkf.LAG];
    double variance = own.belief.covariance(StrokeEkf.LAG, StrokeEkf.LAG);
    if (other == null || variance == 0) {
      return lag;
    }
    double otherVariance = other.belief.covariance(StrokeEkf.LAG, StrokeEkf.LAG);
    return lag + variance / (variance + otherVariance) * (other.x[StrokeEkf.LAG] - lag);
  }

  /**
   * Variance of {@link #lagS}, squared seconds. It increases if the wings differ by more than their
   * variances explain (Birge 1932, equation 4).
   */
  static double lagVariance(StrokeEkf own, StrokeEkf other) {
    double variance = own.belief.covariance(StrokeEkf.LAG, StrokeEkf.LAG);
    if (other == null) {
      return variance;
    }
    double otherVariance = other.belief.covariance(StrokeEkf.LAG, StrokeEkf.LAG);
    double both = variance + otherVariance;
    double apart = own.x[StrokeEkf.LAG] - other.x[StrokeEkf.LAG];
    return variance * otherVariance / both * Math.max(1, apart * apart / both);
  }

  /**
   * Degree to which the delay of pixels is too short to explain the lag of ON events. The delay is
   * the standard deviation of the times over the relative mismatch of thresholds.
   *
   * @param lagS of ON behind OFF events, seconds
   * @param timingSdS standard deviation of the time of an event, seconds
   * @return 0 to 1
   */
  static double fastShare(double lagS, double timingSdS) {
    double half = Math.max(0, lagS) / 2;
    double delay = timingSdS / THRESHOLD_MISMATCH;
    return half == 0 ? 0 : half * half / (half * half + delay * delay);
  }

  /**
   * Whether the times of OFF events scatter by more than those of a narrow wing: by half of its
   * passage at most (Popoviciu 1935), and by as much due to noise.
   */
  static boolean isWide(double timingSdS, double fullSpeed) {
    return timingSdS > overPixelS(fullSpeed) * Math.sqrt(0.5);
  }

  /**
   * Latency of OFF events.
   *
   * @param constantUs constant delay of the camera, microseconds
   * @param lagS of ON events behind OFF events, seconds
   * @param fullSpeed of the wing in the middle of its stroke, radians a second
   * @return seconds
   */
  static double seconds(double constantUs, double lagS, double fullSpeed) {
    double over = overPixelS(fullSpeed);
    double slow = Math.max(0, lagS - BLIND_S2 / over);
    return constantUs * 1e-6 + SLOW_SHARE * over * (1 - Math.exp(-slow / SLOW_LAG_S));
  }

  /**
   * Variance of {@link #seconds} with a known constant delay, squared seconds. The held lag is 0 if
   * there are events of both edges.
   */
  static double variance(double heldLagS) {
    double held = HELD_SHARE * heldLagS;
    return LEFT_S * LEFT_S + held * held;
  }
}
