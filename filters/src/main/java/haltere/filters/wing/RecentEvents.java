package haltere.filters.wing;

import haltere.core.event.EventAddress;

/**
 * The events of the last few beats, thinned evenly where they come faster than one in {@link
 * #LEAST_GAP_US}, so that a fixed store always reaches back far enough.
 *
 * <p>Thread rule: one thread at a time.
 */
final class RecentEvents {
  /** Events that follow another one sooner are not kept. */
  static final int LEAST_GAP_US = 5;

  private final long[] timesUs;
  private final int[] addresses;
  private final int mask;
  private int end;
  private int size;
  private long lastUs;

  /** A store for so many events, a power of two. */
  RecentEvents(int capacity) {
    timesUs = new long[capacity];
    addresses = new int[capacity];
    mask = capacity - 1;
  }

  /** Keeps an event, if it does not follow the last one too soon. */
  void add(long timeUs, int address) {
    if (size > 0 && timeUs - lastUs < LEAST_GAP_US) {
      return;
    }
    lastUs = timeUs;
    timesUs[end] = timeUs;
    addresses[end] = address;
    end = (end + 1) & mask;
    size = Math.min(size + 1, timesUs.length);
  }

  void clear() {
    end = 0;
    size = 0;
  }

  int size() {
    return size;
  }

  int capacity() {
    return timesUs.length;
  }

  /** Time of an event, 0 the oldest one. */
  long timeUs(int index) {
    return timesUs[(end - size + index) & mask];
  }

  /** Column of an event, 0 the oldest one. */
  int x(int index) {
    return EventAddress.x(addresses[(end - size + index) & mask]);
  }

  /** Row of an event, 0 the oldest one. */
  int y(int index) {
    return EventAddress.y(addresses[(end - size + index) & mask]);
  }

  /** Polarity of an event, 0 the oldest one. */
  boolean isOn(int index) {
    return EventAddress.isOn(addresses[(end - size + index) & mask]);
  }

  /** First event that is not before a time. */
  int indexAtOrAfter(long timeUs) {
    int from = 0;
    int to = size;
    while (from < to) {
      int middle = (from + to) >>> 1;
      if (timeUs(middle) < timeUs) {
        from = middle + 1;
      } else {
        to = middle;
      }
    }
    return from;
  }
}
