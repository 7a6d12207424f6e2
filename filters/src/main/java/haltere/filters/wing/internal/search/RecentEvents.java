package haltere.filters.wing.internal.search;

import haltere.core.event.EventAddress;

/**
 * The events of the last few beats, thinned evenly where they come faster than one in {@link
 * #MIN_GAP_US}, so that a fixed store always reaches back far enough.
 */
public final class RecentEvents {
  /** Events that follow another one sooner are not kept. */
  static final int MIN_GAP_US = 5;

  private final long[] timesUs;
  private final int[] addresses;
  private final int mask;
  private int end;
  private int size;
  private long lastUs;

  /**
   * An empty store.
   *
   * @param capacity how many events it keeps, a power of two
   */
  public RecentEvents(int capacity) {
    timesUs = new long[capacity];
    addresses = new int[capacity];
    mask = capacity - 1;
  }

  /**
   * Keeps an event, if it does not follow the last one too soon.
   *
   * @param timeUs when, microseconds
   * @param address as in an event packet
   */
  public void add(long timeUs, int address) {
    if (size > 0 && timeUs - lastUs < MIN_GAP_US) {
      return;
    }
    lastUs = timeUs;
    timesUs[end] = timeUs;
    addresses[end] = address;
    end = (end + 1) & mask;
    size = Math.min(size + 1, timesUs.length);
  }

  /** Forgets all events. */
  public void clear() {
    end = 0;
    size = 0;
  }

  /** {@return the number of events} */
  public int size() {
    return size;
  }

  int capacity() {
    return timesUs.length;
  }

  /**
   * When an event was.
   *
   * @param index 0 for the oldest event
   * @return microseconds
   */
  public long timeUs(int index) {
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

  /**
   * Copies the events from a time on.
   *
   * @param fromUs microseconds
   * @return addresses as in an event packet, the oldest event first
   */
  public int[] addressesSince(long fromUs) {
    int first = indexAtOrAfter(fromUs);
    int[] copy = new int[size - first];
    for (int i = 0; i < copy.length; i++) {
      copy[i] = addresses[(end - size + first + i) & mask];
    }
    return copy;
  }
}
