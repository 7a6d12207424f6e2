package haltere.filters.object;

import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Rates of clutter. The rate of each pixel has an exponential prior around the mean of the picture
 * and the posterior of a Poisson process (Gamma-Poisson: Gelman et al., Bayesian Data Analysis,
 * 2013, eq. 2.14), with an exponential memory. Cells of 8 × 8 pixels compare the events of the last
 * 50 ms with their usual number.
 *
 * <p>A flash or a flickering lamp increases all rates by one factor, the ratio of the present to
 * the usual rate of the picture.
 */
final class ClutterMap {
  static final int CELL_SHIFT = 3;
  static final int CELL_PX = 1 << CELL_SHIFT;

  /** Memory of a pixel's rate, seconds: noise changes with light and temperature, slowly. */
  private static final double MEMORY_S = 5;

  /** Memory of a cell's excess, seconds: an edge at 100 px/s passes a cell within it. */
  static final double BIRTH_S = 0.05;

  /**
   * Memory of the last events of a pixel, seconds. A template has the positions of its own memory;
   * those at rest are told by positions from before it.
   */
  private static final double RECENT_S = 2 * ShapeTemplate.MEMORY_S;

  /** Winsorising: a cell counts at most this many times the mean, because of objects. */
  private static final double MAX_OF_MEAN = 3;

  /** Prior of a pixel's rate, Hz, as strong as half a second of data: a quiet sensor's noise. */
  private static final double PRIOR_HZ = 0.2;

  private static final double PRIOR_S = 0.5;

  /** Events of a quiet pixel within {@link #RECENT_S}, so that no ratio is unbounded. */
  private static final double QUIET_EVENTS = PRIOR_HZ * RECENT_S;

  /** Rate of false objects by noise, Hz: one in eleven days. */
  private static final double FALSE_ALARM_HZ = 1e-6;

  private static final double CELL_PIXELS = 1 << 2 * CELL_SHIFT;

  /** Growth of the weights of pixels until all are rescaled: half the decades of a float. */
  private static final double MAX_GAIN = 1e19;

  private static final int HALF = (1 << Short.SIZE) - 1;

  final int columns;
  final int rows;
  final int cells;

  /**
   * For each pixel its clutter times its gain in the upper half, and all its events times theirs in
   * the lower half: two floats of 16 bits, which round a count by less than 0.4 %.
   */
  private final int[] pixels;

  private final float[] excess;
  private final float[] background;
  private final float[] cellRecent;
  private double gain;
  private double perGain;
  private double recentGain;
  private double perRecentGain;
  private double allBackground;
  private double allExcess;
  private double level;
  private double perTick;
  private double ticks;
  private double recentTicks;
  private double maxSteady;
  private double pixelFactor;
  private double cellFactor;

  ClutterMap(SensorGeometry geometry, ActivityGrid grid) {
    columns = (geometry.width() - 1 >> CELL_SHIFT) + 1;
    rows = (geometry.height() - 1 >> CELL_SHIFT) + 1;
    pixels = new int[grid.tiles() * ActivityGrid.TILE_PIXELS];
    cells = columns * rows;
    excess = new float[cells];
    background = new float[cells];
    cellRecent = new float[cells];
    reset();
  }

  void reset() {
    Arrays.fill(pixels, 0);
    Arrays.fill(excess, 0);
    Arrays.fill(background, 0);
    Arrays.fill(cellRecent, 0);
    allBackground = 0;
    allExcess = 0;
    gain = 1;
    recentGain = 1;
    ticks = 0;
    recentTicks = 0;
    level = 1;
    perTick = PRIOR_HZ * ObjectTracker.TICK_S;
  }

  /**
   * Evidence at which noise makes {@link #FALSE_ALARM_HZ} false objects, nat: the logarithm of the
   * number of tests, one for each cell in each {@link #BIRTH_S}, per false alarm.
   */
  double alarmNat() {
    return Math.log(cells / (BIRTH_S * FALSE_ALARM_HZ));
  }

  /** Cell of a pixel. */
  int cellAt(int x, int y) {
    return (y >> CELL_SHIFT) * columns + (x >> CELL_SHIFT);
  }

  /** Starts a tick, after a number of ticks since the last one. */
  void begin(int passed) {
    double keep = keep(passed, MEMORY_S);
    ticks = ticks * keep + (1 - keep) / (1 - keep(1, MEMORY_S));
    double keepRecent = keep(passed, RECENT_S);
    recentTicks = recentTicks * keepRecent + (1 - keepRecent) / (1 - keep(1, RECENT_S));
    float keepBackground = (float) keep;
    float keepExcess = (float) keep(passed, BIRTH_S);
    for (int i = 0; i < cells; i++) {
      excess[i] *= keepExcess;
      background[i] *= keepBackground;
      cellRecent[i] *= (float) keepRecent;
    }
    allBackground *= keepBackground;
    allExcess *= keepExcess;
    grow(keep, keepRecent);
    maxSteady = 0.5 * (recentTicks + ShapeTemplate.MEMORY_S / ObjectTracker.TICK_S) * recentGain;
    pixelFactor = level / (ticks + 1 / perTick);
  }

