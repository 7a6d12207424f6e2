package haltere.filters.wing.internal.search;

import haltere.filters.noise.internal.PolarityRuns;
import java.util.Arrays;

/**
 * Selected events of the last few beats, as columns of numbers, for the search.
 *
 * <p>Of a run of events of one polarity at a pixel only the first is used, the time of the edge.
 * Hot pixels are excluded. An event is supported if a near pixel fired shortly before or after it.
 */
final class StrokeSample {
  private static final int SUPPORT_US = 300;
  private static final int SUPPORT_PX = 4;
  private static final int MAX_LOOK_BACK = 160;
  private static final int HOT_COUNT = 24;
  private static final double HOT_TIMES_MEAN = 8;

  private static final int HARMONICS = 4;

  /** Smallest power of a cell; by chance it is 4 on average and above this in 0.2 % of cells. */
  private static final double MIN_POWER = 12;

  private final int width;
  private final int height;
  private final long[] lastOfPixel;
  private final int[] countOfPixel;
  private double[][] sums = new double[0][];
  private int[] counts = new int[0];
  private boolean[] beats = new boolean[0];
  private final long[] timesUs;

  /** Columns, rows, seconds after {@link #startUs}; 1 for OFF, -1 for ON. */
  final double[] x;

  final double[] y;
  final double[] timeS;
  final double[] sign;
  final boolean[] supported;
  int size;
  int supportedCount;
  long startUs;
  long endUs;

  StrokeSample(int width, int height, int capacity) {
    this.width = width;
    this.height = height;
    lastOfPixel = new long[width * height];
    countOfPixel = new int[width * height];
    timesUs = new long[capacity];
    x = new double[capacity];
    y = new double[capacity];
    timeS = new double[capacity];
    sign = new double[capacity];
    supported = new boolean[capacity];
  }

  /** Selects the events of a store since a time. */
  void take(RecentEvents events, long fromUs) {
    Arrays.fill(lastOfPixel, Long.MIN_VALUE);
    Arrays.fill(countOfPixel, 0);
    int first = events.indexAtOrAfter(fromUs);
    int active = 0;
    for (int i = first; i < events.size(); i++) {
      if (countOfPixel[events.y(i) * width + events.x(i)]++ == 0) {
        active++;
      }
    }
    double hot =
        Math.max(HOT_COUNT, HOT_TIMES_MEAN * (events.size() - first) / Math.max(1, active));
    size = 0;
    startUs = first < events.size() ? events.timeUs(first) : fromUs;
    endUs = events.size() > 0 ? events.timeUs(events.size() - 1) : fromUs;
    for (int i = first; i < events.size(); i++) {
      int pixel = events.y(i) * width + events.x(i);
      long timeUs = events.timeUs(i);
      boolean on = events.isOn(i);
      long last = lastOfPixel[pixel];
      lastOfPixel[pixel] = (timeUs - startUs) << 1 | (on ? 1 : 0);
      boolean runs =
          last != Long.MIN_VALUE
              && (last & 1) == (on ? 1 : 0)
              && timeUs - startUs - (last >> 1) < PolarityRuns.MAX_RUN_US;
      if (countOfPixel[pixel] > hot || runs) {
        continue;
      }
      timesUs[size] = timeUs;
      x[size] = events.x(i);
      y[size] = events.y(i);
      timeS[size] = (timeUs - startUs) * 1e-6;
      sign[size] = on ? -1 : 1;
      size++;
    }
    findSupport();
  }

  /**
   * Removes the support of events in cells of a grid that do not follow the beat, by the power of
   * the first four harmonics of their times.
   *
   * @param omega angular frequency of the beat
   */
  void requireBeat(double omega) {
    int cellPx = Math.max(6, Math.max(width, height) / 18);
    int columns = (width + cellPx - 1) / cellPx;
    int rows = (height + cellPx - 1) / cellPx;
    if (sums.length < columns * rows) {
      sums = new double[columns * rows][2 * HARMONICS];
      counts = new int[columns * rows];
      beats = new boolean[columns * rows];
    }
    for (double[] cell : sums) {
      Arrays.fill(cell, 0);
    }
    Arrays.fill(counts, 0);
    for (int i = 0; i < size; i++) {
      int cell = (int) y[i] / cellPx * columns + (int) x[i] / cellPx;
      counts[cell]++;
      double c1 = Math.cos(omega * timeS[i]);
      double s1 = Math.sin(omega * timeS[i]);
      double c = c1;
      double s = s1;
      for (int k = 0; k < HARMONICS; k++) {
        sums[cell][2 * k] += c;
        sums[cell][2 * k + 1] += s;
        double next = c * c1 - s * s1;
        s = s * c1 + c * s1;
        c = next;
      }
    }
    for (int cell = 0; cell < beats.length; cell++) {
      double power = 0;
      for (double sum : sums[cell]) {
        power += sum * sum;
      }
      beats[cell] = counts[cell] > 0 && power / counts[cell] > MIN_POWER;
    }
    supportedCount = 0;
    for (int i = 0; i < size; i++) {
      supported[i] &= beats[(int) y[i] / cellPx * columns + (int) x[i] / cellPx];
      supportedCount += supported[i] ? 1 : 0;
    }
  }

  private void findSupport() {
    Arrays.fill(supported, 0, size, false);
    for (int i = 0; i < size; i++) {
      int oldest = Math.max(0, i - MAX_LOOK_BACK);
      for (int j = i - 1; j >= oldest && timesUs[i] - timesUs[j] <= SUPPORT_US; j--) {
        double dx = Math.abs(x[i] - x[j]);
        double dy = Math.abs(y[i] - y[j]);
        if (dx <= SUPPORT_PX && dy <= SUPPORT_PX && dx + dy > 0) {
          supported[i] = true;
          supported[j] = true;
        }
      }
    }
    supportedCount = 0;
    for (int i = 0; i < size; i++) {
      supportedCount += supported[i] ? 1 : 0;
    }
  }
}
