package haltere.filters.wing.internal.search;

import haltere.core.event.EventPacket;
import java.util.Arrays;

/** Events of the last few beats in a fixed store, at most one in {@link #MIN_GAP_US}. */
public final class RecentEvents {
  /** Least time between two stored events. */
  static final int MIN_GAP_US = 5;

  static final int CAPACITY = 16384;

  /** Twice the capacity, so that old events are removed in one copy. */
  private final EventPacket events = new EventPacket(2 * CAPACITY);

  private long lastUs;

  /**
   * Stores an event, unless it follows the last one too soon.
   *
   * @param timeUs microseconds
   * @param address as in an event packet
   */
  public void add(long timeUs, int address) {
    if (timeUs - lastUs < MIN_GAP_US && !events.isEmpty()) {
      return;
    }
    lastUs = timeUs;
    if (events.size() == 2 * CAPACITY) {
      for (int i = 0; i < CAPACITY; i++) {
        events.move(CAPACITY + i, i);
      }
      events.truncate(CAPACITY);
    }
    events.append(timeUs, address);
  }

  /** Removes all events. */
  public void clear() {
    events.clear();
  }

  /** {@return the number of events} */
  public int size() {
    return Math.min(CAPACITY, events.size());
  }

  private int first() {
    return events.size() - size();
  }

  /**
   * Time of an event.
   *
   * @param index 0 for the oldest event
   * @return microseconds
   */
  public long timeUs(int index) {
    return events.timeUs(first() + index);
  }

  /** Column of an event, 0 the oldest one. */
  int x(int index) {
    return events.x(first() + index);
  }

  /** Row of an event, 0 the oldest one. */
  int y(int index) {
    return events.y(first() + index);
  }

  /** Polarity of an event, 0 the oldest one. */
  boolean isOn(int index) {
    return events.isOn(first() + index);
  }

  /** First event at or after a time. */
  int indexAtOrAfter(long timeUs) {
    return events.indexAtOrAfter(timeUs, first()) - first();
  }

  /**
   * Copies the events since a time.
   *
   * @param fromUs microseconds
   * @return addresses as in an event packet, the oldest event first
   */
  public int[] addressesSince(long fromUs) {
    int from = events.indexAtOrAfter(fromUs, first());
    return Arrays.copyOfRange(events.addresses(), from, events.size());
  }
}
