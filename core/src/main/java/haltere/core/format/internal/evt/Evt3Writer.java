package haltere.core.format.internal.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes EVT3: a word for each change of row and of time and one for each event; five or more
 * events that follow each other at the same time, in ascending columns of 32 pixels of a row,
 * become a run of vector words as in cameras (12, 12 and 8 pixels).
 */
final class Evt3Writer extends EvtWriter {
  /** Longest group of words that an event needs, without high parts of the time. */
  private static final int GROUP_BYTES = 16;

  private static final int ADDR_X = 2 << 12;
  private static final int VECT_BASE_X = 3 << 12;
  private static final int VECT_12 = 4 << 12;
  private static final int VECT_8 = 5 << 12;
  private static final int TIME_LOW = 6 << 12;
  private static final int TIME_HIGH = 8 << 12;
  private static final int EXT_TRIGGER = 0xa << 12;
  private static final int LOW_BITS = 12;
  private static final int VECTOR = 32;
  private static final int MIN_VECTOR = 5;

  /** Bits that are equal in all events of a run: the address without the column. */
  private static final int ROW = ~(EventAddress.MAX_COORDINATE << EventAddress.X_SHIFT);

  private long lastUs;
  private boolean placed;
  private int row = -1;

  Evt3Writer(Path path, WriteOptions options) throws IOException {
    super(path, options, EvtClock.narrow(0));
  }

  @Override
  List<String> encodingLines() {
    return List.of("evt 3.0", "format EVT3;height=" + (top + 1) + ";width=" + width);
  }

  @Override
  int lastChannel() {
    return 15;
  }

  @Override
  void putTrigger(long timeUs, int channel, int value) throws IOException {
    placeTime(timeUs);
    room(GROUP_BYTES);
    buffer.putShort((short) (EXT_TRIGGER | channel << 8 | value));
  }

  private void placeTime(long timeUs) throws IOException {
    if (timeUs != lastUs || !placed) {
      if (timeUs >> LOW_BITS != lastUs >> LOW_BITS || !placed) {
        moveTo(timeUs);
      }
      placed = true;
      lastUs = timeUs;
      room(GROUP_BYTES);
      buffer.putShort((short) (TIME_LOW | (int) timeUs & 0xfff));
    }
  }

  @Override
  void putHigh(int value) throws IOException {
    room(GROUP_BYTES);
    buffer.putShort((short) (TIME_HIGH | value));
  }

  @Override
  void append(EventPacket packet) throws IOException {
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    int i = 0;
    while (i < size) {
      long timeUs = times[i];
      int address = addresses[i];
      int x = EventAddress.x(address);
      int y = top - EventAddress.y(address);
      if (x >= width || y < 0) {
        skip();
        i++;
        continue;
      }
      if (timeUs >> LOW_BITS != lastUs >> LOW_BITS || !placed) {
        placeTime(timeUs);
      }
      room(GROUP_BYTES);
      boolean mayBeVector =
          i + MIN_VECTOR <= size && times[i + MIN_VECTOR - 1] == timeUs && x + VECTOR <= width;
      int next = mayBeVector ? endOfVector(times, addresses, i, size) : i + 1;
      if (next - i < MIN_VECTOR) {
        putPlace(timeUs, y, ADDR_X | (address & EventAddress.ON_BIT) << 11 | x, 1);
        i++;
      } else {
        putPlace(timeUs, y, 0, 0);
        putVector(addresses, i, next);
        i = next;
      }
    }
  }

  /**
   * Writes the words of an event at once: the low part of the time and the row if they changed,
   * then a word if there is one. Up to eight bytes are overwritten by later words.
   */
  private void putPlace(long timeUs, int y, int word, int words) {
    long group = word;
    int count = words;
    if (y != row) {
      row = y;
      group = group << Short.SIZE | y;
      count++;
    }
    if (timeUs != lastUs) {
      lastUs = timeUs;
      group = group << Short.SIZE | TIME_LOW | (int) timeUs & 0xfff;
      count++;
    }
    int at = buffer.position();
    buffer.putLong(at, group);
    buffer.position(at + count * Short.BYTES);
  }

  private void putVector(int[] addresses, int from, int to) {
    int x = EventAddress.x(addresses[from]);
    int mask = 0;
    for (int i = from; i < to; i++) {
      mask |= 1 << (EventAddress.x(addresses[i]) - x);
    }
    int onBit = (addresses[from] & EventAddress.ON_BIT) << 11;
    buffer.putShort((short) (VECT_BASE_X | onBit | x));
    buffer.putShort((short) (VECT_12 | mask & 0xfff));
    buffer.putShort((short) (VECT_12 | mask >>> 12 & 0xfff));
    buffer.putShort((short) (VECT_8 | mask >>> 24));
  }

  /**
   * Index after the last of the events that follow each other at one time, in ascending columns.
   */
  private static int endOfVector(long[] times, int[] addresses, int from, int size) {
    int first = addresses[from];
    int next = from + 1;
    while (next < size
        && times[next] == times[from]
        && addresses[next] > addresses[next - 1]
        && ((addresses[next] ^ first) & ROW) == 0
        && EventAddress.x(addresses[next]) - EventAddress.x(first) < VECTOR) {
      next++;
    }
    return next;
  }
}
