package haltere.filters.track.kalman;

import haltere.filters.track.motion.MotionModes;

/** Speed of a track on a road. */
final class RoadSpeed {
  private static final double KM_H = 3.6;

  /** Standard deviation of the speed of a line that was just found, as a share. */
  private static final double NEW_SHARE = 0.1;

  private RoadSpeed() {}

  /** Kilometres an hour. */
  static double kmH(MotionModes motion) {
    return KM_H * Math.hypot(motion.vx(), motion.vy());
  }

  /**
   * Standard deviation, as a share, that a speed has beside what the filter knows: for it may be
   * that the line is above the road, or, the fewer rows it has passed, that it is none.
   */
  static double share(Track track) {
    return Math.hypot(track.line.grounding.speedShare(), NEW_SHARE * track.line.last.doubt());
  }

  /**
   * Standard deviation of the speed in kilometres an hour, to first order, with that of a line that
   * may be above the road.
   */
  static double sdKmH(Track track, MotionModes motion) {
    double vx = motion.vx();
    double vy = motion.vy();
    double square = vx * vx + vy * vy;
    double xx = motion.covariance(2, 2);
    double yy = motion.covariance(3, 3);
    double variance =
        square > 0
            ? (vx * vx * xx + 2 * vx * vy * motion.covariance(2, 3) + vy * vy * yy) / square
            : Math.max(xx, yy);
    double share = share(track);
    return KM_H * Math.sqrt(variance + share * share * square);
  }
}
