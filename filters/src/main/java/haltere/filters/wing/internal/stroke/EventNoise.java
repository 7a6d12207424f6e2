package haltere.filters.wing.internal.stroke;

/**
 * Variance of the angle of an event, estimated from residuals: the sum of the variance of the wing,
 * of the pixel size as seen from the hinge, and of the times at the present speed of the wing.
 * Outliers are uniform; the weight of an event is its probability of being an inlier.
 *
 * <p>Residuals near the reversals determine the variance of the wing, those in mid stroke that of
 * the times, those far from the wing the density of outliers.
 */
final class EventNoise {
  /** Variance of the position of an event in a pixel, squared pixels; 1/12 for a square one. */
  private static final double PIXEL_VARIANCE = 0.12;

  private static final double LEARN = 0.004;
  private static final double FOLLOW = 0.002;
  private static final double SCALE_SHARE = 0.3;
  private static final double MIN_SCALE = 0.02;
  private static final double MAX_SCALE = 4;

  /** Weight of a beat in the mean NIS. */
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
   * Initial noise. Innovations beyond the gate are rejected; a fixed variance of 0 is estimated.
   */
  EventNoise(double gateSd, double fixed) {
    apply(gateSd, fixed);
  }

  void apply(double gateSd, double fixed) {
    gateSquare = gateSd * gateSd;
    this.fixed = fixed;
  }

  /** Variance of the angle of an event. */
  double variance(double radiusSquare, double speed) {
    varianceNow =
        fixed > 0
            ? fixed
            : scale * (wingVariance + PIXEL_VARIANCE / radiusSquare + timing * speed * speed);
    return varianceNow;
  }

  /**
   * Judges a residual whose {@link #variance} was just computed.
   *
   * @param y the residual
   * @param expected variance of its expectation
   * @param speed of the wing, radians a second
   * @param fullSpeed speed in mid stroke, radians a second
   * @return probability of being an inlier, 0 to 1; 0 if it is rejected
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

  /** Fixed variance of a measurement, 0 if it is estimated. */
  double fixed() {
    return fixed;
  }

  /** Variance of the last event. */
  double present() {
    return varianceNow;
  }

  /** Standard deviation of the time of an event, seconds. */
  double timingSdS() {
    return Math.sqrt(scale * timing);
  }

  double nis() {
    return nis;
  }

  /** Share of the events near the wing beyond chance; about 0 if all are outliers. */
  double excess() {
    return near - outliers * 2 * NEAR_SD * Math.sqrt(varianceNow);
  }

  /** Density of outliers per radian, as a share of the events. */
  double outliers() {
    return outliers;
  }
}
