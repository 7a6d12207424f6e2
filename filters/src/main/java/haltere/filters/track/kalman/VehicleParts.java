package haltere.filters.track.kalman;

import haltere.filters.track.RoadMapping;
import haltere.filters.track.motion.MotionModes;
import haltere.filters.track.road.FoundLine;
import haltere.filters.track.road.LineInSpace;
import haltere.filters.track.road.RoadEvents;

/**
 * Which lines, and which tracks on lines, are parts of one vehicle: what moves alike one behind the
 * other, and what is higher and so much farther away, aside and faster in one proportion.
 *
 * <p>Thread rule: that of its owner.
 */
final class VehicleParts {
  private static final double SIDE_M = 0.3;

  /** Lines of one vehicle have speeds that differ by less than this share, and three sigmas. */
  private static final double LIKE_SHARE = 0.15;

  /** Two edges of one vehicle that both become darker, or both brighter, are nearer than this. */
  private static final double SAME_EDGE_M = 2.5;

  /** Where one becomes darker and one brighter they may be its front and its rear. */
  private static final double OTHER_EDGE_M = 5.2;

  /** The same of a motorcycle, which another may follow nearer. */
  private static final double NARROW_LENGTH_M = 3;

  private static final double NARROW_HALF_M = 0.55;

  /** Lines of one vehicle between which there is more of it are not farther apart than this. */
  private static final double LONGEST_M = 11;

  private static final double ROW_PX = 1;

  /** What has stood is found to go again not before it has passed some rows. */
  private static final double STARTED_ROWS = 4;

  /** What stood speeds up by less than this. */
  private static final double STARTING_M_S2 = 5;

  /** What a line has to have of the width of a vehicle that it is to stand for. */
  private static final double WIDTH_SHARE = 0.5;

  /** What is followed for longer is not taken for a part of another that is slower. */
  private static final long KNOWN_US = 1_500_000;

  /** The speed of what was measured as often is known. */
  private static final int SURE_UPDATES = 3;

  private static final int MARGIN_ROWS = 1;
  private static final double FILLED_SHARE = 0.4;
  private static final double SURE_SCALE = 1.6;

  private final RoadMapping road;
  private final RoadEvents events;
  private final FoundLine found;
  private final LineInSpace upper;
  private final LineInSpace lower;

  VehicleParts(RoadMapping road, RoadEvents events, FoundLine found) {
    this.road = road;
    this.events = events;
    this.found = found;
    upper = new LineInSpace(road.settings().bridgeHeightM());
    lower = new LineInSpace(road.settings().bridgeHeightM());
  }

  /** Whether the line that was found is of a vehicle, which then knows of it or goes over to it. */
  boolean isPartOf(Track track, long timeUs) {
    MotionModes motion = track.at(timeUs);
    if (isPartOfTall(track, motion, timeUs)) {
      return true;
    }
    double wide = Math.max(found.halfWidthM(), track.line.halfWidthM) + SIDE_M;
    return Math.abs(found.xM() - motion.x()) <= wide
        && (isFoundAgain(track, motion, timeUs) || isPartOfFlat(track, motion, timeUs));
  }

  /** Whether the vehicle has lost its line, or stood, and goes on with the one that was found. */
  private boolean isFoundAgain(Track track, MotionModes motion, long timeUs) {
    RoadLine line = track.line;
    double apartM = Math.abs(found.yM() - motion.y());
    double perRow = events.metresPerRow(found.lastRow());
    boolean sameWay = found.vyMS() * motion.vy() > 0;
    boolean isNew = track.updates < SURE_UPDATES;
    boolean lost = line.isLost() && !line.isOut() && sameWay && (isNew || isAsFast(motion));
    boolean isThere = motion.covariance(1, 1) < OTHER_EDGE_M * OTHER_EDGE_M;
    double startsM = Math.max(OTHER_EDGE_M, STARTED_ROWS * perRow);
    boolean starts =
        track.stands && isThere && line.last.goes(found.vyMS()) && mayHaveReached(startsM);
    double seenM = Math.min(line.lengthM() + SAME_EDGE_M, line.extentPx() * perRow);
    if (lost && apartM < Math.max(OTHER_EDGE_M, seenM) || starts && apartM < startsM) {
      line.change(found, (motion.y() - found.yM()) / perRow, timeUs);
      if (isNew || starts) {
        track.moveOn(found, timeUs);
      } else {
        track.rejoin(found, timeUs);
      }
      return true;
    }
    return false;
  }

