package haltere.filters.track.road;

import java.util.Arrays;

/**
 * Finds the speed of a line across the road from its last way: from one piece of it, in one row at
 * one time, lines of all speeds are drawn back into the past, and the one on which most events lie
 * is taken, if they are of several rows. A row is passed at a moment that the events tell far
 * better than a pixel is wide, so three rows are enough.
 *
 * <p>Allocates nothing after its construction. Thread rule: not safe for use by two threads at a
 * time.
 */
public final class LineSearch {
  private static final double US = 1e-6;
  private static final int MOST_EVENTS = 512;
  private static final int ROWS = 64;

  /** Usual speed, for how long a line is looked back at. */
  private static final double USUAL_M_S = 16;

  /** Slow lines are looked back at for longer by this. */
  private static final double SLOW_FACTOR = 4;

  private static final double FASTEST_M_S = 70;
  private static final double ROWS_BACK = 5;
  private static final double SHORTEST_S = 0.08;
  private static final double LONGEST_S = 1;
  private static final double ON_LINE_PX = 0.4;
  private static final double BESIDE_M = 0.3;
  private static final int LEAST_ROWS = FoundLine.LEAST_ROWS;

  /** Half of the width of the narrowest line. */
  private static final double NARROWEST_M = 0.15;

  /** Half of the width of a vehicle that the side of the picture hides a part of. */
  private static final double USUAL_HALF_M = 0.9;

  /** The best speed has to have this many times the events of any that is not next to it. */
  private static final double CLEAR = 1.25;

  /**
   * Square of what a row may be off the line by, in standard deviations, on average: rows of
   * several lines that only look like one are off by more.
   */
  private static final double MOST_MISFIT = 6;

  /** Speeds that differ by less than this share are next to one another. */
  private static final double OTHER_SHARE = 0.2;

  private final RoadEvents events;
  private final FoundLine found = new FoundLine();
  private final double[] ageS = new double[MOST_EVENTS];
  private final double[] distance = new double[MOST_EVENTS];
  private final double[] tolerance = new double[MOST_EVENTS];
  private final long[] which = new long[MOST_EVENTS];
  private final int[] rowOf = new int[MOST_EVENTS];
  private int count;
  private final int width;

  private final int[] rowEvents = new int[ROWS];
  private final double[] rowAge = new double[ROWS];

  /**
   * A search that has found nothing.
   *
   * @param events to search in
   * @param width columns of the sensor
   */
  public LineSearch(RoadEvents events, int width) {
    this.events = events;
    this.width = width;
  }

  /**
   * Searches.
   *
   * @param seed the piece of a line, of events of the present step
   * @param nowUs the time of the step
   * @param sdPx how well an event tells where the line is
   * @return false if there is no line with a speed of its own
   */
  public boolean find(LineSeed seed, long nowUs, double sdPx) {
    double usualS = ROWS_BACK * events.metresPerRow(seed.row) / USUAL_M_S;
    double backS = Math.max(SHORTEST_S, Math.min(LONGEST_S, usualS));
    double slowBackS = Math.min(LONGEST_S, SLOW_FACTOR * usualS);
    return find(seed, nowUs, sdPx, backS)
        || slowBackS > backS && find(seed, nowUs, sdPx, slowBackS);
  }

  private boolean find(LineSeed seed, long nowUs, double sdPx, double backS) {
    int seedRow = seed.row;
    double seedM = events.distanceM(seedRow);
    gather(seed, nowUs, backS);
    double stepMS = ON_LINE_PX * events.metresPerRow(seedRow) / backS;
    double speed = bestSpeed(seedM, seed.ageS, seedRow, stepMS);
    if (Double.isNaN(speed)) {
      return false;
    }
    found.isOn = seed.on;
    found.lastRow = seedRow;
    found.lastColumn = seed.column;
    return refine(seedM - speed * seed.ageS, speed, seedRow, sdPx)
        && refine(found.yM, found.vyMS, seedRow, sdPx)
        && measureAcross();
  }

  private void gather(LineSeed seed, long nowUs, double backS) {
    count = 0;
    double seedM = events.distanceM(seed.row);
    double reach = FASTEST_M_S * backS;
    long sinceUs = nowUs - Math.round(backS * 1e6);
    double half = seed.halfWidthM + BESIDE_M;
    for (long i = events.to() - 1; events.isRemembered(i, sinceUs) && count < MOST_EVENTS; i--) {
      if (events.isTaken(i) || events.isOn(i) != seed.on) {
        continue;
      }
      int row = events.row(i);
      double d = events.distanceM(row);
      if (Math.abs(d - seedM) < reach
          && Math.abs(row - seed.row) < ROWS / 2
          && Math.abs(events.lateralM(events.column(i), row) - seed.xM) < half) {
        ageS[count] = (events.timeUs(i) - nowUs) * US;
        distance[count] = d;
        tolerance[count] = ON_LINE_PX * events.metresPerRow(row);
        rowOf[count] = row;
        which[count++] = i;
      }
    }
  }

