package haltere.filters.track.kalman;

import haltere.filters.track.motion.MotionModes;

/**
 * Vehicles whose lower edge has left the picture at the bottom. Their roofs are in it for some time
 * more, and are no vehicles.
 *
 * <p>Thread rule: that of its owner.
 */
final class DepartedVehicles {
  private static final int MOST = 8;
  private static final double US = 1e-6;

  /** How far before or behind its place a line of a vehicle that is not high may seem to be. */
  private static final double PLACE_M = 1.5;

  /** The same for a high one. */
  private static final double HIGH_PLACE_M = 3;

  private static final double LIKE_SHARE = 0.07;
  private static final double MOST_SCALE = 4.5;
  private static final double ASIDE_SHARE = 0.6;
  private static final double ASIDE_M = 0.5;

  /** How far below the camera a vehicle may be whose roof is still in the picture. */
  private static final double BELOW_M = 10;

  private final double[] xM = new double[MOST];
  private final double[] yM = new double[MOST];
  private final double[] vyMS = new double[MOST];
  private final double[] halfM = new double[MOST];
  private final double[] lengthM = new double[MOST];
  private final long[] timeUs = new long[MOST];
  private int count;
  private int next;

  void clear() {
    count = 0;
    next = 0;
  }

  /** Remembers a vehicle that comes and has just left. */
  void add(MotionModes motion, RoadLine line, long nowUs) {
    xM[next] = motion.x();
    yM[next] = motion.y();
    vyMS[next] = motion.vy();
    halfM[next] = line.halfWidthM;
    lengthM[next] = line.lengthM();
    timeUs[next] = nowUs;
    next = (next + 1) % MOST;
    count = Math.min(MOST, count + 1);
  }

  /** Whether a line is of one of them. */
  boolean own(double lineXM, double lineYM, double lineVyMS, double lineHalfM, long nowUs) {
    for (int i = 0; i < count; i++) {
      double place = yM[i] + vyMS[i] * (nowUs - timeUs[i]) * US;
      if (place >= -BELOW_M
          && isOf(
              lineXM, lineYM, lineVyMS, lineHalfM, xM[i], place, vyMS[i], halfM[i], lengthM[i])) {
        return true;
      }
    }
    return false;
  }

  /** Whether a line is of a vehicle that is in the picture. */
  static boolean isOf(MotionModes line, RoadLine width, MotionModes vehicle, RoadLine size) {
    return isOf(
        line.x(),
        line.y(),
        line.vy(),
        width.halfWidthM,
        vehicle.x(),
        vehicle.y(),
        vehicle.vy(),
        size.halfWidthM,
        size.lengthM());
  }

  private static boolean isOf(
      double lineXM,
      double lineYM,
      double lineVyMS,
      double lineHalfM,
      double x,
      double y,
      double vy,
      double half,
      double length) {
    double scale = lineVyMS / vy;
    if (!(scale > 1 - LIKE_SHARE && scale < MOST_SCALE)) {
      return false;
    }
    double along = lineYM / scale - y;
    double most = length + (scale < 1 + LIKE_SHARE ? PLACE_M : HIGH_PLACE_M);
    double wide = Math.max(lineHalfM / scale, half);
    double within = half - lineHalfM / scale;
    return along > -PLACE_M
        && along < most
        && Math.abs(lineXM / scale - x) < Math.max(ASIDE_SHARE * wide, within) + ASIDE_M;
  }
}