  /** Whether what has stood so far away may be as fast by now as the line that was found. */
  private boolean mayHaveReached(double awayM) {
    return found.vyMS() * found.vyMS() < 2 * STARTING_M_S2 * awayM;
  }

  /** Whether the line that was found is about as fast as a vehicle. */
  private boolean isAsFast(MotionModes motion) {
    double sd = Math.sqrt(motion.covariance(3, 3) + found.varianceVy());
    double unlike = Math.abs(found.vyMS() - motion.vy());
    return unlike <= LIKE_SHARE * Math.abs(motion.vy()) + 3 * sd;
  }

  /** Whether the line moves as the vehicle does, within what it may be long. */
  private boolean isPartOfFlat(Track track, MotionModes motion, long timeUs) {
    RoadLine line = track.line;
    double higherM = found.yM() - motion.y();
    double perRow = events.metresPerRow(found.lastRow());
    double filledM = line.extentPx() * perRow + SAME_EDGE_M;
    double gapM = found.isOn() == line.on() ? SAME_EDGE_M : OTHER_EDGE_M;
    if (!isAsFast(motion)
        || higherM <= -gapM
        || higherM >= Math.max(gapM, Math.min(LONGEST_M, filledM))) {
      return false;
    }
    if (higherM < 0 && found.halfWidthM() > WIDTH_SHARE * line.halfWidthM) {
      line.stretchTo(line.lengthM() - higherM);
      line.change(found, -higherM / perRow, timeUs);
      track.motion.shift(higherM, found.varianceY());
    } else {
      line.reachTo(higherM / perRow);
      line.stretchTo(higherM);
    }
    return true;
  }

  /** Whether the line is as much farther, faster and wider as a higher one of a vehicle is. */
  private boolean isPartOfTall(Track track, MotionModes motion, long timeUs) {
    upper.set(found);
    lower.set(motion, track.line.halfWidthM);
    RoadLine line = track.line;
    double gapPx = road.rowOf(found.yM()) - road.rowOf(motion.y());
    if (line.mayReach(gapPx) && upper.isAbove(lower, gapPx / line.halfPx()) && isFilled()) {
      line.reachTo(gapPx);
      line.stretchTo(upper.behindM(lower));
      line.grounding.foundUpper();
      return true;
    }
    if (mayBeUpper(track, timeUs)
        && (track.updates < SURE_UPDATES || !isFarAbove())
        && lower.isAbove(upper, -gapPx / line.halfPx())
        && isFilled()) {
      line.stretchTo(lower.behindM(upper));
      line.grounding.foundUpper();
      line.change(found, -gapPx, timeUs);
      track.moveOn(found, timeUs);
      return true;
    }
    return false;
  }

  /** Whether a track may be on a higher line of another, with something of a vehicle between. */
  boolean mayBeAbove(Track track, MotionModes motion, Track other, MotionModes under) {
    if (!DepartedVehicles.isOf(motion, track.line, under, other.line)
        || track.line.rowNow() <= other.line.rowNow()) {
      return false;
    }
    upper.set(motion, track.line.halfWidthM);
    lower.set(under, other.line.halfWidthM);
    return isFilled();
  }

  /** Whether one of the two lines is so high above the other that it is on a lorry. */
  private boolean isFarAbove() {
    double scale = upper.vyMS() / lower.vyMS();
    return Math.max(scale, 1 / scale) > SURE_SCALE;
  }

