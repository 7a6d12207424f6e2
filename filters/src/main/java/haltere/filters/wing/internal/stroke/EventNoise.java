package haltere.filters.wing.internal.stroke;

/**
 * Variance of an event's angle, estimated from the residuals. It is the sum of the wing's variance,
 * of the pixel's size as seen from the hinge, and of the times at the wing's present speed.
 * Outliers lie anywhere; an event counts by its probability to be none.
 *
 * <p>Near the reversals the wing is slow, and residuals tell the wing's variance; in the middle of
 * the stroke they tell that of the times. Residuals far from the wing tell the outliers' density.
 * Thread rule: one thread at a time.
 */
final class EventNoise {
  /** Variance of the place of an event in a pixel, squared pixels; 1/12 for a square one. */
  private static final double PIXEL_VARIANCE = 0.12;

  private static final double LEARN = 0.004;
  private static final double FOLLOW = 0.002;
  private static final double SCALE_SHARE = 0.3;
  private static final double MIN_SCALE = 0.02;
  private static final double MAX_SCALE = 4;

  /** Of the mean NIS, slow enough that a beat of few or of many events is one of many. */
  private static final double NIS_SHARE = 0.125;

  private static final double FAR_FROM = 0.45;
  private static final double FAR_TO = 1.25;
  private static final double FAR_WIDTH = 2 * (FAR_TO - FAR_FROM);
  private static final double NEAR_SD = 3;

  private double gateSquare;
  private double fixed;
  private double wingVariance = 4e-4;
  private double timing = 9e-10;
  private double outliers = 0.05;
  private double near = 1;
  private double nis = 1;
  private double scale = 1;
  private double varianceNow = 1e-3;

  /**
   * Noise of events of which nothing is known yet: innovations beyond the gate are refused, a fixed
   * variance of 0 is learnt.
   */
  EventNoise(double gateSd, double fixed) {
    apply(gateSd, fixed);
  }

  void apply(double gateSd, double fixed) {
    gateSquare = gateSd * gateSd;
    this.fixed = fixed;
  }

  /** Variance of an event's angle. */
  double variance(double radiusSquare, double speed) {
    varianceNow =
        fixed > 0
            ? fixed
            : scale * (wingVariance + PIXEL_VARIANCE / radiusSquare + timing * speed * speed);
    return varianceNow;
  }

  /**
   * Judges a residual whose {@link #variance} was just asked for.
   *
   * @param y the residual
   * @param expected variance of what was expected of it
   * @param speed of the wing, radians a second
   * @param fullSpeed in the middle of the stroke
   * @return how far it is believed to be the wing's, 0 to 1; 0 if it is refused
   */
  double judge(double y, double expected, double speed, double fullSpeed) {
    double square = y * y;
    double variance = varianceNow + expected;
    double normalised = square / variance;
    double away = Math.abs(y);
    double far = away > FAR_FROM && away < FAR_TO ? 1 / FAR_WIDTH : 0;
    outliers += FOLLOW * (far - outliers);
    near += FOLLOW * ((normalised < NEAR_SD * NEAR_SD ? 1 : 0) - near);
    if (!(normalised <= gateSquare)) {
      return 0;
    }
    double belief =
        1 / (1 + (outliers + 1e-3) * Math.sqrt(2 * Math.PI * variance) * Math.exp(normalised / 2));
    double step = LEARN * belief;
    nis += NIS_SHARE * step * (normalised - nis);
    double changed = scale + SCALE_SHARE * step * (normalised - 1);
    scale = Math.max(MIN_SCALE, Math.min(MAX_SCALE, changed));
    double share = speed * speed / (fullSpeed * fullSpeed);
    if (share > 0.4) {
      timing += step * (square - variance) / (speed * speed);
      timing = Math.max(1e-11, Math.min(1e-7, timing));
    } else if (share < 0.12) {
      wingVariance += step * (square - variance);
      wingVariance = Math.max(1e-6, Math.min(0.02, wingVariance));
    }
    return belief;
  }

  /** Variance of a measurement that is set, 0 where it is learnt. */
  double fixed() {
    return fixed;
  }

  /** Variance of the event that was looked at last. */
  double present() {
    return varianceNow;
  }

  /** Standard deviation of the time of an event, seconds. */
  double timingSdS() {
    return Math.sqrt(scale * timing);
  }

  /** Mean normalised innovation squared of late. */
  double nis() {
    return nis;
  }

  /**
   * Share of the events near the wing that chance does not explain, about 0 if all are outliers.
   */
  double excess() {
    return near - outliers * 2 * NEAR_SD * Math.sqrt(varianceNow);
  }

  /** Strays a radian, as a share of the events. */
  double outliers() {
    return outliers;
  }
}
