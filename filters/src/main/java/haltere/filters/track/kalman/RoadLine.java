package haltere.filters.track.kalman;

import haltere.filters.track.road.FoundLine;
import java.util.Arrays;

/**
 * The edge at which a vehicle meets the road nearest to the camera, as a line across the road: what
 * a track on a road knows of its vehicle beside place and velocity, and what a step shows of it.
 *
 * <p>Thread rule: that of its owner.
 */
final class RoadLine {
  private static final double US = 1e-6;

  /** Rows about the line that are looked at. */
  static final int ROWS = 16;

  /** Parts into which the width of a line is divided to see how much of it was seen. */
  private static final int CELLS = 64;

  private static final double SEEN_SHARE = 0.3;
  private static final int LEAST_CELLS = 2;

  /**
   * Of a line that is not wider, noise filters may leave a single pixel of a row, of which an edge
   * makes several events and noise one.
   */
  private static final double NARROW_PX = 4;

  /** Of a line that is not wider, some events of a row may be enough. */
  private static final double SMALL_PX = 8;

  /** So many rows a second pass that a single event is rather of the line than noise. */
  private static final double SINGLE_ROWS_S = 8;

  private static final double RECENT_US = 100_000;
  private static final double MOVING_EVENTS = 4;
  private static final double STANDING_EVENTS = 2;
  private static final double LOST_ROWS = 2.5;

  private static final double USUAL_LENGTH_M = 4.4;
  private static final double LONGEST_M = 12;
  private static final double SIDE_PX = 2;
  private static final double BORDER_PX = 3;
  private static final double LEAST_GATE_PX = 0.7;
  private static final double GATE_SIGMAS = 2.5;
  private static final double WIDEST_GATE_PX = 2.5;

  /** What belongs to a vehicle has no gap in its height larger than this, and a share of it. */
  private static final double GAP_PX = 2;

  private static final double GAP_SHARE = 0.15;
  private static final double REACH_SHARE = 2;
  private static final double REACH_PX = 6;
  private static final double GROWTH = 0.3;
  private static final double SHRINKAGE = 1e-3;
  private static final double WIDTH_GAIN = 0.05;

  /** The middles of n pixels in a row are those of a line that is wider by half a pixel a side. */
  private static final double HALF_PIXEL = 0.5;

  /** The same of a width that was only guessed, for the side of the picture seemed to cut it. */
  private static final double CUT_GAIN = 0.3;

  /** So much wider than what has been seen of it is a guess. */
  private static final double GUESSED = 1.2;

  private static final double COLUMN_VARIANCE = 0.1;

  /** Whether it is sure to be on the road. */
  final Grounding grounding = new Grounding();

  /** The row that was passed last. */
  final LastRow last = new LastRow();

  double halfWidthM;

  /** Half of the width that has been seen of it: the rest is guessed. */
  private double seenHalfM;

  private double lengthM;

  /** Since when it is this line that is followed. */
  private long sinceUs;

  private boolean on;
  private double extentPx;
  private long bodyUs;
  private double recent;

  // Where it is expected in the step.
  private long nowUs;
  private double rowNow;
  private double rowPerUs;
  private double columnNow;
  private double columnPerUs;
  private double lateralNow;
  private double endM;
  private double perColumnM;
  private double halfPx;
  private double visiblePx;
  private double ownPx;
  private double mostPx;
  private double gatePx;
  private boolean isCutLeft;
  private boolean isCutRight;
  private int lastColumnPx;

  // What was seen of it in each row in the step; columns count from the middle.
  private int firstRow;
  private final int[] seen = new int[ROWS];
  private final long[] cells = new long[ROWS];
  private final double[] sumColumn = new double[ROWS];
  private final double[] sumColumn2 = new double[ROWS];
  private final double[] sumAgeUs = new double[ROWS];
  private final double[] leftmost = new double[ROWS];
  private final double[] rightmost = new double[ROWS];

  /** Begins as a line that was found. */
  void begin(FoundLine found, long timeUs) {
    halfWidthM = found.halfWidthM();
    seenHalfM = found.seenHalfM();
    extentPx = 0;
    lengthM = USUAL_LENGTH_M;
    recent = 0;
    last.begin();
    bodyUs = timeUs;
    nowUs = timeUs;
    turnTo(found, timeUs);
  }

  /** Goes over to another line of the same vehicle, so far below. */
  void change(FoundLine found, double byPx, long timeUs) {
    halfWidthM = Math.max(halfWidthM, found.halfWidthM());
    seenHalfM = Math.max(seenHalfM, found.seenHalfM());
    extentPx = Math.max(0, extentPx + byPx);
    turnTo(found, timeUs);
  }

  private void turnTo(FoundLine found, long timeUs) {
    on = found.isOn();
    sinceUs = timeUs;
    last.turnTo(found, timeUs);
  }

