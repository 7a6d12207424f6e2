package haltere.ui.viewer.playback;

import java.util.Arrays;

/**
 * The event rate of what has come so far of a camera or a scene, as far back as it is asked for.
 */
final class RateHistory {
  private static final int CAPACITY = 4096;

  /** Rates are no nearer to each other than this share of what is drawn. */
  private static final double STEPS = 600;

  private static final long MIN_STEP_US = 10_000;

  private final long[] placesUs = new long[CAPACITY];
  private final double[] ratesEps = new double[CAPACITY];
  private long count;

  void clear() {
    count = 0;
  }

  /** The newest place, or the smallest number there is. */
  long lastUs() {
    return count == 0 ? Long.MIN_VALUE : placesUs[slot(count - 1)];
  }

  /**
   * Notes the rate at a place that nobody has seen before; true if there is something new to draw
   * in so long a span.
   */
  boolean add(long elapsedUs, double rateEps, long spanUs) {
    if (count > 0 && elapsedUs - lastUs() < Math.max(MIN_STEP_US, spanUs / STEPS)) {
      return false;
    }
    placesUs[slot(count)] = elapsedUs;
    ratesEps[slot(count)] = rateEps;
    count++;
    return true;
  }

  /**
   * The highest rate, events per second, in each of so many parts of a stretch; that of the part
   * before where nothing was noted, 0 outside of what was.
   */
  double[] highest(long fromUs, long toUs, int parts) {
    double[] highest = new double[parts];
    Arrays.fill(highest, Double.NaN);
    int last = -1;
    for (long i = Math.max(0, count - CAPACITY); i < count; i++) {
      long place = placesUs[slot(i)];
      if (place >= fromUs && place < toUs) {
        int part = (int) ((place - fromUs) * (double) parts / (toUs - fromUs));
        highest[part] = Math.max(last == part ? highest[part] : 0, ratesEps[slot(i)]);
        last = part;
      }
    }
    double before = count == 0 ? 0 : ratesEps[slot(Math.max(0, count - CAPACITY))];
    for (int part = 0; part < parts; part++) {
      before = part > last ? 0 : Double.isNaN(highest[part]) ? before : highest[part];
      highest[part] = before;
    }
    return highest;
  }

  private static int slot(long index) {
    return (int) (index % CAPACITY);
  }
}
