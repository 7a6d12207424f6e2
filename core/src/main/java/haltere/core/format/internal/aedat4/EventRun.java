package haltere.core.format.internal.aedat4;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.internal.compression.LittleEndian;
import java.lang.invoke.VarHandle;

/**
 * Decodes runs of regular events in several short loops: the first splits the 16 bytes, the others
 * work on arrays of one type, which the compiler vectorises. Together they take two thirds of the
 * time of one loop.
 *
 * <p>Thread rule: immutable.
 */
final class EventRun {
  private static final int ROWS = 0x7fff_0000;
  private static final int COLUMNS = 0x7fff;

  /** The bits above row and column. */
  private static final int ABOVE = 0x8000_8000;

  /** Position of the polarity until the address is composed. */
  private static final int POLARITY_SHIFT = 15;

  /** Gaps of more than 2 to this power microseconds, 35 years, are irregular. */
  private static final int GAP_BITS = 50;

  private final int limits;
  private final int turn;
  private final int mirror;

  EventRun(SensorGeometry geometry) {
    int lastRow = geometry.height() - 1 << EventAddress.Y_SHIFT;
    limits = ABOVE | lastRow | geometry.width() - 1;
    boolean top = geometry.origin() == Origin.TOP;
    turn = top ? lastRow : 0;
    mirror = top ? -1 : 0;
  }

  /**
   * Appends a run to a packet if all events are regular.
   *
   * @param data holds the events
   * @param at index of the first
   * @param events their number; the packet has room for them
   * @param lastUs time of the previous event
   * @param out receives them
   * @return false if an event is outside the sensor, earlier than the previous one, or has an
   *     invalid polarity
   */
  boolean decode(byte[] data, int at, int events, long lastUs, EventPacket out) {
    int from = out.size();
    int to = from + events;
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    if (!split(data, at, events, times, addresses, from)
        || !ascends(times, from, to, lastUs)
        || !inside(addresses, from, to)) {
      return false;
    }
    turn(addresses, from, to);
    out.setSize(to);
    return true;
  }

  private static boolean split(
      byte[] data, int at, int events, long[] times, int[] addresses, int from) {
    VarHandle longs = LittleEndian.LONG;
    int polarities = 0;
    int pixels = 0;
    for (int i = 0; i < events; i++) {
      times[from + i] = (long) longs.get(data, at + i * Aedat4Cursor.EVENT_BYTES);
      long word = (long) longs.get(data, at + i * Aedat4Cursor.EVENT_BYTES + 8);
      int pixel = (int) word;
      int polarity = (int) (word >>> 32);
      polarities |= polarity;
      pixels |= pixel;
      addresses[from + i] = pixel | polarity << POLARITY_SHIFT;
    }
    return (pixels & ABOVE) == 0 && (polarities & ~1) == 0;
  }

  private static boolean ascends(long[] times, int from, int to, long lastUs) {
    long gaps = times[from] - lastUs;
    for (int i = from + 1; i < to; i++) {
      gaps |= times[i] - times[i - 1];
    }
    // with such gaps the sum has not overflowed unless the last is below the first
    return gaps >>> GAP_BITS == 0 && times[to - 1] >= lastUs;
  }

  private boolean inside(int[] addresses, int from, int to) {
    int inside = ABOVE;
    for (int i = from; i < to; i++) {
      inside &= limits - (addresses[i] & (ROWS | COLUMNS));
    }
    return (inside & ABOVE) == ABOVE;
  }

  private void turn(int[] addresses, int from, int to) {
    for (int i = from; i < to; i++) {
      int address = addresses[i];
      int row = turn + ((address & ROWS ^ mirror) - mirror);
      int polarity = address >>> POLARITY_SHIFT & 1;
      addresses[i] = row | (address & COLUMNS) << EventAddress.X_SHIFT | polarity;
    }
  }
}