  /** Works out where it is in a step from the prediction for its end. */
  void expect(Track track, MeasurementPlane plane, long timeUs, double metresPerColumn, int width) {
    track.look(timeUs);
    recent *= Math.exp((nowUs - timeUs) / RECENT_US);
    nowUs = timeUs;
    rowNow = plane.yPx;
    columnNow = plane.xPx;
    rowPerUs = plane.vyPxS * US;
    columnPerUs = plane.vxPxS * US;
    lateralNow = track.motion.x() + track.motion.vx() * (timeUs - track.stateUs) * US;
    perColumnM = metresPerColumn;
    halfPx = Math.max(1, halfWidthM / perColumnM);
    double left = Math.max(-0.5, columnNow - halfPx);
    double right = Math.min(width - 0.5, columnNow + halfPx);
    visiblePx = Math.max(1, Math.min(right - left, 2 * seenHalfM / perColumnM));
    isCutLeft = columnNow - halfPx < 1;
    isCutRight = columnNow + halfPx > width - 2;
    lastColumnPx = width - 1;
    plane.placeSpread(track.motion);
    double sd = Math.sqrt(plane.varianceYPx2);
    gatePx = Math.min(WIDEST_GATE_PX, LEAST_GATE_PX + GATE_SIGMAS * sd);
    firstRow = (int) Math.floor(rowNow) - ROWS / 2;
    Arrays.fill(seen, 0);
    Arrays.fill(cells, 0);
    Arrays.fill(sumColumn, 0);
    Arrays.fill(sumColumn2, 0);
    Arrays.fill(sumAgeUs, 0);
    Arrays.fill(leftmost, Double.POSITIVE_INFINITY);
    Arrays.fill(rightmost, Double.NEGATIVE_INFINITY);
  }

  /** Says up to where above the line all is of the vehicle, and may be, and where it ends. */
  void setOwn(double px, double newMostPx, double newEndM) {
    ownPx = px;
    mostPx = newMostPx;
    endM = newEndM;
  }

  /** Up to so far above the line all that is seen is of the vehicle, and of no other. */
  double ownPx() {
    return ownPx;
  }

  /**
   * How far above the line an event is, or NaN if it is beside the vehicle, upright or as flat as
   * what is so far away may be.
   */
  double above(
      long timeUs, int column, int row, double lateralM, double alongM, double rowPerColumnM) {
    double age = timeUs - nowUs;
    double upright = column - columnNow - columnPerUs * age;
    // What is farther away than the end of the vehicle is higher, and farther aside as well.
    double scale = Math.max(1, alongM / endM);
    double flat = (lateralM - scale * lateralNow) / rowPerColumnM;
    double flatHalf = scale * halfWidthM / rowPerColumnM;
    boolean beside =
        Math.min(upright - halfPx, flat - flatHalf) > SIDE_PX
            || Math.max(upright + halfPx, flat + flatHalf) < -SIDE_PX;
    return beside ? Double.NaN : row - rowNow - rowPerUs * age;
  }

  /** Whether an event so far above the line is on the vehicle. */
  boolean isOnVehicle(double abovePx) {
    return abovePx > -gatePx
        && abovePx < Math.min(mostPx, extentPx + GAP_PX + GAP_SHARE * extentPx);
  }

  /** Whether an event so far above the line may be on the line. */
  boolean isOnLine(double abovePx, boolean isOn) {
    return isOn == on && Math.abs(abovePx) < gatePx;
  }

  /** Takes an event on the line. */
  void takeLine(long timeUs, int column, int row) {
    int k = row - firstRow;
    if (k < 0 || k >= ROWS) {
      return;
    }
    double off = column - columnNow - columnPerUs * (timeUs - nowUs);
    double wide = 2 * (halfPx + SIDE_PX);
    int cell = (int) ((off / wide + 0.5) * Math.min(CELLS, wide));
    seen[k]++;
    cells[k] |= 1L << Math.max(0, Math.min(CELLS - 1, cell));
    sumColumn[k] += off;
    sumColumn2[k] += off * off;
    sumAgeUs[k] += timeUs - nowUs;
    leftmost[k] = Math.min(leftmost[k], off);
    rightmost[k] = Math.max(rightmost[k], off);
  }

  /** Takes note of an event on the vehicle, but not on the line. */
  void hear(long timeUs) {
    bodyUs = timeUs;
    recent++;
  }

  /** Learns how high the vehicle is from an event so far above the line. */
  void learnExtent(double abovePx) {
    double more = abovePx - extentPx;
    extentPx += more > 0 ? GROWTH * more : -SHRINKAGE * extentPx;
  }

  /** Takes note of another line of the vehicle, so far above. */
  void reachTo(double abovePx) {
    extentPx = Math.max(extentPx, abovePx);
  }

  /** Takes note of a part of the vehicle so far behind the line on the road. */
  void stretchTo(double alongM) {
    lengthM = Math.min(LONGEST_M, Math.max(lengthM, alongM));
  }

