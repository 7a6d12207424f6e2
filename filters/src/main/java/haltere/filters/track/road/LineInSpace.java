package haltere.filters.track.road;

import haltere.filters.track.motion.MotionModes;

/**
 * A line across the road as if it were on the ground. What is at height z above it, seen from
 * height h, seems to be s = h / (h − z) times as far away, as far aside and as fast as it is.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class LineInSpace {
  private static final double LEAST_SCALE = 1.07;
  private static final double SIGMAS = 2;
  private static final double ASIDE_SHARE = 0.6;
  private static final double ASIDE_M = 0.2;
  private static final double ALIKE_SIGMAS = 3;
  private static final double ALIKE_SHARE = 0.07;
  private static final double NEARER_M = 2.5;

  /** As far above, in half widths, as the roof of a lorry or a helmet seems to be. */
  private static final double MOST_HALVES = 12;

  private final double bridgeM;
  private double xM;
  private double yM;
  private double vyMS;
  private double varianceVy;
  private double halfWidthM;

  /**
   * A line that has yet to be {@link #set}.
   *
   * @param bridgeM from what height it is seen
   */
  public LineInSpace(double bridgeM) {
    this.bridgeM = bridgeM;
  }

  /**
   * Whether this and another move alike, this one behind the other.
   *
   * @param other seen from the same height
   * @param mostM at most so many metres apart
   * @return true if so
   */
  public boolean isBehind(LineInSpace other, double mostM) {
    double sd = Math.sqrt(varianceVy + other.varianceVy);
    double unlike = Math.abs(vyMS - other.vyMS);
    return vyMS * other.vyMS > 0
        && unlike < Math.max(ALIKE_SIGMAS * sd, ALIKE_SHARE * Math.abs(other.vyMS))
        && yM > other.yM
        && yM < other.yM + mostM
        && Math.abs(xM - other.xM) < halfWidthM + other.halfWidthM + ASIDE_M;
  }

  /**
   * How far behind another it is if it is above that one.
   *
   * @param other seen from the same height
   * @return metres on the road
   */
  public double behindM(LineInSpace other) {
    return yM * other.vyMS / vyMS - other.yM;
  }

  /**
   * Says where it is.
   *
   * @param x metres to the right
   * @param y metres ahead
   * @param vy metres a second along the road
   * @param variance of that
   * @param halfWidth half of its width, metres
   */
  public void set(double x, double y, double vy, double variance, double halfWidth) {
    xM = x;
    yM = y;
    vyMS = vy;
    varianceVy = variance;
    halfWidthM = halfWidth;
  }

  /**
   * Says that it moves as something that is followed.
   *
   * @param motion on the road, in metres
   * @param halfWidth half of its width, metres
   */
  public void set(MotionModes motion, double halfWidth) {
    set(motion.x(), motion.y(), motion.vy(), motion.covariance(3, 3), halfWidth);
  }

  /**
   * Says that it is one that was found.
   *
   * @param found a line
   */
  public void set(FoundLine found) {
    set(found.xM, found.yM, found.vyMS, found.varianceVy, found.halfWidthM);
  }

  /**
   * Where its middle seems to be across the road.
   *
   * @return metres to the right
   */
  public double xM() {
    return xM;
  }

  /**
   * Where it seems to be along the road.
   *
   * @return metres ahead
   */
  public double yM() {
    return yM;
  }

  /**
   * How fast it seems to be along the road.
   *
   * @return metres a second
   */
  public double vyMS() {
    return vyMS;
  }

  /**
   * How wide it seems to be.
   *
   * @return half of its width, metres
   */
  public double halfWidthM() {
    return halfWidthM;
  }

  /**
   * Whether this is a higher line of the vehicle whose other line is given: significantly faster,
   * and in the same proportion farther aside and away, at most a vehicle's length beyond.
   *
   * @param other seen from the same height
   * @param gapHalfWidths how far above the other it is seen, in half widths of the other
   * @return true if it may be one
   */
  public boolean isAbove(LineInSpace other, double gapHalfWidths) {
    double scale = vyMS / other.vyMS;
    double wide = Math.max(halfWidthM / scale, other.halfWidthM);
    double most = VehicleSize.mostScale(Double.POSITIVE_INFINITY, bridgeM);
    if (!(scale > LEAST_SCALE && scale < most) || gapHalfWidths > MOST_HALVES) {
      return false;
    }
    double sd = Math.sqrt(varianceVy + other.varianceVy);
    if (Math.abs(vyMS - other.vyMS) < SIGMAS * sd) {
      return false;
    }
    double farther = yM / scale - other.yM;
    double within = other.halfWidthM - halfWidthM / scale;
    return farther > -NEARER_M
        && farther < VehicleSize.longestM(bridgeM * (1 - 1 / scale))
        && gapHalfWidths > 0
        && Math.abs(xM / scale - other.xM) < Math.max(ASIDE_SHARE * wide, within) + ASIDE_M;
  }
}
