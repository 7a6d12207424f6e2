package haltere.filters.noise;

import haltere.core.event.EventAddress;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;

/**
 * Chooses the correlation time from the noise of the last seconds.
 *
 * <p>Noise is a Poisson process of rate λ in each pixel. At least k of n = 8 neighbours fired
 * within T with probability P(T) = 1 − Σ (i &lt; k) C(n, i) qⁱ (1 − q)ⁿ⁻ⁱ, q = 1 − exp(−λT): the
 * share of noise that passes. For k = 1 it is 1 − exp(−8λT), by the superposition of Poisson
 * processes (Kingman, "Poisson Processes", 1993, section 2.2). T is at least the time at which
 * {@value #DEFAULT_PASSED} of the noise passes and at most that at which {@value #MAX_PASSED} does.
 * For k = 1 it is the shortest time between the two that supports {@value #PASSED_SHARE} of the
 * objects' events supported by the longest; for other k it is the shortest.
 *
 * <p>The rate λ is that of the quietest cells of the picture in windows of 100 ms: the mean of the
 * Poisson distribution that has the measured share of counts up to their lower decile. Objects and
 * hot pixels add to some cells, which changes the share little.
 *
 * <p>Thread rule: one thread at a time.
 */
final class SupportTime {
  /** Length of a window: an object covers few cells within it. */
  static final long WINDOW_US = 100_000;

  static final int MIN_US = 1_000;
  static final int MAX_US = 500_000;

  /** Time before the end of the first window: 5 % of noise of 0.2 Hz pass. */
  static final int INITIAL_US = 32_000;

  /** Initial windows, in which neighbours may have fired before the first event. */
  private static final long FIRST_WINDOWS = MAX_US / WINDOW_US;

  /** Share of the noise that passes unless objects need more. */
  static final double DEFAULT_PASSED = 0.05;

  /** Largest share of the noise that passes, for objects with low event rates. */
  static final double MAX_PASSED = 0.3;

  /** Share of the objects' events with support that pass. */
  static final double PASSED_SHARE = 0.99;

  /** Time constant of the memory: noise changes with light and temperature, in minutes. */
  private static final double MEMORY_S = 4;

  /** Settling time of the correlation time. */
  static final long SETTLING_US = 10 * WINDOW_US;

  /** Clipping of counts, in standard deviations of the noise. */
  private static final double CLIP_SD = 3;

  private static final int NEIGHBOURS = 8;

  /** Cells have at most 16 pixels a side: five events a window at 0.2 Hz. */
  private static final int MAX_CELL_BITS = 4;

  /** Largest count of a cell in a window: 20 Hz per pixel is not noise. */
  private static final int MAX_COUNT = 512;

  /** Assumed share of the cells and windows without objects. */
  private static final double QUIET_SHARE = 0.1;

  /** Bins of the time since the last neighbour: four for each doubling. */
  private static final int BINS_PER_OCTAVE = 4;

  private static final int BINS = 32 * BINS_PER_OCTAVE;
  private static final int FIRST_BIN = bin(MIN_US);
  private static final int LAST_BIN = bin(MAX_US);

  private final int cellBits;
  private final int cellsX;
  private final int fullX;
  private final int fullY;
  private final int[] cells;
  private final int[] quietWindows;
  private final double[] counts = new double[MAX_COUNT + 1];
  private final int[] bins = new int[BINS];
  private final double[] delays = new double[BINS];
  private long windowsSeen;
  private int supportUs;

  SupportTime(SensorGeometry geometry) {
    int side = Math.min(geometry.width(), geometry.height());
    cellBits = Math.min(MAX_CELL_BITS, 31 - Integer.numberOfLeadingZeros(side));
    cellsX = (geometry.width() - 1 >> cellBits) + 1;
    fullX = geometry.width() >> cellBits;
    fullY = geometry.height() >> cellBits;
    cells = new int[cellsX * ((geometry.height() - 1 >> cellBits) + 1)];
    quietWindows = new int[cells.length];
    reset();
  }

  void reset() {
    Arrays.fill(cells, 0);
    Arrays.fill(quietWindows, Integer.MAX_VALUE);
    Arrays.fill(bins, 0);
    Arrays.fill(delays, 0);
    Arrays.fill(counts, 0);
    windowsSeen = 0;
    supportUs = INITIAL_US;
  }

  int supportUs() {
    return supportUs;
  }

  /** Counts events in their cells. */
  void count(int[] addresses, int from, int to) {
    for (int i = from; i < to; i++) {
      int address = addresses[i];
      cells[
          (EventAddress.y(address) >> cellBits) * cellsX + (EventAddress.x(address) >> cellBits)]++;
    }
  }

  /** Counts events by the times since the last event of a neighbour, microseconds from 0. */
  void countDelays(int[] sinceUs, int count) {
    for (int i = 0; i < count; i++) {
      bins[bin(sinceUs[i])]++;
    }
  }

  private static int bin(int us) {
    int octave = 31 - Integer.numberOfLeadingZeros(us | BINS_PER_OCTAVE);
    return octave * BINS_PER_OCTAVE + (us >>> octave - 2 & BINS_PER_OCTAVE - 1);
  }

  /** First time above a bin, microseconds. */
  private static double endUs(int bin) {
    int octave = bin / BINS_PER_OCTAVE;
    return Math.scalb(BINS_PER_OCTAVE + bin % BINS_PER_OCTAVE + 1.0, octave - 2);
  }

