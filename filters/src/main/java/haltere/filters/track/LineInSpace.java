package haltere.filters.track;

/**
 * A line across the road as if it were on the ground. What is at height z above it, seen from
 * height h, seems to be s = h / (h − z) times as far away, as far aside and as fast as it is.
 *
 * <p>Thread rule: that of its owner.
 */
final class LineInSpace {
  /** A lorry of 3.6 m seen from 5 m. */
  private static final double MOST_SCALE = 4.5;

  private static final double LEAST_SCALE = 1.07;
  private static final double SIGMAS = 2;
  private static final double ASIDE_SHARE = 0.6;
  private static final double ASIDE_M = 0.2;
  private static final double NEARER_M = 2.5;

  /** Most vehicles are shorter. */
  private static final double FARTHER_M = 7;

  /** No vehicle is three times as high as it is wide. */
  private static final double MOST_HALVES = 6;

  private double xM;
  private double yM;
  private double vyMS;
  private double varianceVy;
  private double halfWidthM;

  void set(double x, double y, double vy, double variance, double halfWidth) {
    xM = x;
    yM = y;
    vyMS = vy;
    varianceVy = variance;
    halfWidthM = halfWidth;
  }

  void set(Track track, MotionModes motion) {
    set(motion.x(), motion.y(), motion.vy(), motion.covariance(3, 3), track.line.halfWidthM);
  }

  /**
   * Whether this is a higher line of the vehicle whose other line is given: significantly faster,
   * and in the same proportion farther aside and away, at most a vehicle's length beyond. How far
   * above the other it is seen is given in half widths of the other.
   */
  boolean isAbove(LineInSpace other, double gapHalfWidths) {
    double scale = vyMS / other.vyMS;
    if (!(scale > LEAST_SCALE && scale < MOST_SCALE) || gapHalfWidths > MOST_HALVES) {
      return false;
    }
    double sd = Math.sqrt(varianceVy + other.varianceVy);
    if (Math.abs(vyMS - other.vyMS) < SIGMAS * sd) {
      return false;
    }
    double farther = yM / scale - other.yM;
    double wide = Math.max(halfWidthM / scale, other.halfWidthM);
    return farther > -NEARER_M
        && farther < FARTHER_M
        && gapHalfWidths > 0
        && Math.abs(xM / scale - other.xM) < ASIDE_SHARE * wide + ASIDE_M;
  }
}