  /** How long the vehicle seems to be; at least as long as a car. */
  double lengthM() {
    return lengthM;
  }

  /** Whether there is something of the vehicle on most of the way to a line so far above. */
  boolean mayReach(double abovePx) {
    return abovePx < REACH_SHARE * extentPx + REACH_PX;
  }

  /** Whether the vehicle moves, but its line has not been seen for much too long. */
  boolean isLost() {
    return recent > MOVING_EVENTS && Math.abs(rowPerUs) * (nowUs - last.timeUs()) > LOST_ROWS;
  }

  /** Whether it is outside the picture. */
  boolean isOut() {
    return rowNow < 0 || columnNow + halfPx < 0 || columnNow - halfPx > lastColumnPx;
  }

  /** Whether nothing but noise is heard of the vehicle. */
  boolean isSilent() {
    return recent < STANDING_EVENTS;
  }

  int row(int k) {
    return firstRow + k;
  }

  /**
   * Whether something of the line was seen in the k-th row that is looked at. A row that it has
   * passed already is passed by another line.
   */
  boolean isPassed(int k) {
    boolean single = visiblePx < NARROW_PX && (seen[k] > 1 || Math.abs(rowPerS()) > SINGLE_ROWS_S);
    return last.isBefore(row(k))
        && Long.bitCount(cells[k]) >= (single ? 1 : LEAST_CELLS)
        && (visiblePx < SMALL_PX || !isDoubtful(k));
  }

  /** Whether so little of the line was seen in a row that it may be something else. */
  boolean isDoubtful(int k) {
    double wide = CELLS * Math.min(1, visiblePx / Math.max(CELLS, 2 * halfPx));
    return Long.bitCount(cells[k]) < Math.max(LEAST_CELLS, SEEN_SHARE * wide);
  }

  /** Mean time at which a row was passed. */
  long passedUs(int k) {
    return nowUs + Math.round(sumAgeUs[k] / seen[k]);
  }

  /** Column of the middle when a row was passed. */
  double column(int k) {
    double off = sumColumn[k] / seen[k];
    if (isCutLeft(k)) {
      off = rightmost[k] - halfPx;
    } else if (isCutRight(k)) {
      off = leftmost[k] + halfPx;
    }
    return columnNow + columnPerUs * sumAgeUs[k] / seen[k] + off;
  }

  double columnVariance(int k) {
    return halfPx * halfPx / 3 / Long.bitCount(cells[k]) + COLUMN_VARIANCE;
  }

  /** Whether all of the line has been seen. */
  boolean isWidthKnown() {
    return halfWidthM <= GUESSED * seenHalfM && !isCut();
  }

  /** Whether the side of the picture hides a part of the line. */
  boolean isCut() {
    return isCutLeft || isCutRight;
  }

  /** The same when a row was passed: what ends before the side of the picture is not cut there. */
  boolean isCut(int k) {
    return isCutLeft(k) || isCutRight(k);
  }

  private boolean isCutLeft(int k) {
    return isCutLeft && columnNow + leftmost[k] < BORDER_PX;
  }

  private boolean isCutRight(int k) {
    return isCutRight && columnNow + rightmost[k] > lastColumnPx - BORDER_PX;
  }

  /** Takes note of the row that was passed last. */
  void pass(int k, double column, double alongMS) {
    last.pass(row(k), passedUs(k), column, alongMS);
  }

  /** Learns the width from a row that was passed. */
  void learnWidth(int k) {
    if (Long.bitCount(cells[k]) < LEAST_CELLS) {
      return;
    }
    double mean = sumColumn[k] / seen[k];
    double variance = Math.max(0, sumColumn2[k] / seen[k] - mean * mean);
    double half = Math.sqrt(3 * variance + HALF_PIXEL * HALF_PIXEL) * perColumnM;
    boolean isGuess = isCut() || halfWidthM > GUESSED * seenHalfM;
    halfWidthM += (isGuess ? CUT_GAIN : WIDTH_GAIN) * (half - halfWidthM);
    seenHalfM = isGuess ? Math.max(seenHalfM, half) : halfWidthM;
  }

  /** Whether this vehicle is where the line of another is seen. */
  boolean isInFrontOf(RoadLine other) {
    return other.rowNow - rowNow < extentPx + GAP_PX
        && Math.abs(other.columnNow - columnNow) < halfPx + other.halfPx;
  }

  /** Polarity of its events. */
  boolean on() {
    return on;
  }

  /** How far above the line the vehicle is seen. */
  double extentPx() {
    return extentPx;
  }

  double halfPx() {
    return halfPx;
  }

  double rowNow() {
    return rowNow;
  }

  double rowPerS() {
    return rowPerUs / US;
  }

  /** Since when it is this line of the vehicle that is followed, and no other. */
  long sinceUs() {
    return sinceUs;
  }

  /** When an event was on the vehicle above the line. */
  long bodyUs() {
    return bodyUs;
  }
}