  /**
   * Ends a window.
   *
   * @param windows number of ended windows, all empty except the first
   * @param neighbours how many of the eight must support an event
   * @param polarities 2 if only neighbours of the same polarity count, else 1
   */
  void endWindow(long windows, int neighbours, int polarities) {
    double windowS = WINDOW_US * 1e-6;
    double each = Math.exp(-windowS / MEMORY_S);
    double sinceFirst = Math.pow(each, windows - 1.0);
    double all = sinceFirst * each;
    double emptyWindows = (1 - sinceFirst) / (1 - each);
    int active = countCells(windows, all, sinceFirst, emptyWindows);
    Arrays.fill(cells, 0);
    windowsSeen += windows;
    if (windowsSeen > FIRST_WINDOWS) {
      for (int i = 0; i < BINS; i++) {
        delays[i] = delays[i] * all + bins[i] * sinceFirst;
      }
    }
    Arrays.fill(bins, 0);
    if (active > 0) {
      double pixels = 1 << 2 * cellBits;
      choose(noisePerWindow() / (windowS * pixels), neighbours, polarities);
    }
  }

  /** Counts cells by their events. One without events within the memory is ignored. */
  private int countCells(long windows, double all, double sinceFirst, double emptyWindows) {
    for (int i = 0; i < counts.length; i++) {
      counts[i] *= all;
    }
    int active = 0;
    long remembered = Math.round(MEMORY_S * 1e6 / WINDOW_US);
    for (int y = 0; y < fullY; y++) {
      for (int x = 0; x < fullX; x++) {
        int cell = y * cellsX + x;
        long quiet = cells[cell] > 0 ? windows - 1 : quietWindows[cell] + windows;
        quietWindows[cell] = (int) Math.min(Integer.MAX_VALUE, quiet);
        if (quiet < remembered) {
          counts[Math.min(MAX_COUNT, cells[cell])] += sinceFirst;
          active++;
        }
      }
    }
    counts[0] += emptyWindows * active;
    return active;
  }

  /** Mean count of a cell in a window by noise alone. */
  private double noisePerWindow() {
    double total = Arrays.stream(counts).sum();
    int quietCount = 0;
    double share = counts[0] / total;
    while (share < QUIET_SHARE) {
      share += counts[++quietCount] / total;
    }
    // the share falls as the mean rises
    double low = 0;
    double high = quietCount + CLIP_SD * CLIP_SD + CLIP_SD * Math.sqrt(quietCount + 1.0);
    for (int step = 0; step < 40; step++) {
      double middle = (low + high) / 2;
      if (poisson(quietCount, middle) > share) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Probability of at most a count. */
  private static double poisson(int count, double mean) {
    double term = Math.exp(-mean);
    double sum = term;
    for (int i = 1; i <= count; i++) {
      term *= mean / i;
      sum += term;
    }
    return sum;
  }

  private void choose(double noiseHz, int neighbours, int polarities) {
    double supportHz = noiseHz / polarities;
    int shortest = FIRST_BIN;
    while (shortest < LAST_BIN && passed(shortest + 1, supportHz, neighbours) <= DEFAULT_PASSED) {
      shortest++;
    }
    int longest = shortest;
    while (longest < LAST_BIN && passed(longest + 1, supportHz, neighbours) <= MAX_PASSED) {
      longest++;
    }
    supportUs = (int) endUs(neighbours == 1 ? chosen(shortest, longest, supportHz) : shortest) - 1;
    supportUs = Math.max(MIN_US, Math.min(MAX_US, supportUs));
  }

  private int chosen(int shortest, int longest, double supportHz) {
    double events = upTo(BINS - 1);
    if (events == 0) {
      return longest;
    }
    double random = (events - upTo(longest)) / (1 - passed(longest, supportHz, 1));
    double quietCount = supported(longest, random, supportHz);
    int chosen = shortest;
    if (quietCount > CLIP_SD * Math.sqrt(events)) {
      while (chosen < longest
          && isLess(chosen, longest, PASSED_SHARE * quietCount, random, supportHz)) {
        chosen++;
      }
    }
    return chosen;
  }

  /** Whether a time supports fewer events than wanted, within the statistical error. */
  private boolean isLess(int bin, int longest, double wanted, double random, double supportHz) {
    double byChance = passed(longest, supportHz, 1) - passed(bin, supportHz, 1);
    return supported(bin, random, supportHz) < wanted + Math.sqrt(random * byChance);
  }

  /** Number of objects' events supported within the times up to a bin, without chance support. */
  private double supported(int bin, double random, double supportHz) {
    return upTo(bin) - random * passed(bin, supportHz, 1);
  }

  private double upTo(int bin) {
    double all = 0;
    for (int i = 0; i <= bin; i++) {
      all += delays[i];
    }
    return all;
  }

  /** Share of the noise that passes with the times up to a bin. */
  private static double passed(int bin, double supportHz, int neighbours) {
    double q = Math.min(1 - 1e-12, -Math.expm1(-supportHz * endUs(bin) * 1e-6));
    double term = Math.pow(1 - q, NEIGHBOURS);
    double fewer = 0;
    for (int i = 0; i < neighbours; i++) {
      fewer += term;
      term *= q / (1 - q) * (NEIGHBOURS - i) / (i + 1);
    }
    return 1 - fewer;
  }
}
