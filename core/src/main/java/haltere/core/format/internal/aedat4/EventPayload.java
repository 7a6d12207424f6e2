package haltere.core.format.internal.aedat4;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.internal.compression.LittleEndian;
import java.lang.invoke.VarHandle;
import java.nio.charset.StandardCharsets;

/**
 * Encodes the payload of a packet of events: a size-prefixed FlatBuffer. As {@link EventRun} does
 * for decoding, it encodes regular events in short loops.
 *
 * <p>Thread rule: one thread.
 */
final class EventPayload {
  /** Bytes before the first event. */
  static final int HEADER_BYTES = 32;

  /** About the size of DV's packets of 10 ms in a busy scene. */
  static final int MAX_EVENTS = 8192;

  private static final int RUN = Aedat4Cursor.RUN;
  private static final int ABOVE = 0x8000_8000;
  private static final int ROWS = 0x7fff_0000;
  private static final int COLUMNS = 0x7fff;

  private final SensorGeometry geometry;
  private final byte[] bytes;
  private final int[] pixels = new int[RUN];
  private final int limits;
  private int events;
  private long firstUs;
  private long lastUs;
  private long outside;

  /**
   * A payload without events.
   *
   * @param geometry sensor of the events
   */
  EventPayload(SensorGeometry geometry) {
    this.geometry = geometry;
    limits = ABOVE | geometry.height() - 1 << EventAddress.Y_SHIFT | geometry.width() - 1;
    bytes = new byte[HEADER_BYTES + MAX_EVENTS * Aedat4Cursor.EVENT_BYTES];
    // all fields except the sizes are constant
    LittleEndian.putInt(bytes, 4, 16);
    byte[] letters = Aedat4Stream.EVENTS.getBytes(StandardCharsets.ISO_8859_1);
    System.arraycopy(letters, 0, bytes, 8, 4);
    LittleEndian.putShort(bytes, 14, 6);
    LittleEndian.putShort(bytes, 16, 8);
    LittleEndian.putShort(bytes, 18, 4);
    LittleEndian.putInt(bytes, 20, 6);
    LittleEndian.putInt(bytes, 24, 4);
  }

  /** The array with the payload at its start. */
  byte[] bytes() {
    return bytes;
  }

  /** Completes the sizes in the payload; returns its number of bytes. */
  int complete() {
    int size = HEADER_BYTES + events * Aedat4Cursor.EVENT_BYTES;
    LittleEndian.putInt(bytes, 0, size - 4);
    LittleEndian.putInt(bytes, 28, events);
    return size;
  }

  void clear() {
    events = 0;
  }

  int events() {
    return events;
  }

  /** Time of the first event. */
  long firstUs() {
    return firstUs;
  }

  /** Time of the last event of all packets. */
  long lastUs() {
    return lastUs;
  }

  /** Events skipped because they are outside the sensor. */
  long outside() {
    return outside;
  }

  /**
   * Appends events up to the payload's capacity.
   *
   * @return index after the last appended event
   */
  int append(EventPacket packet, int from, int to) {
    int at = from;
    while (at < to && events < MAX_EVENTS) {
      int run = Math.min(Math.min(to - at, MAX_EVENTS - events), RUN);
      int before = events;
      if (turn(packet.addresses(), at, run)) {
        put(packet.timesUs(), packet.addresses(), at, run);
      } else {
        putSingly(packet, at, run);
      }
      if (events > before) {
        lastUs = LittleEndian.getLong(bytes, position(events - 1));
        firstUs = before == 0 ? LittleEndian.getLong(bytes, position(0)) : firstUs;
      }
      at += run;
    }
    return at;
  }

  private int position(int event) {
    return HEADER_BYTES + event * Aedat4Cursor.EVENT_BYTES;
  }

  /** Computes columns, and rows from the top; false if one is outside the sensor. */
  private boolean turn(int[] addresses, int from, int run) {
    int[] target = pixels;
    int fromLimits = limits;
    int inside = ABOVE;
    int lastRow = fromLimits & ROWS;
    for (int i = 0; i < run; i++) {
      int address = addresses[from + i];
      target[i] = address & ROWS | address >>> EventAddress.X_SHIFT & COLUMNS;
    }
    for (int i = 0; i < run; i++) {
      inside &= fromLimits - target[i];
    }
    for (int i = 0; i < run; i++) {
      int pixel = target[i];
      target[i] = lastRow - (pixel & ROWS) | pixel & COLUMNS;
    }
    return (inside & ABOVE) == ABOVE;
  }

  private void put(long[] times, int[] addresses, int from, int run) {
    VarHandle longs = LittleEndian.LONG;
    byte[] target = bytes;
    int[] turned = pixels;
    int at = position(events);
    for (int i = 0; i < run; i++) {
      longs.set(target, at + i * Aedat4Cursor.EVENT_BYTES, times[from + i]);
      long word = turned[i] | (long) (addresses[from + i] & EventAddress.ON_BIT) << 32;
      longs.set(target, at + i * Aedat4Cursor.EVENT_BYTES + 8, word);
    }
    events += run;
  }

  private void putSingly(EventPacket packet, int from, int run) {
    for (int i = from; i < from + run; i++) {
      int x = packet.x(i);
      int y = packet.y(i);
      if (!geometry.contains(x, y)) {
        outside++;
        continue;
      }
      long row = geometry.height() - 1L - y;
      LittleEndian.putLong(bytes, position(events), packet.timeUs(i));
      LittleEndian.putLong(
          bytes, position(events) + 8, (packet.isOn(i) ? 1L << 32 : 0) | row << 16 | x);
      events++;
    }
  }
}
