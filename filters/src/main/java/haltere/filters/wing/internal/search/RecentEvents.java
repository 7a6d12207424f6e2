package haltere.filters.wing.internal.search;

import haltere.core.event.EventPacket;
import java.util.Arrays;

/**
 * The events of the last few beats, thinned evenly where they come faster than one in {@link
 * #MIN_GAP_US}, so that a fixed store always reaches back far enough.
 */
public final class RecentEvents {
  /** Events that follow another one sooner are not kept. */
  static final int MIN_GAP_US = 5;

  /** How many events are kept. */
  static final int CAPACITY = 16384;

  /** Those that are not kept any more are dropped all at once. */
  private final EventPacket events = new EventPacket(2 * CAPACITY);

  private long lastUs;

  /**
   * Keeps an event, if it does not follow the last one too soon.
   *
   * @param timeUs when, microseconds
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

  /** Forgets all events. */
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
   * When an event was.
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

  /** First event that is not before a time. */
  int indexAtOrAfter(long timeUs) {
    return events.indexAtOrAfter(timeUs, first()) - first();
  }

  /**
   * Copies the events from a time on.
   *
   * @param fromUs microseconds
   * @return addresses as in an event packet, the oldest event first
   */
  public int[] addressesSince(long fromUs) {
    int from = events.indexAtOrAfter(fromUs, first());
    return Arrays.copyOfRange(events.addresses(), from, events.size());
  }
}
