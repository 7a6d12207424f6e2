package haltere.core.format.summary;

import java.util.Arrays;

/**
 * Lowest and highest value in time bins. The bins double in length when time exceeds their range,
 * so that memory is bounded for streams of any length.
 *
 * <p>Thread rule: one thread.
 *
 * @since 0.1
 */
public final class TimeBins {
  private static final long MAX_US = Long.MAX_VALUE / 2;

  private final long[] counts;
  private final double[] min;
  private final double[] max;
  private long binUs;
  private long endUs;

  /**
   * Empty bins.
   *
   * @param bins maximum number, even
   * @param firstBinUs initial length of each, microseconds
   */
  public TimeBins(int bins, long firstBinUs) {
    counts = new long[bins];
    min = new double[bins];
    max = new double[bins];
    binUs = firstBinUs;
  }

  /**
   * Adds a sample.
   *
   * @param elapsedUs its time since the first, microseconds, at least 0; negative if beyond the
   *     range of a long, and counted at the end of that of these bins
   * @param value its value
   */
  public void add(long elapsedUs, double value) {
    long atUs = elapsedUs < 0 ? MAX_US : Math.min(elapsedUs, MAX_US);
    while (atUs / binUs >= counts.length) {
      merge();
    }
    int bin = (int) (atUs / binUs);
    min[bin] = counts[bin] == 0 ? value : Math.min(min[bin], value);
    max[bin] = counts[bin] == 0 ? value : Math.max(max[bin], value);
    counts[bin]++;
    endUs = Math.max(endUs, atUs + 1);
  }

  private void merge() {
    for (int to = 0; to < counts.length / 2; to++) {
      int a = 2 * to;
      int b = a + 1;
      int known = counts[a] > 0 ? a : b;
      min[to] = counts[b] == 0 ? min[known] : Math.min(min[known], min[b]);
      max[to] = counts[b] == 0 ? max[known] : Math.max(max[known], max[b]);
      counts[to] = counts[a] + counts[b];
    }
    Arrays.fill(counts, counts.length / 2, counts.length, 0);
    binUs *= 2;
  }

  /**
   * Number of bins up to the last sample.
   *
   * @return 0 before the first sample
   */
  public int size() {
    return (int) ((endUs + binUs - 1) / binUs);
  }

  /**
   * Length of a bin.
   *
   * @return microseconds
   */
  public long binUs() {
    return binUs;
  }

  /**
   * Number of samples in a bin.
   *
   * @param bin 0 to {@link #size()} - 1
   * @return at least 0
   */
  public long count(int bin) {
    return counts[bin];
  }

  /**
   * Samples per second in a bin; in the last one over the time that it covers, at least half of its
   * length.
   *
   * @param bin 0 to {@link #size()} - 1
   * @return hertz
   */
  public double rateHz(int bin) {
    return counts[bin] * 1e6 / Math.min(binUs, Math.max(binUs / 2, endUs - bin * binUs));
  }

  /**
   * Lowest value in a bin.
   *
   * @param bin 0 to {@link #size()} - 1
   * @return NaN without samples
   */
  public double min(int bin) {
    return counts[bin] == 0 ? Double.NaN : min[bin];
  }

  /**
   * Highest value in a bin.
   *
   * @param bin 0 to {@link #size()} - 1
   * @return NaN without samples
   */
  public double max(int bin) {
    return counts[bin] == 0 ? Double.NaN : max[bin];
  }
}
