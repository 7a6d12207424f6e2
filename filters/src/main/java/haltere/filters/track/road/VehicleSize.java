package haltere.filters.track.road;

/**
 * How long and how high vehicles are: what is not so high that it is a lorry is no longer than a
 * car, and what is no wider than a car is no higher than a van.
 *
 * <p>Thread rule: constants only.
 */
public final class VehicleSize {
  /** Half of the width of the widest car or van. */
  private static final double CAR_HALF_M = 1.05;

  /** Half of the width of the shoulders of who rides a motorcycle, as they may seem, metres. */
  public static final double NARROW_HALF_M = 0.7;

  private static final double CAR_LONG_M = 5.5;
  private static final double LORRY_LONG_M = 12;
  private static final double CAR_HIGH_M = 2.2;
  private static final double LORRY_HIGH_M = 4;

  /** What is nearly as high as the camera seems to be anywhere. */
  private static final double MOST_SCALE = 4.5;

  private VehicleSize() {}

  /**
   * How far from its nearer end a vehicle may have a line.
   *
   * @param highM how high the line is, metres
   * @return metres
   */
  public static double longestM(double highM) {
    return highM < CAR_HIGH_M ? CAR_LONG_M : LORRY_LONG_M;
  }

  /**
   * How long a vehicle may be.
   *
   * @param halfWidthM half of its width, metres; infinite if that is not known
   * @return metres
   */
  public static double longestWideM(double halfWidthM) {
    return halfWidthM < CAR_HALF_M ? CAR_LONG_M : LORRY_LONG_M;
  }

  /**
   * How many times as far away as it is the roof of a vehicle may seem, seen from a height.
   *
   * @param halfWidthM half of its width, metres; infinite if that is not known
   * @param fromM the height, metres
   * @return at least 1
   */
  public static double mostScale(double halfWidthM, double fromM) {
    double highM = halfWidthM < CAR_HALF_M ? CAR_HIGH_M : LORRY_HIGH_M;
    return highM < fromM ? Math.min(MOST_SCALE, fromM / (fromM - highM)) : MOST_SCALE;
  }
}
