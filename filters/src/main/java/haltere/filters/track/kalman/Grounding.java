package haltere.filters.track.kalman;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.motion.MotionModes;

/**
 * How sure it is that the line that a track follows is on the road. A line above the road is too
 * fast and too far away, in one proportion, and what is followed may be one: while the lower edge
 * of a vehicle that comes into the picture from below is not yet in it, and where the lower edge is
 * too narrow to be seen.
 *
 * <p>Thread rule: that of its owner.
 */
final class Grounding {
  /** Standard deviation, as a share, of the speed of a line that may be on the roof of a car. */
  private static final double HIDDEN_SHARE = 0.2;

  /** The same of one that has passed so many rows that a lower one would have been found. */
  private static final double KNOWN_HIDDEN_SHARE = 0.05;

  /** The same of a narrow line, which may be the shoulders of who rides a motorcycle. */
  private static final double NARROW_SHARE = 0.1;

  /**
   * Heights of the boot and of the roof of a car, of what is painted on a lorry and of its roof,
   * and how far they are before the rear end.
   */
  private static final double[] HEIGHTS_M = {0.9, 1.5, 2.6, 3.6};

  private static final double[] BEFORE_M = {0, 3, 0, 9.5};

  /** Half of the width of a car, of which a narrow line may be a piece. */
  private static final double USUAL_HALF_M = 0.9;

  /** What is slower is not on the roof of a lorry. */
  private static final double FAST_M_S = 30;

  private static final int SLOW_HEIGHTS = 3;
  private static final double LEAST_SHARE = 0.28;

  private static final double NARROW_HALF_M = 0.55;

  /** Standard deviation, as a share, of the speed of a line that is where no vehicle can be. */
  private static final double BESIDE_SHARE = 0.3;

  /** The same where vehicles seldom are: their higher lines seem to be farther aside. */
  private static final double OFF_SHARE = 0.07;

  /** So far from the middle of a lane, of its width, vehicles seldom are. */
  private static final double OFF_WIDTHS = 0.15;

  /** The same of what is faster than most vehicles, unless nothing lower could be missed. */
  private static final double FAST_SHARE = 0.3;

  /** So far beside the lanes the side of a vehicle may seem to be. */
  private static final double VERGE_M = 0.6;

  /** Half of the width of a line that is wider than any vehicle, and what of a column it may be. */
  private static final double WIDEST_HALF_M = 1.45;

  private static final double COLUMN_SHARE = 0.5;

  /** A line so wide would have been seen on the road too. */
  private static final double SEEN_HALF_PX = 4;

  /** Half of the width of wheels, which would have been seen on the road where they are so wide. */
  private static final double WHEELS_HALF_M = 0.18;

  private static final double SEEN_WHEELS_PX = 1.5;

  private boolean hasUpper;
  private boolean isHidden;
  private boolean isNarrow;
  private boolean isBeside;
  private boolean isKnown;
  private boolean isOff;
  private boolean isFast;

  /** Whether it was followed where anything below it would have been seen. */
  private boolean isLow;

  /** Begins with a line of which nothing else is known. */
  void begin(boolean goesAway) {
    hasUpper = false;
    isHidden = goesAway;
    isNarrow = false;
    isBeside = false;
    isKnown = false;
    isOff = false;
    isFast = false;
    isLow = false;
  }

  /** Takes note of a higher line of the same vehicle. */
  void foundUpper() {
    hasUpper = true;
  }

  /** Whether a higher line of the same vehicle is known. */
  boolean hasUpper() {
    return hasUpper;
  }

  /** Takes note of where the line is now. */
  void look(
      MotionModes motion,
      RoadLine line,
      RoadMapping road,
      SensorGeometry sensor,
      LaneSettings lanes) {
    double height = road.settings().bridgeHeightM();
    double perColumnM = road.pixelAngle() * Math.hypot(height, Math.max(0, motion.y()));
    isBeside =
        line.halfWidthM > WIDEST_HALF_M + COLUMN_SHARE * perColumnM
            || lanes.lanes() > 0 && besideM(motion.x(), line.halfWidthM, lanes) > VERGE_M;
    isKnown = line.last.isKnown();
    isHidden &= mayBeOut(motion, line, road, sensor);
    isLow |= WHEELS_HALF_M > SEEN_WHEELS_PX * perColumnM && isKnown;
    double offM = Math.abs(motion.x() - lanes.nearestMiddleM(motion.x()));
    isOff = lanes.lanes() > 0 && offM > OFF_WIDTHS * lanes.widthM();
    isFast = !isLow && Math.abs(motion.vy()) > FAST_M_S;
    isNarrow =
        !hasUpper && !isLow && line.halfWidthM < NARROW_HALF_M && line.halfPx() < SEEN_HALF_PX;
  }

  /** How far the one side of what is on the road is beside the lanes. */
  private static double besideM(double xM, double halfM, LaneSettings lanes) {
    return halfM + Math.max(lanes.leftEdgeM() - xM, xM - lanes.rightEdgeM());
  }

  /** Whether the lower edge would be outside the picture if the line were on a car. */
  private static boolean mayBeOut(
      MotionModes motion, RoadLine line, RoadMapping road, SensorGeometry sensor) {
    double height = road.settings().bridgeHeightM();
    boolean isFast = Math.abs(motion.vy()) > FAST_M_S;
    for (int i = 0; i < (isFast ? HEIGHTS_M.length : SLOW_HEIGHTS); i++) {
      double share = Math.max(LEAST_SHARE, 1 - HEIGHTS_M[i] / height);
      double y = motion.y() * share - BEFORE_M[i];
      if (!(y > 0) || road.rowOf(y) < 1) {
        return true;
      }
      double x = motion.x() * share;
      double half = Math.max(USUAL_HALF_M, line.halfWidthM) * share;
      if (road.columnOf(x - half, y) < 0 || road.columnOf(x + half, y) > sensor.width() - 1) {
        return true;
      }
    }
    return false;
  }

  /** Whether the vehicle may have a lower line outside the picture. */
  boolean isHidden() {
    return isHidden;
  }

  /** Whether the line is where no vehicle can be, wider than one or beside the lanes. */
  boolean isBeside() {
    return isBeside;
  }

  /** Standard deviation that the speed has for this, as a share of it. */
  double speedShare() {
    double hidden = isKnown ? KNOWN_HIDDEN_SHARE : HIDDEN_SHARE;
    double share = isBeside ? BESIDE_SHARE : isHidden ? hidden : isNarrow ? NARROW_SHARE : 0;
    return Math.hypot(Math.hypot(share, isOff ? OFF_SHARE : 0), isFast ? FAST_SHARE : 0);
  }
}
