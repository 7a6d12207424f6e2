package haltere.testing;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import java.util.Arrays;

/** Events in any order, sorted at the end. Thread rule: one thread at a time. */
public final class EventList {
  private long[] timesUs = new long[1024];
  private int[] addresses = new int[1024];
  private int size;

  /** An empty list. */
  public EventList() {
    // the fields are enough
  }

  /**
   * Adds an event.
   *
   * @param timeUs microseconds
   * @param x column
   * @param y row
   * @param on true for ON
   */
  public void add(long timeUs, int x, int y, boolean on) {
    if (size == timesUs.length) {
      timesUs = Arrays.copyOf(timesUs, 2 * size);
      addresses = Arrays.copyOf(addresses, 2 * size);
    }
    timesUs[size] = timeUs;
    addresses[size++] = EventAddress.pack(x, y, on);
  }

  /**
   * All events before a time. Events of the same time keep the order in which they were added.
   *
   * @param startUs added to all times
   * @param endUs end, excluded, before that
   * @return a new packet
   */
  public EventPacket sorted(long startUs, long endUs) {
    long earliestUs = Arrays.stream(timesUs, 0, size).min().orElse(0);
    long[] keys = new long[size];
    int bits = 64 - Long.numberOfLeadingZeros(size);
    for (int i = 0; i < size; i++) {
      keys[i] = (timesUs[i] - earliestUs) << bits | i;
    }
    Arrays.sort(keys);
    EventPacket packet = new EventPacket(size);
    for (long key : keys) {
      int i = (int) (key & ((1L << bits) - 1));
      if (timesUs[i] < endUs) {
        packet.append(startUs + timesUs[i], addresses[i]);
      }
    }
    return packet;
  }
}
