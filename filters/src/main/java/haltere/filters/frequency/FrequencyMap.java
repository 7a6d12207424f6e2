package haltere.filters.frequency;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;
import java.util.Objects;

/**
 * Frequency at which each pixel flickers: reciprocal of the period of falling edges, the first OFF
 * events after ON events. Falling edges are more precise than rising ones (Pfrommer, 2022,
 * Frequency Cam, arXiv:2211.00198).
 *
 * <p>The period is the shortest interval between two of the last edges that is shared by most
 * neighbours or every second one: the first peak of the autocorrelation of the edges (Perkel,
 * Gerstein and Moore, 1967, Biophysical Journal 7:391). So an edge may be missing, and an object
 * that passes twice in a period, such as a wing, has the frequency of the period. A pixel with too
 * few edges has the frequency of its cell of 4 by 4 pixels, if it had an edge while the cell had
 * that frequency.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 *
 * @since 0.1
 */
public final class FrequencyMap {
  /** Periods without confirmation after which a frequency is no longer reported. */
  public static final int MAX_SILENT_PERIODS = 10;

  /** The same in periods of the lowest frequency, which limits the memory. */
  private static final int MAX_SILENT_LONGEST = 5;

  private static final int CELL_SHIFT = 2;

  /** Share of the shortest period within which further edges count as one. */
  private static final double MERGE_SHARE = 0.8;

  private static final int EDGES = 5;

  /**
   * Minimum pairs of edges with the same interval for the period of a cell. Five edges have four
   * pairs of neighbours, so that one edge may be missing.
   */
  private static final int CELL_PAIRS = 3;

  /** The same for a pixel, whose fewer edges agree more often by chance. */
  private static final int PIXEL_PAIRS = 4;

  /** Largest jitter of an edge: about the variation of a pixel's latency in dim light. */
  private static final double MAX_JITTER_US = 4_000;

  private static final long NEVER_US = Long.MIN_VALUE / 4;

  private final int width;
  private final int height;
  private final int cellsAcross;
  private final Edges pixels;
  private final Edges cells;
  private FrequencyMapSettings settings;
  private long mergeUs;
  private double maxPeriodUs;

  /**
   * A map without frequencies.
   *
   * @param geometry the sensor; events outside of it are ignored
   * @param settings limits and tolerance
   */
  public FrequencyMap(SensorGeometry geometry, FrequencyMapSettings settings) {
    width = geometry.width();
    height = geometry.height();
    cellsAcross = (width >> CELL_SHIFT) + 1;
    pixels = new Edges(geometry.pixels(), PIXEL_PAIRS);
    cells = new Edges(cellsAcross * ((height >> CELL_SHIFT) + 1), CELL_PAIRS);
    apply(settings);
    reset();
  }

  /** Removes all events. */
  public void reset() {
    pixels.reset();
    cells.reset();
  }

  /**
   * Settings in force.
   *
   * @return as given last
   */
  public FrequencyMapSettings settings() {
    return settings;
  }

  /**
   * Applies settings; the state of the pixels stays.
   *
   * @param newSettings from the next event on
   */
  public void apply(FrequencyMapSettings newSettings) {
    settings = Objects.requireNonNull(newSettings, "newSettings");
    mergeUs = (long) (MERGE_SHARE * 1e6 / settings.maxFrequencyHz());
    maxPeriodUs = 1e6 / settings.minFrequencyHz();
  }

  /**
   * Memory of the map.
   *
   * @return microseconds: the edges of a longest period, and the time for which it is reported
   */
  public long memoryUs() {
    return Math.round((EDGES + MAX_SILENT_LONGEST) * 1e6 / settings.minFrequencyHz());
  }

  /**
   * Processes events.
   *
   * @param packet not changed
   */
  public void add(EventPacket packet) {
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    for (int i = 0; i < size; i++) {
      int address = addresses[i];
      int x = EventAddress.x(address);
      int y = EventAddress.y(address);
      if (x < width && y < height) {
        boolean on = EventAddress.isOn(address);
        pixels.add(y * width + x, times[i], on);
        cells.add(cell(x, y), times[i], on);
      }
    }
  }

