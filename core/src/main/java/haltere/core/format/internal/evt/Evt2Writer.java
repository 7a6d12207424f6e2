package haltere.core.format.internal.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;

/** Writes EVT2: a word for each event, and one for each 64 microseconds in which there are any. */
final class Evt2Writer extends EvtWriter {
  private static final int WORD_BYTES = 4;
  private static final int LOW_BITS = 6;
  private static final int TIME_HIGH = 8 << 28;
  private static final int EXT_TRIGGER = 0xa << 28;

  /** The high part of the time written last, in units of 64 us. */
  private long high = Long.MIN_VALUE;

  Evt2Writer(Path path, WriteOptions options) throws IOException {
    super(path, options, EvtClock.wide(0));
  }

  @Override
  List<String> encodingLines() {
    return List.of("evt 2.0", "format EVT2;height=" + (top + 1) + ";width=" + width);
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
    buffer.putInt(EXT_TRIGGER | ((int) timeUs & 0x3f) << 22 | channel << 8 | value);
  }

  @Override
  void putHigh(int value) throws IOException {
    room(WORD_BYTES);
    buffer.putInt(TIME_HIGH | value);
  }

  @Override
  void append(EventPacket packet) throws IOException {
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    int right = width - 1;
    int topRow = top;
    int i = 0;
    while (i < size) {
      room(WORD_BYTES);
      int position = buffer.position();
      int stop = Math.min(size, i + buffer.remaining() / WORD_BYTES);
      long currentHigh = high;
      for (; i < stop; i++) {
        long timeUs = times[i];
        int address = addresses[i];
        int x = EventAddress.x(address);
        int y = topRow - EventAddress.y(address);
        if (timeUs >> LOW_BITS != currentHigh || (y | right - x) < 0) {
          break;
        }
        buffer.putInt(
            position,
            (address & EventAddress.ON_BIT) << 28 | ((int) timeUs & 0x3f) << 22 | x << 11 | y);
        position += WORD_BYTES;
      }
      buffer.position(position);
      if (i < stop) {
        if (packet.x(i) > right || packet.y(i) > topRow) {
          skip();
          i++;
        } else {
          high = times[i] >> LOW_BITS;
          moveTo(times[i]);
        }
      }
    }
  }
}
