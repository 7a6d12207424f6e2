package haltere.device.model;

import java.util.concurrent.atomic.AtomicLongArray;

/**
 * Histogram of buffer latencies, in classes of at most 12.5 % relative width.
 *
 * <p>Thread rule: one thread adds, any thread reads.
 */
final class LatencyHistogram {
  private static final int STEPS = 8;
  private static final int STEP_BITS = 3;
  private static final int CLASSES = 40 * STEPS;
  private static final long NANOS_PER_US = 1000;

  private final AtomicLongArray counts = new AtomicLongArray(CLASSES);
  private volatile long longestUs;

  void add(long nanos) {
    long us = Math.max(0, nanos / NANOS_PER_US);
    counts.lazySet(classOf(us), counts.get(classOf(us)) + 1);
    if (us > longestUs) {
      longestUs = us;
    }
  }

  private static int classOf(long us) {
    if (us < STEPS) {
      return (int) us;
    }
    int shift = 63 - Long.numberOfLeadingZeros(us) - STEP_BITS;
    return Math.min(CLASSES - 1, shift * STEPS + (int) (us >>> shift));
  }

  /** Upper bound of a class. */
  private static long longestOf(int index) {
    if (index < 2 * STEPS) {
      return index;
    }
    int shift = index / STEPS - 1;
    return ((long) (STEPS + index % STEPS + 1) << shift) - 1;
  }

  /** A quantile, to 12.5 %; 0 without entries. */
  long quantileUs(double share) {
    long all = 0;
    for (int i = 0; i < CLASSES; i++) {
      all += counts.get(i);
    }
    long below = (long) Math.ceil(all * share);
    long seen = 0;
    for (int i = 0; i < CLASSES && all > 0; i++) {
      seen += counts.get(i);
      if (seen >= below) {
        return Math.min(longestOf(i), longestUs);
      }
    }
    return 0;
  }

  long longestUs() {
    return longestUs;
  }
}