  private int cell(int x, int y) {
    return (y >> CELL_SHIFT) * cellsAcross + (x >> CELL_SHIFT);
  }

  /**
   * Period of a pixel.
   *
   * @param x column, inside of the sensor
   * @param y row, upwards
   * @param nowUs time of the request, on the clock of the events
   * @return microseconds, 0 if it is unknown
   */
  public float periodUs(int x, int y, long nowUs) {
    int pixel = y * width + x;
    float own = pixels.periodUs(pixel, nowUs);
    if (own > 0) {
      return own;
    }
    float shared = cells.periodUs(cell(x, y), nowUs);
    return isReported(shared, nowUs - pixels.lastUs(pixel)) ? shared : 0;
  }

  private boolean isReported(float periodUs, long silentUs) {
    return silentUs
        <= Math.min((double) MAX_SILENT_PERIODS * periodUs, MAX_SILENT_LONGEST * maxPeriodUs);
  }

  /**
   * Frequency of a pixel.
   *
   * @param x column, inside of the sensor
   * @param y row, upwards
   * @param nowUs time of the request, on the clock of the events
   * @return hertz, NaN if it is unknown
   */
  public double frequencyHz(int x, int y, long nowUs) {
    float period = periodUs(x, y, nowUs);
    return period == 0 ? Double.NaN : 1e6 / period;
  }

  /** The last edges and the period of each pixel or cell. */
  private final class Edges {
    /** Values per pixel or cell: a cache line, for one memory access per edge. */
    private static final int STRIDE = 8;

    /** After the edges: last time at which the period was found. */
    private static final int FOUND = EDGES;

    /** After that: the period, nanoseconds. */
    private static final int PERIOD = EDGES + 1;

    private final boolean[] lastOn;

    /**
     * For each pixel or cell: times of the last edges, the newest first, then time and period
     * found.
     */
    private final long[] state;

    private final int minPairs;

    Edges(int size, int minPairs) {
      this.minPairs = minPairs;
      lastOn = new boolean[size];
      state = new long[STRIDE * size];
    }

    void reset() {
      Arrays.fill(lastOn, false);
      Arrays.fill(state, NEVER_US);
    }

    void add(int index, long timeUs, boolean on) {
      if (lastOn[index] != on) {
        lastOn[index] = on;
        int at = STRIDE * index;
        if (!on && timeUs - state[at] >= mergeUs) {
          for (int i = EDGES - 1; i > 0; i--) {
            state[at + i] = state[at + i - 1];
          }
          state[at] = timeUs;
          find(at);
        }
      }
    }

    /** Searches the shortest interval that enough pairs of edges share. */
    private void find(int at) {
      for (int lag = 1; lag < EDGES; lag++) {
        long interval = state[at] - state[at + lag];
        if (interval > maxPeriodUs) {
          return;
        }
        long toleranceUs = (long) Math.min(MAX_JITTER_US, settings.tolerance() * interval);
        int pairs = 0;
        long sumUs = 0;
        for (int later = at; later < at + EDGES - 1; later++) {
          for (int earlier = later + 1; earlier < at + EDGES; earlier++) {
            long between = state[later] - state[earlier];
            if (Math.abs(between - interval) <= toleranceUs) {
              pairs++;
              sumUs += between;
            }
          }
        }
        if (pairs >= minPairs) {
          state[at + FOUND] = state[at];
          state[at + PERIOD] = 1000 * sumUs / pairs;
          return;
        }
      }
    }

    /** The period in microseconds, 0 if it is unknown. */
    float periodUs(int index, long nowUs) {
      int at = STRIDE * index;
      if (state[at + FOUND] == NEVER_US) {
        return 0;
      }
      float periodUs = state[at + PERIOD] * 1e-3f;
      return isReported(periodUs, nowUs - state[at + FOUND]) ? periodUs : 0;
    }

    long lastUs(int index) {
      return state[STRIDE * index];
    }
  }
}