  /**
   * Whether there is something of the vehicle between the two lines, not empty road as between a
   * vehicle and a faster one before it. What seems to be so much faster is on a lorry.
   */
  private boolean isFilled() {
    if (isFarAbove()) {
      return true;
    }
    LineInSpace low = lower.yM() < upper.yM() ? lower : upper;
    LineInSpace high = low == lower ? upper : lower;
    int from = (int) Math.ceil(road.rowOf(low.yM())) + MARGIN_ROWS;
    int to = (int) Math.floor(road.rowOf(high.yM())) - MARGIN_ROWS;
    double half = Math.max(low.halfWidthM(), high.halfWidthM()) + SIDE_M;
    int most = events.rows() - 1;
    return to <= 0
        || events.filledShare(Math.max(0, from), Math.min(most, to), low.xM(), high.xM(), half)
            >= FILLED_SHARE;
  }

  /** Whether a track may be on a higher line: what was long seen on the road is on it. */
  private static boolean mayBeUpper(Track track, long timeUs) {
    RoadLine line = track.line;
    return line.grounding.isHidden()
        || line.grounding.isBeside()
        || line.halfWidthM < NARROW_HALF_M
        || !line.last.isKnown()
        || timeUs - line.sinceUs() < KNOWN_US;
  }

  /** Of two tracks on two edges of one vehicle the lower one stays, under the older name. */
  void unite(Tracks tracks, long timeUs) {
    for (int i = tracks.count() - 1; i >= 0; i--) {
      Track track = tracks.get(i);
      upper.set(track.at(timeUs), track.line.halfWidthM);
      for (int k = 0; k < tracks.count(); k++) {
        Track other = tracks.get(k);
        lower.set(other.at(timeUs), other.line.halfWidthM);
        if (k != i && isDrivenThrough(track, other)) {
          if (other.bornUs > track.heardUs) {
            other.nameAfter(track);
          }
          tracks.drop(i);
          break;
        }
        if (k != i && areOfOne(track, other, timeUs)) {
          other.line.reachTo(track.line.rowNow() - other.line.rowNow());
          other.nameAfter(track);
          tracks.drop(i);
          break;
        }
      }
    }
  }

  /** Whether a vehicle that was held to stand cannot be there, for another drives where it is. */
  private static boolean isDrivenThrough(Track track, Track other) {
    MotionModes standing = track.motion;
    MotionModes moving = other.motion;
    double wide = Math.max(track.line.halfWidthM, other.line.halfWidthM);
    return track.stands
        && Math.abs(moving.vy()) > 2 * VehicleEnds.STANDING_M_S
        && Math.abs(moving.x() - standing.x()) < wide
        && Math.abs(moving.y() - standing.y()) < SAME_EDGE_M;
  }

  /** Whether two tracks, whose lines are set, are on an upper and a lower line of one vehicle. */
  private boolean areOfOne(Track track, Track other, long timeUs) {
    if (track.sides.isOtherThan(other.sides)) {
      return false;
    }
    RoadLine line = other.line;
    double gapPx = track.line.rowNow() - line.rowNow();
    if (mayBeUpper(track, timeUs)
        && (other.updates >= SURE_UPDATES || !isFarAbove())
        && line.mayReach(gapPx)
        && upper.isAbove(lower, gapPx / line.halfPx())
        && isFilled()) {
      line.stretchTo(upper.behindM(lower));
      line.grounding.foundUpper();
      return true;
    }
    double perRow = road.distancePerY(Math.max(0, line.rowNow()));
    double filledM = (line.extentPx() + ROW_PX) * perRow + SAME_EDGE_M;
    double shortM = line.halfWidthM < NARROW_HALF_M ? NARROW_LENGTH_M : OTHER_EDGE_M;
    double mostM = Math.max(shortM, Math.min(LONGEST_M, filledM));
    if (gapPx > 0 && upper.isBehind(lower, mostM)) {
      line.stretchTo(upper.behindM(lower));
      return true;
    }
    return false;
  }
}
