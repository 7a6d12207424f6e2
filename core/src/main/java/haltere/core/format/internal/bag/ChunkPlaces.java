package haltere.core.format.internal.bag;

import java.util.Arrays;

/**
 * Positions of the chunks of a bag that its index lists.
 *
 * <p>Thread rule: one thread.
 */
final class ChunkPlaces {
  private static final int MAX_CHUNKS = 1 << 20;

  private long[] places = new long[16];
  private int count;
  private boolean sorted;

  void add(long place) {
    if (count == MAX_CHUNKS) {
      return;
    }
    if (count == places.length) {
      places = Arrays.copyOf(places, 2 * count);
    }
    places[count++] = place;
    sorted = false;
  }

  /** The first position after another, or a fallback if there is none. */
  long after(long place, long otherwise) {
    if (!sorted) {
      Arrays.sort(places, 0, count);
      sorted = true;
    }
    int at = Arrays.binarySearch(places, 0, count, place + 1);
    int found = at < 0 ? -at - 1 : at;
    return found < count ? places[found] : otherwise;
  }
}
