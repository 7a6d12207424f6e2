package haltere.filters.track.kalman;

import haltere.filters.track.CountingLineSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.LineCrossing;
import haltere.filters.track.RoadMarks;
import haltere.filters.track.RoadTracksSettings;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * Counts tracks on a road that cross lines. A track is on one side of a line once it is clear of it
 * by half a metre and twice its standard deviation, so that one that stands on a line is counted
 * once at most. It is counted where it goes to the other side on its way, and not again before it
 * has come back: what is followed may turn out to be another part of the vehicle. A vehicle whose
 * lower edge may be outside the picture is counted when it is known where it is.
 *
 * <p>Thread rule: that of its owner.
 */
final class LineCounter {
  private static final double CLEAR_M = 0.5;

  private final CountingLineSettings lines;
  private final LaneSettings lanes;
  private final Consumer<LineCrossing> crossings;

  /** For each line and, in it, each lane and beside the lanes: those that went away, then came. */
  private final long[][] counts;

  LineCounter(RoadTracksSettings settings, Consumer<LineCrossing> crossings) {
    lines = settings.countingLines();
    lanes = settings.lanes();
    this.crossings = crossings;
    counts = new long[lines.lines()][2 * (lanes.lanes() + 1)];
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

  /** Looks at a track after an update. */
  void look(Track track) {
    if (lines.lines() == 0) {
      return;
    }
    MotionModes motion = track.motion;
    LineSides sides = track.sides;
    sides.setLines(lines.lines());
    boolean mayCount = !track.line.grounding.isHidden();
    double clear = Math.max(CLEAR_M, 2 * Math.sqrt(motion.covariance(1, 1)));
    double vy = motion.vy();
    int way = vy * vy < motion.covariance(3, 3) ? 0 : vy > 0 ? 1 : -1;
    for (int i = 0; i < lines.lines(); i++) {
      double beyond = motion.y() - lines.distanceM(i);
      if (Math.abs(beyond) >= clear
          && (mayCount || sides.isNew(i))
          && sides.cross(i, beyond > 0 ? 1 : -1, way)) {
        count(i, track, beyond);
      }
    }
  }

  private void count(int line, Track track, double beyondM) {
    MotionModes motion = track.motion;
    boolean away = beyondM > 0;
    // Back along its way to the line, as far as it has one.
    double backS = beyondM / motion.vy();
    backS = backS > 0 && backS < 10 ? backS : 0;
    double lateralM = motion.x() - motion.vx() * backS;
    int lane = lanes.laneAt(lateralM);
    long[] row = counts[line];
    int entry = 2 * (lane + 1);
    row[entry + (away ? 0 : 1)]++;
    crossings.accept(
        new LineCrossing(
            track.stateUs - Math.round(backS * 1e6),
            track.id,
            lines.distanceM(line),
            away ? LineCrossing.Direction.AWAY : LineCrossing.Direction.TOWARDS,
            lane,
            RoadSpeed.kmH(motion),
            RoadSpeed.sdKmH(track, motion),
            row[entry],
            row[entry + 1]));
  }
}
