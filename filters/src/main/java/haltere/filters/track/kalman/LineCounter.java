package haltere.filters.track.kalman;

import haltere.filters.track.CountingLineSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.LineCrossing;
import haltere.filters.track.RoadMarks;
import haltere.filters.track.RoadTracksSettings;
import haltere.filters.track.motion.MotionModes;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/**
 * Counts vehicles on a road that cross lines. A track is on one side of a line once it is clear of
 * it by half a metre and twice its standard deviation, so that one that stands on a line is counted
 * once at most. It is counted where it goes to the other side on its way, and not again before it
 * has come back: what is followed may turn out to be another part of the vehicle.
 *
 * <p>It is counted once it is sure that it is a vehicle, and where: it has passed some rows, about
 * every second one of late, its lower edge is in the picture, and it is not far beside the lanes.
 * What was found beyond a line is counted if it was seen on its way from there ({@link WayBack}).
 * The time is always that at which the line was crossed. Two that would be at one place are one
 * ({@link RecentCrossings}).
 *
 * <p>Thread rule: that of its owner.
 */
final class LineCounter {
  private static final double CLEAR_M = 0.5;

  /** It is sure that something is a vehicle once so many rows were passed. */
  private static final int SURE_UPDATES = 4;

  /** What is found beyond a line is looked at for longer. */
  private static final int LATE_UPDATES = 7;

  /** A place that is less sure than this is that of no vehicle. */
  private static final double SURE_M = 2;

  /** A vehicle that is found late has been followed nearer than this by none. */
  private static final double LEAST_GAP_M = 4;

  /** So far beside the lanes with all its width nothing is on the road: it is higher. */
  private static final double VERGE_M = 0.5;

  /**
   * What is farther back on its way than it was by this, and twice what is not sure, was elsewhere.
   */
  private static final double BACK_M = 5;

  private final CountingLineSettings lines;
  private final LaneSettings lanes;
  private final Consumer<LineCrossing> crossings;

  /** For each line and, in it, each lane and beside the lanes: those that went away, then came. */
  private final long[][] counts;

  private final RecentCrossings[] recent;

  LineCounter(RoadTracksSettings settings, Consumer<LineCrossing> crossings) {
    lines = settings.countingLines();
    lanes = settings.lanes();
    this.crossings = crossings;
    counts = new long[lines.lines()][2 * (lanes.lanes() + 1)];
    recent = new RecentCrossings[lines.lines()];
    Arrays.setAll(recent, line -> new RecentCrossings());
  }

  /** The lines with how many have crossed them in all lanes. */
  List<RoadMarks.Line> lines() {
    List<RoadMarks.Line> all = new ArrayList<>(counts.length);
    for (int line = 0; line < counts.length; line++) {
      long away = 0;
      long towards = 0;
      for (int entry = 0; entry < counts[line].length; entry += 2) {
        away += counts[line][entry];
        towards += counts[line][entry + 1];
      }
      all.add(new RoadMarks.Line(lines.distanceM(line), away, towards));
    }
    return all;
  }

  /**
   * Looks at where a track is at a time.
   *
   * @param back tells where it has come from, or null if that cannot be told
   */
  void look(Track track, long timeUs, WayBack back) {
    if (lines.lines() == 0) {
      return;
    }
    MotionModes motion = track.at(timeUs);
    LineSides sides = track.sides;
    sides.setLines(lines.lines());
    double sd = Math.sqrt(motion.covariance(1, 1));
    boolean sure =
        !track.line.grounding.isHidden()
            && !track.line.grounding.isBeside()
            && (back == null || track.updates >= SURE_UPDATES && track.line.last.isFollowed())
            && sd < SURE_M;
    double clear = Math.max(CLEAR_M, 2 * sd);
    double vy = motion.vy();
    int way = vy * vy < motion.covariance(3, 3) ? 0 : vy > 0 ? 1 : -1;
    sides.follow(motion.y(), way, BACK_M + clear);
    for (int i = 0; i < lines.lines(); i++) {
      double beyond = motion.y() - lines.distanceM(i);
      if (Math.abs(beyond) < clear) {
        continue;
      }
      int side = beyond > 0 ? 1 : -1;
      boolean isBefore = sides.isNew(i) && side != way;
      if (sides.isAt(i, side)
          || !isBefore && (!sure || back != null && back.isOnOther(track, motion, timeUs))) {
        continue;
      }
      boolean isLate = sides.isNew(i) && side == way && back != null && sides.isOnItsWay();
      if (isLate && track.updates < LATE_UPDATES) {
        continue;
      }
      boolean hasCome = isLate && back.leadsTo(track, motion, lines.distanceM(i), timeUs);
      if (sides.cross(i, side, way, hasCome)) {
        count(i, track, motion, timeUs, isLate);
      }
    }
  }

  private void count(int line, Track track, MotionModes motion, long timeUs, boolean isLate) {
    double beyondM = motion.y() - lines.distanceM(line);
    boolean away = beyondM > 0;
    // Back along its way to the line, as far as it has one.
    double backS = beyondM / motion.vy();
    backS = backS > 0 && backS < 10 ? backS : 0;
    long crossedUs = timeUs - Math.round(backS * 1e6);
    double lateralM = motion.x() - motion.vx() * backS;
    double half = track.line.halfWidthM;
    double gapM = isLate ? LEAST_GAP_M : 0;
    if (isBeside(lateralM, half)) {
      return;
    }
    if (recent[line].contain(crossedUs, lateralM, away, motion.vy(), half, gapM)) {
      track.sides.refuse(line, away ? 1 : -1);
      return;
    }
    track.sides.count(line, away ? 1 : -1);
    recent[line].add(crossedUs, lateralM, away, motion.vy(), track.line);
    int lane = lanes.laneAt(lateralM);
    long[] row = counts[line];
    int entry = 2 * (lane + 1);
    row[entry + (away ? 0 : 1)]++;
    crossings.accept(
        new LineCrossing(
            crossedUs,
            track.id,
            lines.distanceM(line),
            away ? LineCrossing.Direction.AWAY : LineCrossing.Direction.TOWARDS,
            lane,
            RoadSpeed.kmH(motion),
            RoadSpeed.sdKmH(track, motion),
            row[entry],
            row[entry + 1]));
  }

  /** Whether nothing that is on the road can be there. */
  private boolean isBeside(double lateralM, double halfM) {
    double most = halfM + VERGE_M;
    return lanes.lanes() > 0
        && (lateralM < lanes.leftEdgeM() - most || lateralM > lanes.rightEdgeM() + most);
  }
}
