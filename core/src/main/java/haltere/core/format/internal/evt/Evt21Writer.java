package haltere.core.format.internal.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/**
 * Writes EVT2.1: events that follow each other at the same time, in ascending columns of the same
 * block of 32 pixels of a row, share a word.
 */
final class Evt21Writer extends EvtWriter {
  private static final int WORD_BYTES = 8;
  private static final int LOW_BITS = 6;
  private static final long TIME_HIGH = 8L << 60;
  private static final long EXT_TRIGGER = 0xaL << 60;

  /** Bits that are equal in all events of a word: the address without the position in the block. */
  private static final int BLOCK = ~(31 << EventAddress.X_SHIFT);

  /** The high part of the time written last, in units of 64 us. */
  private long high = Long.MIN_VALUE;

  Evt21Writer(Path path, WriteOptions options) throws IOException {
    super(path, options, EvtClock.wide(0));
  }

  @Override
  List<String> encodingLines() {
    return List.of(
        "endianness little", "evt 2.1", "format EVT21;height=" + (top + 1) + ";width=" + width);
  }

  @Override
  int lastChannel() {
    return 31;
  }

  @Override
  void putTrigger(long timeUs, int channel, int value) throws IOException {
    if (timeUs >> LOW_BITS != high) {
      high = timeUs >> LOW_BITS;
      moveTo(timeUs);
    }
    room(WORD_BYTES);
    buffer.putLong(EXT_TRIGGER | (timeUs & 0x3f) << 54 | (long) channel << 40 | (long) value << 32);
  }

  @Override
  void putHigh(int value) throws IOException {
    room(WORD_BYTES);
    buffer.putLong(TIME_HIGH | (long) value << 32);
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
      i++;
      if (x >= width || y < 0) {
        skip();
        continue;
      }
      if (timeUs >> LOW_BITS != high) {
        high = timeUs >> LOW_BITS;
        moveTo(timeUs);
      }
      int mask = 1 << (x & 31);
      int last = address;
      while (i < size
          && times[i] == timeUs
          && addresses[i] > last
          && ((addresses[i] ^ address) & BLOCK) == 0
          && EventAddress.x(addresses[i]) < width) {
        last = addresses[i++];
        mask |= 1 << (EventAddress.x(last) & 31);
      }
      room(WORD_BYTES);
      buffer.putLong(
          (long) (address & EventAddress.ON_BIT) << 60
              | (timeUs & 0x3f) << 54
              | (long) (x & ~31) << 43
              | (long) y << 32
              | mask & 0xffffffffL);
    }
  }
}
