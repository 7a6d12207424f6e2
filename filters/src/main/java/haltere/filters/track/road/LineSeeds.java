package haltere.filters.track.road;

import java.util.Arrays;

/**
 * The pieces of lines across the road that a step shows: runs of events of one row and polarity
 * that belong to no vehicle yet, the longest first.
 *
 * <p>Allocates nothing after its construction. Thread rule: not safe for use by two threads at a
 * time.
 */
public final class LineSeeds {
  private static final double US = 1e-6;
  private static final int MOST = 4;

  /** So many columns are a piece of a line; fewer may be one of a vehicle that is known. */
  private static final int SURE_COLUMNS = 3;

  private static final int LEAST_COLUMNS = 2;
  private static final int LEAST_EVENTS = 3;
  private static final int WIDEST_GAP = 2;
  private static final double WIDEST_M = 4;

  /** Where a row sees more of the road than any vehicle is long, its edges are not told apart. */
  private static final double MOST_ROW_M = 15;

  /** So far beside a piece of a line nothing else of its row is passed at the same time. */
  private static final double BESIDE_M = 3;

  private static final double PIECE_SHARE = 0.4;

  private final RoadEvents events;
  private final int[] inRow;
  private boolean[] columns;
  private final LineSeed[] seeds = new LineSeed[MOST];
  private int count;

  /**
   * None found so far.
   *
   * @param events to look at
   * @param width columns of the sensor
   */
  public LineSeeds(RoadEvents events, int width) {
    this.events = events;
    inRow = new int[2 * events.rows()];
    columns = new boolean[width + WIDEST_GAP + 1];
    for (int i = 0; i < MOST; i++) {
      seeds[i] = new LineSeed();
    }
  }

  /**
   * Finds those of the present step.
   *
   * @param nowUs the time of the step
   * @return how many there are
   */
  public int find(long nowUs) {
    count = 0;
    Arrays.fill(inRow, 0);
    for (long i = events.from(); i < events.to(); i++) {
      if (!events.isTaken(i)) {
        inRow[key(i)]++;
      }
    }
    for (int key = 0; key < inRow.length; key++) {
      if (inRow[key] >= LEAST_EVENTS && events.metresPerRow(key / 2) < MOST_ROW_M) {
        look(key, nowUs);
      }
    }
    return count;
  }

  /**
   * One of them.
   *
   * @param index from 0 on, the longest first
   * @return as it is until the next step
   */
  public LineSeed get(int index) {
    return seeds[index];
  }

  /**
   * Whether one is so large a piece that there may be a vehicle of which nothing else is known.
   *
   * @param index from 0 on
   * @return true if so
   */
  public boolean isSure(int index) {
    return seeds[index].columns >= SURE_COLUMNS;
  }

  private int key(long event) {
    return 2 * events.row(event) + (events.isOn(event) ? 1 : 0);
  }

  private void look(int key, long nowUs) {
    Arrays.fill(columns, false);
    for (long i = events.from(); i < events.to(); i++) {
      if (!events.isTaken(i) && key(i) == key) {
        columns[events.column(i)] = true;
      }
    }
    int bestFrom = 0;
    int bestTo = 0;
    int best = 0;
    int from = 0;
    int last = -1;
    int run = 0;
    for (int c = 0; c < columns.length; c++) {
      if (columns[c]) {
        if (run == 0) {
          from = c;
        }
        run++;
        last = c;
        if (run > best) {
          best = run;
          bestFrom = from;
          bestTo = c;
        }
      } else if (run > 0 && c - last > WIDEST_GAP) {
        run = 0;
      }
    }
    if (best >= LEAST_COLUMNS && !isPiece(key / 2, bestFrom, bestTo, best)) {
      keep(key, bestFrom, bestTo, best, nowUs);
    }
  }

  /** Whether so much more of the row was passed at the same time that it is of something wider. */
  private boolean isPiece(int row, int from, int to, int run) {
    int beside = (int) Math.ceil(BESIDE_M / events.metresPerColumn(row));
    int more = 0;
    for (int c = Math.max(0, from - beside); c < Math.min(columns.length, to + beside + 1); c++) {
      more += columns[c] && (c < from || c > to) ? 1 : 0;
    }
    return more > PIECE_SHARE * run;
  }

  private void keep(int key, int from, int to, int run, long nowUs) {
    int row = key / 2;
    double half = 0.5 * (to - from + 1) * events.metresPerColumn(row);
    if (2 * half > WIDEST_M) {
      return;
    }
    int place = count;
    while (place > 0 && seeds[place - 1].columns < run) {
      place--;
    }
    if (place == MOST) {
      return;
    }
    count = Math.min(MOST, count + 1);
    LineSeed seed = seeds[count - 1];
    System.arraycopy(seeds, place, seeds, place + 1, count - 1 - place);
    seeds[place] = seed;
    double sum = 0;
    int n = 0;
    for (long i = events.from(); i < events.to(); i++) {
      int column = events.column(i);
      if (!events.isTaken(i) && key(i) == key && column >= from && column <= to) {
        sum += events.timeUs(i) - nowUs;
        n++;
      }
    }
    seed.row = row;
    seed.column = 0.5 * (from + to);
    seed.on = (key & 1) == 1;
    seed.columns = run;
    seed.ageS = sum / n * US;
    seed.xM = events.lateralM(0.5 * (from + to), row);
    seed.halfWidthM = half;
  }
}
