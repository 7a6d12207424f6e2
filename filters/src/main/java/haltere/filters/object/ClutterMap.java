package haltere.filters.object;

import haltere.core.event.SensorGeometry;
import java.util.Arrays;
import java.util.List;

/**
 * Rates of the events that no object explains. Each pixel's rate has an exponential prior around
 * the mean of the picture, and its posterior is that of a Poisson process (Gamma-Poisson: Gelman et
 * al., Bayesian Data Analysis, 2013, eq. 2.14) with an exponential memory. Cells of 8 × 8 pixels
 * compare what came within the last 50 ms with what is usual there.
 *
 * <p>A flash or a flickering lamp raises all rates by one factor; it is the ratio of the picture's
 * present to its usual rate.
 *
 * <p>Thread rule: one thread at a time.
 */
final class ClutterMap {
  static final int CELL_SHIFT = 3;
  static final int CELL_PX = 1 << CELL_SHIFT;

  /** Memory of a pixel's rate, seconds: noise changes with light and temperature, slowly. */
  private static final double MEMORY_S = 5;

  /** Memory of a cell's excess, seconds: an edge at 100 px/s passes a cell within it. */
  static final double BIRTH_S = 0.05;

  /** Memory of a pixel's own last events, seconds; as long as a component's template lasts. */
  private static final double RECENT_S = ShapeTemplate.MEMORY_S;

  /** Winsorising: a cell counts at most this many times the mean, so that objects do not. */
  private static final double MAX_OF_MEAN = 3;

  /** Prior of a pixel's rate, Hz, as strong as half a second of data: a quiet sensor's noise. */
  private static final double PRIOR_HZ = 0.2;

  private static final double PRIOR_S = 0.5;

  /** Events of a quiet pixel within {@link #RECENT_S}, so that no ratio is unbounded. */
  private static final double QUIET_EVENTS = PRIOR_HZ * RECENT_S;

  /** Rate of false objects that noise alone may make, Hz: one in eleven days. */
  private static final double FALSE_ALARM_HZ = 1e-6;

  private static final double CELL_PIXELS = 1 << 2 * CELL_SHIFT;
  private static final int TABLE = 1024;

  final int columns;
  final int rows;
  private final float[] clutter;
  private final float[] recent;
  private final int[] touched;
  private final float[] excess;
  private final float[] background;
  private final float[] cellRecent;
  private final float[] keepTable = new float[TABLE];
  private final float[] keepRecentTable = new float[TABLE];
  private int tick;
  private double level;
  private double perTick;
  private double ticks;
  private double pixelFactor;
  private double cellFactor;

  ClutterMap(SensorGeometry geometry, ActivityGrid grid) {
    columns = (grid.columns + 1) >> 1;
    rows = (grid.rows + 1) >> 1;
    clutter = new float[grid.columns * grid.rows * ActivityGrid.TILE_PIXELS];
    recent = new float[clutter.length];
    touched = new int[grid.columns * grid.rows];
    excess = new float[columns * rows];
    background = new float[columns * rows];
    cellRecent = new float[columns * rows];
    for (int i = 0; i < TABLE; i++) {
      keepTable[i] = (float) Math.exp(-i * ObjectTracker.TICK_S / MEMORY_S);
      keepRecentTable[i] = (float) Math.exp(-i * ObjectTracker.TICK_S / RECENT_S);
    }
    reset();
  }

  void reset() {
    for (float[] values : List.of(clutter, recent, excess, background, cellRecent)) {
      Arrays.fill(values, 0);
    }
    Arrays.fill(touched, 0);
    tick = 0;
    ticks = 0;
    level = 1;
    perTick = PRIOR_HZ * ObjectTracker.TICK_S;
  }

  int cells() {
    return excess.length;
  }

  /**
   * Evidence from which noise makes {@link #FALSE_ALARM_HZ} false objects, nat: the log of the
   * number of tests, which is one for each cell in each {@link #BIRTH_S}, for each false alarm.
   */
  double alarmNat() {
    return Math.log(cells() / (BIRTH_S * FALSE_ALARM_HZ));
  }

  /** Cell of a pixel. */
  int cellAt(int x, int y) {
    return (y >> CELL_SHIFT) * columns + (x >> CELL_SHIFT);
  }

