package haltere.core.format.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes EVT3: a word for each change of row and of time and one for each event; five or more
 * events that follow each other at the same time, in ascending columns of 32 pixels of a row,
 * become a run of vector words as cameras send them (12, 12 and 8 pixels).
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
  private static final int SHORTEST_VECTOR = 5;

  /** What events of a run have in common: all of the address but the column. */
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
        leaveOut();
        i++;
        continue;
      }
      placeTime(timeUs);
      room(GROUP_BYTES);
      if (y != row) {
        row = y;
        buffer.putShort((short) y);
      }
      int onBit = (address & EventAddress.ON_BIT) << 11;
      int mask = 1;
      int next = i + 1;
      if (x + VECTOR <= width) {
        int last = address;
        while (next < size
            && times[next] == timeUs
            && addresses[next] > last
            && ((addresses[next] ^ address) & ROW) == 0
            && EventAddress.x(addresses[next]) - x < VECTOR) {
          last = addresses[next++];
          mask |= 1 << (EventAddress.x(last) - x);
        }
      }
      if (next - i >= SHORTEST_VECTOR) {
        buffer.putShort((short) (VECT_BASE_X | onBit | x));
        buffer.putShort((short) (VECT_12 | mask & 0xfff));
        buffer.putShort((short) (VECT_12 | mask >>> 12 & 0xfff));
        buffer.putShort((short) (VECT_8 | mask >>> 24));
        i = next;
      } else {
        buffer.putShort((short) (ADDR_X | onBit | x));
        i++;
      }
    }
  }
}