  private static double keep(int passed, double memoryS) {
    return Math.exp(-passed * ObjectTracker.TICK_S / memoryS);
  }

  /** Increases the weight of new events, instead of decreasing that of all old ones. */
  private void grow(double keep, double keepRecent) {
    gain /= keep;
    recentGain /= keepRecent;
    if (Math.max(gain, recentGain) > MAX_GAIN) {
      float scale = (float) (1 / gain);
      float recentScale = (float) (1 / recentGain);
      for (int i = 0; i < pixels.length; i++) {
        pixels[i] = pack(clutter(pixels[i]) * scale, recent(pixels[i]) * recentScale);
      }
      gain = 1;
      recentGain = 1;
    }
    perGain = 1 / gain;
    perRecentGain = 1 / recentGain;
  }

  /** Expected clutter of a pixel in this tick. */
  double rate(int tile, int pixel) {
    return pixelFactor * (clutter(pixels[tile * ActivityGrid.TILE_PIXELS + pixel]) * perGain + 1);
  }

  /** Whether a pixel fired in most ticks: a mean above ½ after a template's memory of silence. */
  boolean isFlickering(int tile, int pixel) {
    return recent(pixels[tile * ActivityGrid.TILE_PIXELS + pixel]) > maxSteady;
  }

  /** Expected events of a pixel if its last ones and its neighbours' repeat, as flicker does. */
  double repeatRate(int tile, int pixel, int cell) {
    double own = recent(pixels[tile * ActivityGrid.TILE_PIXELS + pixel]) * perRecentGain;
    double around = cellRecent[cell] / CELL_PIXELS;
    return (0.5 * (own + around) + QUIET_EVENTS) * ObjectTracker.TICK_S / RECENT_S;
  }

  private static float clutter(int pixel) {
    return Float.intBitsToFloat(pixel & ~HALF);
  }

  private static float recent(int pixel) {
    return Float.intBitsToFloat(pixel << Short.SIZE);
  }

  private static int pack(float clutter, float recent) {
    return upperHalf(clutter) | upperHalf(recent) >>> Short.SIZE;
  }

  /** Bits of a float, rounded to the upper half of them. */
  private static int upperHalf(float value) {
    return Float.floatToRawIntBits(value) + (HALF + 1 >> 1) & ~HALF;
  }

  /** Adds an event of which a share is clutter. */
  void add(int tile, int pixel, int cell, double share) {
    int i = tile * ActivityGrid.TILE_PIXELS + pixel;
    int known = pixels[i];
    pixels[i] = pack(clutter(known) + (float) (share * gain), recent(known) + (float) recentGain);
    cellRecent[cell]++;
    excess[cell] += (float) share;
    background[cell] += (float) share;
    allExcess += share;
    allBackground += share;
  }

  /** Estimates the usual rate of the picture and its present factor. */
  void end() {
    float maxUsual = (float) (MAX_OF_MEAN * allBackground / cells);
    float maxPresent = (float) (MAX_OF_MEAN * allExcess / cells);
    double usual = 0;
    double present = 0;
    for (int i = 0; i < cells; i++) {
      usual += background[i] < maxUsual ? background[i] : maxUsual;
      present += excess[i] < maxPresent ? excess[i] : maxPresent;
    }
    usual /= cells;
    present /= cells;
    double expected = usual / ticks * BIRTH_S / ObjectTracker.TICK_S;
    level = ticks < BirthDetector.WINDOW ? 1 : Math.max(1, present / Math.max(expected, 1e-9));
    double prior = PRIOR_HZ * PRIOR_S * CELL_PIXELS;
    perTick = (usual + prior) / (CELL_PIXELS * (ticks + PRIOR_S / ObjectTracker.TICK_S));
    cellFactor = level / (ticks + 1 / (CELL_PIXELS * perTick)) * BIRTH_S / ObjectTracker.TICK_S;
  }

  /**
   * Log ratio of the clutter of a cell within the last 50 ms under its own and under the usual
   * rate, n ln(n/μ) − (n − μ) (Poisson), 0 below the usual.
   */
  double logRatio(int cell) {
    double mean = cellFactor * (background[cell] + 1);
    double n = excess[cell];
    return n > mean ? n * Math.log(n / mean) - (n - mean) : 0;
  }

  /** Whether a cell's {@link #logRatio} reaches a value; its bound (n − μ)² / μ costs less. */
  boolean isExcess(int cell, double nat) {
    double mean = cellFactor * (background[cell] + 1);
    double over = excess[cell] - mean;
    // the rarer one first: most cells fail it, and half of them are over the mean
    return over * over >= nat * mean && over > 0 && logRatio(cell) >= nat;
  }

  /** Removes the excess of a cell, which a component explains. */
  void clear(int cell) {
    allExcess -= excess[cell];
    excess[cell] = 0;
  }
}
