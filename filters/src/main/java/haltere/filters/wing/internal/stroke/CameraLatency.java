package haltere.filters.wing.internal.stroke;

/**
 * Time from an edge's passage to the time stamp of its OFF event: a constant delay, which no event
 * tells, and what the photoreceptor adds. A pixel answers, if at all, while the wing is over it;
 * how late, ON events tell by how far they lag behind OFF events. A pixel without a lag is taken
 * for ideal. A fast wing makes ON events late for another reason: it has left the pixel before that
 * can make its next event.
 */
final class CameraLatency {
  /** Width of a wing as seen from its hinge, radians, where it is best seen: in mid stroke. */
  private static final double WING_RAD = 0.05;

  /** A slow pixel's delay as a share of the time that the wing is over it. */
  private static final double SLOW_SHARE = 0.35;

  /** Lag of ON events at which a pixel begins to be slow. */
  private static final double SLOW_LAG_S = 18e-6;

  /**
   * Lag of ON events, times the time that the wing is over a pixel, for which it is enough that a
   * pixel is blind for some tens of microseconds after an event; as found on simulated flies.
   */
  private static final double BLIND_S2 = 320e-12;

  /**
   * What is usually left of the delay, with what the stroke's shape is off by as the wing moves, as
   * found on simulated flies; it is the same for slow and for fast wings.
   */
  private static final double LEFT_S = 6e-6;

  /** Uncertainty of a lag that events of one edge alone do not tell, as a share of it. */
  private static final double HELD_SHARE = 0.1;

  /**
   * Mismatch of the thresholds of pixels as a share of the threshold: 2.1 % of contrast at a
   * threshold of 15 % (Lichtsteiner, Posch and Delbruck 2008).
   */
  private static final double THRESHOLD_MISMATCH = 0.14;

  private CameraLatency() {}

  /** Time for which the wing is over a pixel, by its root mean square speed. */
  private static double overPixelS(double fullSpeed) {
    return WING_RAD * Math.sqrt(2) / Math.max(1, fullSpeed);
  }

  /**
   * Lag of ON behind OFF events, seconds. Both wings are seen by the same pixels, so that what each
   * of them says counts by how sure it is; the other wing is null if it is not tracked.
   */
  static double lagS(StrokeEkf own, StrokeEkf other) {
    double lag = own.x[StrokeEkf.LAG];
    if (other == null) {
      return lag;
    }
    double variance = own.belief.covariance(StrokeEkf.LAG, StrokeEkf.LAG);
    double otherVariance = other.belief.covariance(StrokeEkf.LAG, StrokeEkf.LAG);
    return lag + variance / (variance + otherVariance) * (other.x[StrokeEkf.LAG] - lag);
  }

  /**
   * Variance of {@link #lagS}, squared seconds. Wings that disagree by more than their variances
   * explain raise it by that ratio (Birge 1932, equation 4).
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
   * Degree to which pixels are too fast to explain the lag of ON events by their own delay. The
   * time that a pixel takes to its threshold spreads with the threshold: its delay is the spread of
   * the times over the mismatch.
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
   * Whether OFF events spread in time by more than a narrow wing explains: by half of its passage
   * at most (Popoviciu 1935), and by as much through noise of the times.
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
   * Variance of {@link #seconds}, seconds squared, where the constant delay is known or does not
   * matter. The held lag is one that is not told by events of both edges, else 0.
   */
  static double variance(double heldLagS) {
    double held = HELD_SHARE * heldLagS;
    return LEFT_S * LEFT_S + held * held;
  }
}
