package haltere.core.event;

import java.util.Arrays;
import java.util.Objects;

/**
 * Consecutive polarity events in ascending time: a struct of two primitive arrays, time in
 * microseconds and packed address ({@link EventAddress}), filtered in place.
 *
 * <p>Ownership, four rules:
 *
 * <ol>
 *   <li>the creator owns a packet;
 *   <li>the chain borrows it for the length of a call and may drop or change events in it;
 *   <li>nothing keeps a packet, or an array of it, after the call returns: copy what you need;
 *   <li>packets cross a thread only through a {@code PacketPool}.
 * </ol>
 *
 * <p>Times never descend inside a packet, nor from one packet to the next unless a notification
 * that ends continuity stands between them. Methods that take an index do not check it against
 * {@link #size()}: a loop runs from 0 to {@code size() - 1}.
 *
 * <p>Filtering in place:
 *
 * <pre>{@code
 * int kept = 0;
 * for (int i = 0; i < packet.size(); i++) {
 *   if (wanted(packet.x(i), packet.y(i))) {
 *     packet.move(i, kept++);
 *   }
 * }
 * packet.truncate(kept);
 * }</pre>
 *
 * <p>Thread rule: not safe for use by two threads at a time.
 *
 * @since 0.1
 */
public final class EventPacket {
  private static final int MAX_CAPACITY = 1 << 28;

  private long[] timesUs;
  private int[] addresses;
  private int size;

  /**
   * An empty packet.
   *
   * @param capacity events it can hold before its arrays grow, at least 0
   */
  public EventPacket(int capacity) {
    if (capacity < 0 || capacity > MAX_CAPACITY) {
      throw new IllegalArgumentException(
          "a packet holds 0 to " + MAX_CAPACITY + " events, not " + capacity);
    }
    timesUs = new long[capacity];
    addresses = new int[capacity];
  }

  private EventPacket(long[] timesUs, int[] addresses, int size) {
    this.timesUs = timesUs;
    this.addresses = addresses;
    this.size = size;
  }

  /**
   * Wraps arrays without copying; the packet owns them from now on.
   *
   * @param timesUs ascending times in microseconds
   * @param addresses packed addresses, as many as times
   * @return a packet of all of their events
   */
  public static EventPacket of(long[] timesUs, int[] addresses) {
    if (timesUs.length != addresses.length) {
      throw new IllegalArgumentException(
          timesUs.length + " times and " + addresses.length + " addresses");
    }
    return new EventPacket(timesUs, addresses, timesUs.length);
  }

  /**
   * Number of events.
   *
   * @return at least 0
   */
  public int size() {
    return size;
  }

  /**
   * Whether there is no event.
   *
   * @return true if {@link #size()} is 0
   */
  public boolean isEmpty() {
    return size == 0;
  }

  /**
   * Events that fit before the arrays grow.
   *
   * @return at least {@link #size()}
   */
  public int capacity() {
    return timesUs.length;
  }

  /**
   * Time of an event.
   *
   * @param index 0 to size - 1
   * @return microseconds on the source's clock
   */
  public long timeUs(int index) {
    return timesUs[index];
  }

  /**
   * Packed address of an event.
   *
   * @param index 0 to size - 1
   * @return address, see {@link EventAddress}
   */
  public int address(int index) {
    return addresses[index];
  }

  /**
   * Column of an event.
   *
   * @param index 0 to size - 1
   * @return x, to the right
   */
  public int x(int index) {
    return EventAddress.x(addresses[index]);
  }

  /**
   * Row of an event.
   *
   * @param index 0 to size - 1
   * @return y, upwards
   */
  public int y(int index) {
    return EventAddress.y(addresses[index]);
  }

  /**
   * Polarity of an event.
   *
   * @param index 0 to size - 1
   * @return true for ON
   */
  public boolean isOn(int index) {
    return (addresses[index] & EventAddress.ON_BIT) != 0;
  }

  /**
   * Time of the first event.
   *
   * @return microseconds
   * @throws IndexOutOfBoundsException if the packet is empty
   */
  public long firstTimeUs() {
    Objects.checkIndex(0, size);
    return timesUs[0];
  }

  /**
   * Time of the last event.
   *
   * @return microseconds
   * @throws IndexOutOfBoundsException if the packet is empty
   */
  public long lastTimeUs() {
    Objects.checkIndex(0, size);
    return timesUs[size - 1];
  }

  /**
   * Adds an event after the last one, growing the arrays where needed.
   *
   * @param timeUs microseconds, not before the last event
   * @param x column, 0 to {@link EventAddress#MAX_COORDINATE}
   * @param y row, 0 to {@link EventAddress#MAX_COORDINATE}
   * @param on true for ON
   * @throws IllegalArgumentException if the time is before the last event's or a coordinate does
   *     not fit into an address
   */
  public void append(long timeUs, int x, int y, boolean on) {
    if ((x | y) < 0 || x > EventAddress.MAX_COORDINATE || y > EventAddress.MAX_COORDINATE) {
      throw new IllegalArgumentException("pixel (" + x + ", " + y + ") does not fit an address");
    }
    if (size > 0 && timeUs < timesUs[size - 1]) {
      throw new IllegalArgumentException(
          "time goes back from " + timesUs[size - 1] + " us to " + timeUs + " us");
    }
    append(timeUs, EventAddress.pack(x, y, on));
  }