  private double bestSpeed(double seedM, double seedAgeS, int seedRow, double stepMS) {
    int steps = (int) Math.min(600, Math.ceil(FASTEST_M_S / stepMS));
    double best = Double.NaN;
    int most = 0;
    int second = 0;
    int bestStep = 0;
    for (int k = -steps; k <= steps; k++) {
      double speed = k * stepMS;
      int hits = 0;
      long rows = 0;
      for (int i = 0; i < count; i++) {
        if (Math.abs(distance[i] - seedM - speed * (ageS[i] - seedAgeS)) < tolerance[i]) {
          hits++;
          rows |= 1L << (rowOf[i] & (ROWS - 1));
        }
      }
      if (!isUnbroken(rows, seedRow, speed < 0)) {
        continue;
      }
      boolean isOther = k - bestStep > 3 + OTHER_SHARE * Math.abs(bestStep);
      if (hits > most) {
        second = isOther ? Math.max(most, second) : second;
        most = hits;
        best = speed;
        bestStep = k;
      } else if (isOther) {
        second = Math.max(second, hits);
      }
    }
    return most > CLEAR * second ? best : Double.NaN;
  }

  /** Whether the line has passed the seed's row and those before, none left out. */
  private static boolean isUnbroken(long rows, int seedRow, boolean down) {
    for (int back = 0; back < LEAST_ROWS; back++) {
      int row = down ? seedRow + back : seedRow - back;
      if ((rows >> (row & ROWS - 1) & 1) == 0) {
        return false;
      }
    }
    return true;
  }

  /** Least squares over the rows, each at the mean time of its events. */
  private boolean refine(double fromM, double speed, int seedRow, double sdPx) {
    Arrays.fill(rowEvents, 0);
    Arrays.fill(rowAge, 0);
    for (int i = 0; i < count; i++) {
      if (Math.abs(distance[i] - fromM - speed * ageS[i]) < tolerance[i]) {
        int k = rowOf[i] - seedRow + ROWS / 2;
        rowEvents[k]++;
        rowAge[k] += ageS[i];
      }
    }
    double w = 0;
    double wt = 0;
    double wtt = 0;
    double wy = 0;
    double wty = 0;
    int rows = 0;
    for (int k = 0; k < ROWS; k++) {
      if (rowEvents[k] < 2) {
        continue;
      }
      rows++;
      int row = k + seedRow - ROWS / 2;
      double sd = sdPx * events.metresPerRow(row);
      double weight = 1 / (sd * sd);
      double t = rowAge[k] / rowEvents[k];
      double y = events.distanceM(row);
      w += weight;
      wt += weight * t;
      wtt += weight * t * t;
      wy += weight * y;
      wty += weight * t * y;
    }
    double determinant = w * wtt - wt * wt;
    if (rows < LEAST_ROWS || !(determinant > 0)) {
      return false;
    }
    found.rows = rows;
    found.yM = (wtt * wy - wt * wty) / determinant;
    found.vyMS = (w * wty - wt * wy) / determinant;
    found.varianceY = wtt / determinant;
    found.varianceVy = w / determinant;
    found.covarianceYvy = -wt / determinant;
    return misfit(seedRow, sdPx) <= MOST_MISFIT * (rows - 2);
  }

  /** Squares of what the rows are off the line by, in standard deviations. */
  private double misfit(int seedRow, double sdPx) {
    double misfit = 0;
    for (int k = 0; k < ROWS; k++) {
      if (rowEvents[k] >= 2) {
        int row = k + seedRow - ROWS / 2;
        double ageS = rowAge[k] / rowEvents[k];
        double off = events.distanceM(row) - found.yM - found.vyMS * ageS;
        double sds = off / (sdPx * events.metresPerRow(row));
        misfit += sds * sds;
      }
    }
    return misfit;
  }

  private boolean measureAcross() {
    double sum = 0;
    double squares = 0;
    int n = 0;
    for (int i = 0; i < count; i++) {
      if (isOnLine(i)) {
        double x = events.lateralM(events.column(which[i]), rowOf[i]);
        sum += x;
        squares += x * x;
        n++;
      }
    }
    if (n < 2 * LEAST_ROWS) {
      return false;
    }
    double xM = sum / n;
    double halfWidthM = Math.sqrt(3 * Math.max(0, squares / n - xM * xM));
    double left = events.lateralM(1, found.lastRow);
    double right = events.lateralM(width - 2, found.lastRow);
    boolean isCutLeft = xM - halfWidthM < left;
    boolean isCutRight = xM + halfWidthM > right;
    found.isCut = isCutLeft || isCutRight;
    double hidden = isCutLeft == isCutRight ? 0 : Math.max(0, USUAL_HALF_M - halfWidthM);
    found.seenHalfM = halfWidthM;
    found.xM = xM + (isCutLeft ? -hidden : hidden);
    found.halfWidthM = halfWidthM + hidden;
    return found.halfWidthM > NARROWEST_M;
  }

  /** Whether one of the gathered events is on the line that was found. */
  private boolean isOnLine(int i) {
    return Math.abs(distance[i] - found.yM - found.vyMS * ageS[i]) < tolerance[i];
  }

  /**
   * What was found last.
   *
   * @return the same for all searches, written by each
   */
  public FoundLine found() {
    return found;
  }

  /**
   * Says that the events of what was found belong to a vehicle.
   *
   * @param serial the number of the vehicle, not 0
   */
  public void take(int serial) {
    for (int i = 0; i < count; i++) {
      if (isOnLine(i)) {
        events.take(which[i], serial);
      }
    }
  }
}