  /** Begins a tick; several have passed since the last if nothing happened. */
  void begin(int passed) {
    tick += passed;
    double keep = Math.exp(-passed * ObjectTracker.TICK_S / MEMORY_S);
    ticks = ticks * keep + (1 - keep) / (1 - keepTable[1]);
    float keepBackground = (float) keep;
    float keepExcess = (float) Math.exp(-passed * ObjectTracker.TICK_S / BIRTH_S);
    float keepRecent = (float) Math.exp(-passed * ObjectTracker.TICK_S / RECENT_S);
    for (int i = 0; i < excess.length; i++) {
      excess[i] *= keepExcess;
      background[i] *= keepBackground;
      cellRecent[i] *= keepRecent;
    }
    pixelFactor = level / (ticks + 1 / perTick);
  }

  /** Brings a tile's pixels to the present tick. */
  void touch(int tile) {
    int since = tick - touched[tile];
    if (since == 0) {
      return;
    }
    touched[tile] = tick;
    float keep = since < TABLE ? keepTable[since] : keepTable[TABLE - 1];
    float keepRecent = since < TABLE ? keepRecentTable[since] : 0;
    int first = tile * ActivityGrid.TILE_PIXELS;
    for (int i = first; i < first + ActivityGrid.TILE_PIXELS; i++) {
      clutter[i] *= keep;
      recent[i] *= keepRecent;
    }
  }

  /** Expected clutter of a pixel in this tick; its tile has been touched. */
  double rate(int tile, int pixel) {
    return pixelFactor * (clutter[tile * ActivityGrid.TILE_PIXELS + pixel] + 1);
  }

  /**
   * What a pixel would fire in this tick if its own and its neighbours' last events went on: of a
   * place that flickers, or of noise, this is what comes; of something that moves it is not.
   */
  double repeatRate(int tile, int pixel, int cell) {
    double own = recent[tile * ActivityGrid.TILE_PIXELS + pixel];
    double around = cellRecent[cell] / CELL_PIXELS;
    return (0.5 * (own + around) + QUIET_EVENTS) * ObjectTracker.TICK_S / RECENT_S;
  }

  /** Adds an event of which a share is clutter. */
  void add(int tile, int pixel, int cell, double share) {
    int i = tile * ActivityGrid.TILE_PIXELS + pixel;
    recent[i]++;
    clutter[i] += (float) share;
    cellRecent[cell]++;
    excess[cell] += (float) share;
    background[cell] += (float) share;
  }

  /** Estimates the picture's usual rate and its present factor. */
  void end() {
    double usual = winsorisedMean(background);
    double present = winsorisedMean(excess);
    double expected = usual / ticks * BIRTH_S / ObjectTracker.TICK_S;
    boolean isNew = ticks < BirthDetector.WINDOW;
    level = isNew ? 1 : Math.max(1, present / Math.max(expected, 1e-9));
    double priorTicks = PRIOR_S / ObjectTracker.TICK_S;
    double prior = PRIOR_HZ * PRIOR_S * CELL_PIXELS;
    perTick = (usual + prior) / (CELL_PIXELS * (ticks + priorTicks));
    cellFactor = level / (ticks + 1 / (CELL_PIXELS * perTick)) * BIRTH_S / ObjectTracker.TICK_S;
  }

  private static double winsorisedMean(float[] values) {
    double mean = 0;
    for (float value : values) {
      mean += value;
    }
    mean /= values.length;
    float most = (float) (MAX_OF_MEAN * mean);
    double sum = 0;
    for (float value : values) {
      sum += Math.min(value, most);
    }
    return sum / values.length;
  }

  /**
   * Log ratio of a cell's clutter of the last 50 ms under a rate of its own and under the usual
   * rate: Poisson's, n ln(n/μ) − (n − μ), 0 below the usual.
   */
  double surprise(int cell) {
    double mean = cellFactor * (background[cell] + 1);
    double n = excess[cell];
    return n > mean ? n * Math.log(n / mean) - (n - mean) : 0;
  }

  /** Whether a cell's {@link #surprise} may reach a value, by its bound (n − μ)² / μ. */
  boolean maySurprise(int cell, double nat) {
    double mean = cellFactor * (background[cell] + 1);
    double over = excess[cell] - mean;
    return over > 0 && over * over >= nat * mean;
  }

  /** Forgets the excess of a cell: a component takes it. */
  void clear(int cell) {
    excess[cell] = 0;
  }
}