  /**
   * Adds an event without a check, for decoders that have checked it.
   *
   * @param timeUs microseconds, not before the last event
   * @param address packed address
   */
  public void append(long timeUs, int address) {
    if (size == timesUs.length) {
      ensureCapacity(size + 1);
    }
    timesUs[size] = timeUs;
    addresses[size++] = address;
  }

  /**
   * Appends events of another packet.
   *
   * @param source another packet
   * @param from index of the first event to copy
   * @param to index after the last event to copy
   */
  public void append(EventPacket source, int from, int to) {
    Objects.checkFromToIndex(from, to, source.size);
    int count = to - from;
    ensureCapacity(size + count);
    System.arraycopy(source.timesUs, from, timesUs, size, count);
    System.arraycopy(source.addresses, from, addresses, size, count);
    size += count;
  }

  /**
   * Copies one event of this packet over another, so that a filter keeps it.
   *
   * @param from index of the event to keep
   * @param to where to put it, at most {@code from}
   */
  public void move(int from, int to) {
    timesUs[to] = timesUs[from];
    addresses[to] = addresses[from];
  }

  /**
   * Replaces the address of an event (a filter that turns or mirrors the picture).
   *
   * @param index 0 to size - 1
   * @param address packed address
   */
  public void setAddress(int index, int address) {
    addresses[index] = address;
  }

  /**
   * Drops all events from an index on.
   *
   * @param newSize number of events to keep, 0 to {@link #size()}
   */
  public void truncate(int newSize) {
    if (newSize < 0 || newSize > size) {
      throw new IllegalArgumentException("cannot truncate " + size + " events to " + newSize);
    }
    size = newSize;
  }

  /** Drops all events; the arrays stay. */
  public void clear() {
    size = 0;
  }

  /**
   * Reserves space, by doubling.
   *
   * @param capacity events that must fit
   * @throws IllegalArgumentException beyond 2<sup>28</sup> events
   */
  public void ensureCapacity(int capacity) {
    // A sum of two sizes that has overflowed is negative and would seem to fit.
    if (capacity < 0 || capacity > Math.max(MAX_CAPACITY, timesUs.length)) {
      throw new IllegalArgumentException("a packet holds at most " + MAX_CAPACITY + " events");
    }
    if (capacity <= timesUs.length) {
      return;
    }
    int newLength = Math.min(MAX_CAPACITY, Math.max(capacity, Math.max(16, timesUs.length * 2)));
    timesUs = Arrays.copyOf(timesUs, newLength);
    addresses = Arrays.copyOf(addresses, newLength);
  }

  /**
   * The array of times itself, for decoders and the fastest loops. Only the first {@link #size()}
   * entries are valid, and the packet has another array after it has grown.
   *
   * @return borrowed array, microseconds
   */
  public long[] timesUs() {
    return timesUs;
  }

  /**
   * The array of addresses itself; see {@link #timesUs()}.
   *
   * @return borrowed array
   */
  public int[] addresses() {
    return addresses;
  }

  /**
   * Sets the number of entries that a decoder has filled.
   *
   * @param newSize 0 to {@link #capacity()}
   */
  public void setSize(int newSize) {
    if (newSize < 0 || newSize > timesUs.length) {
      throw new IllegalArgumentException(newSize + " events in arrays of " + timesUs.length);
    }
    size = newSize;
  }

  /**
   * An independent packet with the same events.
   *
   * @return a copy that the caller owns
   */
  public EventPacket copy() {
    return new EventPacket(Arrays.copyOf(timesUs, size), Arrays.copyOf(addresses, size), size);
  }

  /**
   * Copies the events to separate columns.
   *
   * @param times receives times in microseconds
   * @param x receives columns
   * @param y receives rows
   * @param on receives polarities
   * @param offset index in the columns where the first event goes
   */
  public void copyTo(long[] times, int[] x, int[] y, boolean[] on, int offset) {
    System.arraycopy(timesUs, 0, times, offset, size);
    for (int i = 0; i < size; i++) {
      int address = addresses[i];
      x[offset + i] = EventAddress.x(address);
      y[offset + i] = EventAddress.y(address);
      on[offset + i] = EventAddress.isOn(address);
    }
  }

  /**
   * Index of the first event at or after a time.
   *
   * @param timeUs microseconds
   * @return 0 to {@link #size()}
   */
  public int indexAtOrAfter(long timeUs) {
    return indexAtOrAfter(timeUs, 0);
  }

  /**
   * Index of the first event at or after a time, from an index on.
   *
   * @param timeUs microseconds
   * @param from index to start at
   * @return {@code from} to {@link #size()}
   */
  public int indexAtOrAfter(long timeUs, int from) {
    int low = from;
    int high = size;
    while (low < high) {
      int middle = (low + high) >>> 1;
      if (timesUs[middle] < timeUs) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return low;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof EventPacket packet
        && packet.size == size
        && Arrays.equals(timesUs, 0, size, packet.timesUs, 0, size)
        && Arrays.equals(addresses, 0, size, packet.addresses, 0, size);
  }

  @Override
  public int hashCode() {
    int hash = size;
    for (int i = 0; i < size; i++) {
      hash = 31 * (31 * hash + Long.hashCode(timesUs[i])) + addresses[i];
    }
    return hash;
  }

  @Override
  public String toString() {
    return size == 0
        ? "no events"
        : size + " events, " + timesUs[0] + " to " + timesUs[size - 1] + " us";
  }
}
