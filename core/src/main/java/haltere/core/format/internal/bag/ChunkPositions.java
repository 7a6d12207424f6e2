package haltere.core.format.internal.bag;

import java.util.Arrays;

/**
 * Positions of the chunks of a bag that its index lists.
 *
 * <p>Thread rule: one thread.
 */
final class ChunkPositions {
  private static final int MAX_CHUNKS = 1 << 20;

  private long[] positions = new long[16];
  private int count;
  private boolean sorted;

  void add(long position) {
    if (count == MAX_CHUNKS) {
      return;
    }
    if (count == positions.length) {
      positions = Arrays.copyOf(positions, 2 * count);
    }
    positions[count++] = position;
    sorted = false;
  }

  /** The first position after another, or a fallback if there is none. */
  long after(long position, long otherwise) {
    if (!sorted) {
      Arrays.sort(positions, 0, count);
      sorted = true;
    }
    int at = Arrays.binarySearch(positions, 0, count, position + 1);
    int found = at < 0 ? -at - 1 : at;
    return found < count ? positions[found] : otherwise;
  }
}
