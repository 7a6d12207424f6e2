package haltere.filters.wing.stroke;

/**
 * Time from an edge's passage to the time stamp of its OFF event: a constant delay, which no event
 * tells, and what the photoreceptor adds. A pixel answers, if at all, while the wing is over it;
 * how late, ON events tell by how far they lag behind OFF events. A pixel without a lag is taken
 * for ideal. A fast wing makes ON events late for another reason: it has left the pixel before that
 * can make its next event.
 */
final class CameraLatency {
  /** Constant delay that is taken where nobody says it: no camera is without one. */
  private static final double USUAL_S = 60e-6;

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

  /** What is not known of the constant delay, where nobody says it. */
  private static final double UNKNOWN_S = 15e-6;

  private CameraLatency() {}

  /** Time for which the wing is over a pixel, by its root mean square speed. */
  private static double overPixelS(double fullSpeed) {
    return WING_RAD * Math.sqrt(2) / Math.max(1, fullSpeed);
  }

  /**
   * Lag of ON behind OFF events. Both wings are seen by the same pixels, so that what each of them
   * says counts by how sure it is.
   *
   * @param own filter of the wing
   * @param other filter of the other wing, null if that is not tracked
   * @return seconds
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
   * Latency of OFF events.
   *
   * @param knownUs constant delay of the camera, microseconds; negative if it is not known
   * @param lagS of ON events behind OFF events, seconds
   * @param fullSpeed of the wing in the middle of its stroke, radians a second
   * @return seconds
   */
  static double seconds(double knownUs, double lagS, double fullSpeed) {
    double over = overPixelS(fullSpeed);
    double slow = Math.max(0, lagS - BLIND_S2 / over);
    double constant = knownUs >= 0 ? knownUs * 1e-6 : USUAL_S;
    return constant + SLOW_SHARE * over * (1 - Math.exp(-slow / SLOW_LAG_S));
  }

  /**
   * Standard deviation of {@link #seconds}.
   *
   * @param knownUs constant delay of the camera, microseconds; negative if it is not known
   * @return seconds
   */
  static double sdSeconds(double knownUs) {
    return Math.hypot(LEFT_S, knownUs >= 0 ? 0 : UNKNOWN_S);
  }
}
