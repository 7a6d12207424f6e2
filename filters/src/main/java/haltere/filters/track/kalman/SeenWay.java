package haltere.filters.track.kalman;

import haltere.filters.track.RoadMapping;
import haltere.filters.track.motion.MotionModes;
import haltere.filters.track.road.RoadEvents;
import java.util.Arrays;

/**
 * Looks at the events on the way of a vehicle before it was found. It is followed back from where
 * it is known, along a straight line in space and time, to a counting line behind it: if it was
 * there, its events are in the rows that it has passed since, about where it was then. They are
 * compared with what there is beside it in the same rows at the same time (a likelihood ratio of
 * Poisson processes, as in tracking before detection), so that noise is no way. Events that belong
 * to another vehicle do not tell of this one: a vehicle that was lost and found again has not come
 * anew.
 *
 * <p>Thread rule: that of its owner.
 */
final class SeenWay {
  private static final double US = 1e-6;
  private static final double LONGEST_S = 2;

  /** What is wider than twice this would have been found before. */
  private static final double LARGEST_HALF_PX = 8;

  /** Rows below and above the edge in which its events are looked for. */
  private static final double BELOW_PX = 1;

  private static final double ABOVE_PX = 2.5;
  private static final double BESIDE_M = 0.3;

  /** Events that are expected beside the way at least. */
  private static final double LEAST_EXPECTED = 0.5;

  /** Logarithm of how much likelier a vehicle is than what is beside it. */
  private static final double SURE = 8;

  /** Share of the rows in which there has to be something. */
  private static final double FILLED_SHARE = 0.5;

  private final RoadMapping road;
  private final RoadEvents events;
  private final boolean[] filled;

  SeenWay(RoadMapping road, RoadEvents events) {
    this.road = road;
    this.events = events;
    filled = new boolean[events.rows()];
  }

  /** Whether a vehicle that was found beyond a line was seen on its way from the line on. */
  boolean leadsTo(Track track, MotionModes motion, double lineM, long timeUs) {
    double speed = motion.vy();
    double goneS = (motion.y() - lineM) / speed;
    double foundS = Math.max(0, (timeUs - track.bornUs) * US);
    double foundM = motion.y() - speed * foundS;
    if (!(goneS >= 0 && goneS < LONGEST_S) || halfPx(track, foundM) > LARGEST_HALF_PX) {
      return false;
    }
    double from = road.rowOf(lineM);
    double to = road.rowOf(motion.y() - speed * Math.min(foundS, goneS));
    int low = Math.max(0, (int) Math.ceil(Math.min(from, to)));
    int high = Math.min(filled.length - 1, (int) Math.floor(Math.max(from, to)));
    return high < low || isSeen(track, motion, timeUs, goneS, low, high);
  }

  private double halfPx(Track track, double alongM) {
    double away = Math.hypot(road.settings().bridgeHeightM(), alongM);
    return track.line.halfWidthM / (away * road.pixelAngle());
  }

  private boolean isSeen(
      Track track, MotionModes motion, long timeUs, double goneS, int low, int high) {
    Arrays.fill(filled, low, high + 1, false);
    double half = track.line.halfWidthM + BESIDE_M;
    int on = 0;
    int beside = 0;
    int rows = 0;
    double columns = 0;
    long sinceUs = timeUs - Math.round(goneS * 1e6);
    for (long i = events.to() - 1; events.isKept(i, sinceUs); i--) {
      int row = events.row(i);
      if (row < low || row > high || events.isOfOther(i, track.serial)) {
        continue;
      }
      double ageS = (events.timeUs(i) - timeUs) * US;
      double above = row - road.rowOf(motion.y() + motion.vy() * ageS);
      double aside = events.lateralM(events.column(i), row) - motion.x() - motion.vx() * ageS;
      if (Math.abs(aside) > half) {
        beside++;
      } else if (above > -BELOW_PX && above < ABOVE_PX) {
        on++;
        columns += 2 * half / events.metresPerColumn(row);
        rows += filled[row] ? 0 : 1;
        filled[row] = true;
      }
    }
    return rows >= FILLED_SHARE * (high - low + 1)
        && ratio(on, beside * share(on == 0 ? 0 : columns / on, high - low + 1)) > SURE;
  }

  /** The share of what is beside the way in its rows that is expected on it by chance. */
  private double share(double columns, int rows) {
    double rowsOn = Math.min(rows, BELOW_PX + ABOVE_PX);
    return columns / Math.max(1, events.columns() - columns) * rowsOn / rows;
  }

  private static double ratio(int seen, double expected) {
    double chance = Math.max(LEAST_EXPECTED, expected);
    return seen > chance ? seen * Math.log(seen / chance) - (seen - chance) : 0;
  }
}
