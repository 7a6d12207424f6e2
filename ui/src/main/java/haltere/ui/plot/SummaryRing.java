package haltere.ui.plot;

import java.util.Arrays;

/**
 * A ring of the newest summaries of a curve: first and last time, minimum and maximum; a summary
 * may have a single sample. Grows up to a limit, then drops the oldest.
 */
final class SummaryRing {
  private final int limit;
  private long[] fromUs = new long[64];
  private long[] toUs = new long[64];
  private double[] lowest = new double[64];
  private double[] highest = new double[64];
  private int start;
  private int size;

  SummaryRing(int limit) {
    this.limit = limit;
  }

  int size() {
    return size;
  }

  void clear() {
    start = 0;
    size = 0;
  }

  void add(long from, long to, double low, double high) {
    if (size == fromUs.length && size < limit) {
      grow();
    }
    int slot;
    if (size == fromUs.length) {
      slot = start;
      start = (start + 1) % fromUs.length;
    } else {
      slot = slot(size);
      size++;
    }
    fromUs[slot] = from;
    toUs[slot] = to;
    lowest[slot] = low;
    highest[slot] = high;
  }

  /** Makes the last stretch longer. */
  void extend(long to, double low, double high) {
    int slot = slot(size - 1);
    toUs[slot] = to;
    lowest[slot] = Math.min(lowest[slot], low);
    highest[slot] = Math.max(highest[slot], high);
  }

  /** Grows. No sample has been dropped before the limit, so the oldest is the first. */
  private void grow() {
    int length = Math.min(limit, fromUs.length * 2);
    fromUs = Arrays.copyOf(fromUs, length);
    toUs = Arrays.copyOf(toUs, length);
    lowest = Arrays.copyOf(lowest, length);
    highest = Arrays.copyOf(highest, length);
  }

  private int slot(int index) {
    int slot = start + index;
    return slot >= fromUs.length ? slot - fromUs.length : slot;
  }

  long fromUs(int index) {
    return fromUs[slot(index)];
  }

  long toUs(int index) {
    return toUs[slot(index)];
  }

  double min(int index) {
    return lowest[slot(index)];
  }

  double max(int index) {
    return highest[slot(index)];
  }

  /** Index of the first summary that ends at or after a time; the size without one. */
  int firstEndingFrom(long timeUs) {
    int low = 0;
    int high = size;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (toUs(middle) < timeUs) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Removes all summaries that end at or after a time. */
  void truncate(long timeUs) {
    size = firstEndingFrom(timeUs);
  }

  /** Bytes that its arrays take. */
  long bytes() {
    return 32L * fromUs.length;
  }
}
