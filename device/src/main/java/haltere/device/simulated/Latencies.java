package haltere.device.simulated;

import java.util.Arrays;

/**
 * The latencies of the latest transfers.
 *
 * <p>Thread rule: one thread at a time.
 */
final class Latencies {
  private final long[] latestUs = new long[1024];
  private int count;
  private long longestUs;

  void add(long us) {
    latestUs[count++ % latestUs.length] = us;
    longestUs = Math.max(longestUs, us);
    if (count == 2 * latestUs.length) {
      count = latestUs.length;
    }
  }

  long longestUs() {
    return longestUs;
  }

  /** A quantile of the latencies, share in thousandths. */
  long ofThousandUs(int share) {
    int known = Math.min(count, latestUs.length);
    if (known == 0) {
      return 0;
    }
    long[] sorted = Arrays.copyOf(latestUs, known);
    Arrays.sort(sorted);
    return sorted[Math.min(known - 1, known * share / 1000)];
  }
}
