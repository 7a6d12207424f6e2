package haltere.filters.noise;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import java.util.Arrays;
import java.util.Objects;

/**
 * Detects pixels with abnormal event rates and blocks them. Event time is divided into learning
 * periods, counted from the first event. At the end of each:
 *
 * <ul>
 *   <li>a pixel is hot if its rate exceeds a threshold AND a multiple of the mean rate of its
 *       neighbours (the up to eight that are on the sensor and not blocked);
 *   <li>hot pixels are blocked from then on, the busiest first if their number is limited;
 *   <li>a blocked pixel that was not hot for several periods in a row is released.
 * </ul>
 *
 * <p>A moving edge is not blocked, since within a learning period it crosses areas. In the thinnest
 * object, a flickering line of one pixel's width, each pixel except the ends has two neighbours of
 * the same rate, so that its rate is 4 times the mean of its eight neighbours; a pixel on the rim
 * of the area swept by a beating wing has at least three, so that the ratio is at most 2.7. A hot
 * pixel among silent ones has a much larger ratio, and two adjacent hot ones have a ratio of 8. The
 * threshold of 6 lies between.
 *
 * <p>All input events count, also those of blocked pixels.
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 *
 * @since 0.1
 */
public final class HotPixels {
  /** Bit of a cell whose pixel is blocked; the other bits count the events. */
  private static final int BLOCKED = 1 << 31;

  private final int width;
  private final int height;
  private final int[] cells;
  private HotPixelsSettings settings;

  /** Count at which a pixel becomes a candidate in this period. */
  private int threshold;

  /** Pixels that have reached the threshold in this period. */
  private int[] candidates = new int[64];

  private int candidateCount;

  /** Blocked pixels, and for each the number of successive calm periods. */
  private int[] blocked;

  private int[] calmPeriods;
  private int blockedCount;

  private boolean started;
  private long periodEndUs;

  /**
   * A filter in its initial state.
   *
   * @param geometry of the sensor
   * @param settings of the filter
   */
  public HotPixels(SensorGeometry geometry, HotPixelsSettings settings) {
    width = geometry.width();
    height = geometry.height();
    cells = new int[geometry.pixels()];
    blocked = new int[0];
    calmPeriods = new int[0];
    apply(settings);
  }

  /** Removes all events and releases all pixels. */
  public void reset() {
    Arrays.fill(cells, 0);
    candidateCount = 0;
    blockedCount = 0;
    started = false;
  }

  /**
   * The settings.
   *
   * @return the settings in force
   */
  public HotPixelsSettings settings() {
    return settings;
  }

  /**
   * Applies settings from the next packet on. Blocked pixels stay blocked up to the maximum number;
   * a new learning period begins with the next event.
   *
   * @param newSettings the settings to use
   */
  public void apply(HotPixelsSettings newSettings) {
    settings = Objects.requireNonNull(newSettings, "newSettings");
    threshold = (int) Math.max(1, Math.ceil(settings.rateHz() * settings.periodUs() / 1e6));
    for (int i = settings.maxBlocked(); i < blockedCount; i++) {
      cells[blocked[i]] = 0;
    }
    blockedCount = Math.min(blockedCount, settings.maxBlocked());
    blocked = Arrays.copyOf(blocked, settings.maxBlocked());
    calmPeriods = Arrays.copyOf(calmPeriods, settings.maxBlocked());
    clearCounts();
    started = false;
  }

  /**
   * Number of pixels blocked at present.
   *
   * @return at most the number of the settings
   */
  public int blockedPixels() {
    return blockedCount;
  }

  /**
   * Whether a pixel is blocked at present.
   *
   * @param x column
   * @param y row
   * @return true if its events are dropped
   */
  public boolean isBlocked(int x, int y) {
    return cells[y * width + x] < 0;
  }

  /**
   * Removes the events of blocked pixels.
   *
   * @param packet filtered in place
   */
  public void filter(EventPacket packet) {
    int passed = 0;
    int from = 0;
    while (from < packet.size()) {
      advance(packet.timeUs(from));
      int to = packet.indexAtOrAfter(periodEndUs, from);
      passed = countAndPass(packet, from, to, passed);
      from = to;
    }
    packet.truncate(passed);
  }

  private int countAndPass(EventPacket packet, int from, int to, int passedBefore) {
    if (count(packet.addresses(), from, to)) {
      return passUnblocked(packet, from, to, passedBefore);
    }
    for (int i = from; i < to && passedBefore < from; i++) {
      packet.move(i, passedBefore + i - from);
    }
    return passedBefore + to - from;
  }

