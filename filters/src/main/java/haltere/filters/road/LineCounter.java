package haltere.filters.road;

import haltere.filters.plane.PlanePoint;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.Consumer;

/**
 * Counts tracks that cross lines of a road. A track is on a side of a line beyond two standard
 * deviations, and is counted when it reaches the other side. A track that starts beyond a line is
 * not counted there.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 */
public final class LineCounter implements Consumer<PlanePoint> {
  /** Distance beyond which the side of a line is known: 95 % of the errors are smaller. */
  private static final double CLEAR_SIGMAS = 2;

  /** Largest number of stored tracks; the least recent one is removed. */
  private static final int MAX_TRACKS = 1000;

  private final LaneSettings lanes;
  private final CountingLineSettings lines;
  private final Consumer<LineCrossing> crossings;

  /** For each line, and there for each lane and beside them: away, then towards. */
  private final long[][] counts;

  private final Map<Integer, Passage> passages = recent();

  /** The last position of a track and, for each line, its side and time at the line. */
  private static final class Passage {
    private PlanePoint last;
    private final int[] sides;
    private final long[] crossedUs;

    private Passage(PlanePoint first, int lines) {
      last = first;
      sides = new int[lines];
      crossedUs = new long[lines];
    }
  }

  /**
   * A counter in its initial state.
   *
   * @param lanes lanes in which crossings are counted separately
   * @param lines the counting lines
   * @param crossings receives each crossing, when the track is beyond the line
   */
  public LineCounter(
      LaneSettings lanes, CountingLineSettings lines, Consumer<LineCrossing> crossings) {
    this.lanes = Objects.requireNonNull(lanes, "lanes");
    this.lines = Objects.requireNonNull(lines, "lines");
    this.crossings = Objects.requireNonNull(crossings, "crossings");
    counts = new long[lines.lines()][2 * (lanes.lanes() + 1)];
  }

  /** A map by identities with a bounded number of recent entries. */
  static <V> Map<Integer, V> recent() {
    return new LinkedHashMap<>(16, 0.75f, true) {
      private static final long serialVersionUID = 1;

      @Override
      protected boolean removeEldestEntry(Map.Entry<Integer, V> eldest) {
        return size() > MAX_TRACKS;
      }
    };
  }

  /**
   * Processes the position of a track; those of one track ascend in time.
   *
   * @param point a position on the road
   */
  @Override
  public void accept(PlanePoint point) {
    Passage passage = passages.computeIfAbsent(point.id(), id -> new Passage(point, lines.lines()));
    for (int line = 0; line < lines.lines(); line++) {
      double beyondM = point.yM() - lines.distanceM(line);
      double beforeM = passage.last.yM() - lines.distanceM(line);
      if (beyondM > 0 != beforeM > 0) {
        double share = beforeM / (beforeM - beyondM);
        long sinceUs = point.timeUs() - passage.last.timeUs();
        passage.crossedUs[line] = passage.last.timeUs() + Math.round(share * sinceUs);
      }
      if (Math.abs(beyondM) > CLEAR_SIGMAS * point.sdYM()) {
        int side = beyondM > 0 ? 1 : -1;
        if (passage.sides[line] == -side) {
          count(point, line, side > 0, passage.crossedUs[line]);
        }
        passage.sides[line] = side;
      }
    }
    passage.last = point;
  }

  private void count(PlanePoint point, int line, boolean isAway, long crossedUs) {
    int lane = lanes.laneAt(point.xM());
    int entry = 2 * (lane + 1);
    counts[line][isAway ? entry : entry + 1]++;
    crossings.accept(
        new LineCrossing(
            crossedUs,
            point.id(),
            lines.distanceM(line),
            isAway ? LineCrossing.Direction.AWAY : LineCrossing.Direction.TOWARDS,
            lane,
            point.speedKmH(),
            point.sdSpeedKmH(),
            counts[line][entry],
            counts[line][entry + 1]));
  }
}