  /** Counts events; returns whether any is of a blocked pixel. */
  private boolean count(int[] addresses, int from, int to) {
    int[] counts = cells;
    int candidate = threshold;
    int seen = 0;
    for (int i = from; i < to; i++) {
      int pixel = EventAddress.y(addresses[i]) * width + EventAddress.x(addresses[i]);
      int cell = counts[pixel] + 1;
      counts[pixel] = cell;
      seen |= cell;
      if ((cell & ~BLOCKED) == candidate) {
        addCandidate(pixel);
      }
    }
    return seen < 0;
  }

  private int passUnblocked(EventPacket packet, int from, int to, int passedBefore) {
    long[] timesUs = packet.timesUs();
    int[] addresses = packet.addresses();
    int passed = passedBefore;
    for (int i = from; i < to; i++) {
      int address = addresses[i];
      timesUs[passed] = timesUs[i];
      addresses[passed] = address;
      passed += ~cells[EventAddress.y(address) * width + EventAddress.x(address)] >>> 31;
    }
    return passed;
  }

  private void addCandidate(int pixel) {
    if (candidateCount == candidates.length) {
      candidates = Arrays.copyOf(candidates, 2 * candidateCount);
    }
    candidates[candidateCount++] = pixel;
  }

  /** Ends all periods that end at or before a time. */
  private void advance(long timeUs) {
    if (!started) {
      started = true;
      periodEndUs = timeUs + settings.periodUs();
      return;
    }
    if (timeUs < periodEndUs) {
      return;
    }
    endPeriod();
    // in periods without events all pixels are calm, and after enough of them none is blocked
    long silentPeriods = (timeUs - periodEndUs) / settings.periodUs();
    for (long i = 0; i < silentPeriods && blockedCount > 0; i++) {
      endPeriod();
    }
    periodEndUs += (silentPeriods + 1) * settings.periodUs();
  }

  private void endPeriod() {
    int hot = 0;
    for (int i = 0; i < candidateCount; i++) {
      if (isHot(candidates[i])) {
        candidates[hot++] = candidates[i];
      }
    }
    releaseCalm(hot);
    blockBusiest(hot);
    clearCounts();
  }

  private boolean isHot(int pixel) {
    int x = pixel % width;
    int y = pixel / width;
    long sum = 0;
    int neighbours = 0;
    for (int ny = Math.max(0, y - 1); ny <= Math.min(height - 1, y + 1); ny++) {
      for (int nx = Math.max(0, x - 1); nx <= Math.min(width - 1, x + 1); nx++) {
        int neighbour = ny * width + nx;
        if (neighbour != pixel && cells[neighbour] >= 0) {
          sum += cells[neighbour];
          neighbours++;
        }
      }
    }
    int count = cells[pixel] & ~BLOCKED;
    return (double) count * neighbours > settings.ratio() * sum;
  }

  /** Releases pixels that have been calm for long enough; the hot ones are in candidates. */
  private void releaseCalm(int hot) {
    Arrays.sort(candidates, 0, hot);
    int passed = 0;
    for (int i = 0; i < blockedCount; i++) {
      int pixel = blocked[i];
      boolean calm = Arrays.binarySearch(candidates, 0, hot, pixel) < 0;
      int periods = calm ? calmPeriods[i] + 1 : 0;
      if (periods >= settings.calmPeriods()) {
        cells[pixel] &= ~BLOCKED;
      } else {
        blocked[passed] = pixel;
        calmPeriods[passed++] = periods;
      }
    }
    blockedCount = passed;
  }

  private void blockBusiest(int hot) {
    int fresh = 0;
    for (int i = 0; i < hot; i++) {
      if (cells[candidates[i]] >= 0) {
        candidates[fresh++] = candidates[i];
      }
    }
    int free = blocked.length - blockedCount;
    if (fresh > free) {
      sortBusiestFirst(fresh);
    }
    for (int i = 0; i < Math.min(free, fresh); i++) {
      cells[candidates[i]] |= BLOCKED;
      blocked[blockedCount] = candidates[i];
      calmPeriods[blockedCount++] = 0;
    }
  }

  private void sortBusiestFirst(int fresh) {
    long[] keys = new long[fresh];
    for (int i = 0; i < fresh; i++) {
      keys[i] = (long) -cells[candidates[i]] << 32 | candidates[i];
    }
    Arrays.sort(keys);
    for (int i = 0; i < fresh; i++) {
      candidates[i] = (int) keys[i];
    }
  }

  private void clearCounts() {
    for (int i = 0; i < cells.length; i++) {
      cells[i] &= BLOCKED;
    }
    candidateCount = 0;
  }
}
