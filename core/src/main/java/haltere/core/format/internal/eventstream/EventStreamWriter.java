package haltere.core.format.internal.eventstream;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.OutputBuffer;
import haltere.core.format.internal.decoding.WriterLosses;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Writes Event Stream 2 of the kind DVS. A gap needs a byte for each 127 us, and so does the time
 * before the first event. A start more than a day from 0, or before it, is moved to 0; a jump of
 * more than a day is shortened to one; a clock that goes back is stopped. {@link #losses} reports
 * each.
 */
final class EventStreamWriter implements RecordingWriter {
  private static final int EVENT_BYTES = 5;
  private static final int OVERFLOW_US = 0x7f;
  private static final long EIGHT_OVERFLOWS = -1;
  private static final long MAX_LEAP_US = 86_400_000_000L;

  private final OutputBuffer output;
  private final SensorGeometry geometry;
  private final ByteBuffer buffer;

  /** Offset subtracted from times; changes if the format cannot store them. */
  private long baseUs;

  private long writtenUs;
  private boolean started;
  private long startShiftUs;
  private long leaps;
  private long outside;

  EventStreamWriter(Path path, WriteOptions options) throws IOException {
    geometry = options.geometry();
    output = new OutputBuffer(options.create(path), ByteOrder.LITTLE_ENDIAN);
    buffer = output.bytes();
    buffer.put(EventStreamHeader.MAGIC).put(new byte[] {2, 0, 0, EventStreamHeader.DVS});
    buffer.putShort((short) geometry.width()).putShort((short) geometry.height());
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    output.requireUnfinished();
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    int right = geometry.width() - 1;
    int topRow = geometry.height() - 1;
    int i = 0;
    while (i < size) {
      output.room(EVENT_BYTES);
      int position = buffer.position();
      int stop = Math.min(size, i + buffer.remaining() / EVENT_BYTES);
      long lastUs = writtenUs + baseUs;
      for (; i < stop; i++) {
        long stepUs = times[i] - lastUs;
        int address = addresses[i];
        int x = EventAddress.x(address);
        int y = topRow - EventAddress.y(address);
        if (stepUs < 0 || stepUs >= OVERFLOW_US || (y | right - x) < 0) {
          break;
        }
        lastUs += stepUs;
        buffer.put(position, (byte) (stepUs << 1 | address & EventAddress.ON_BIT));
        buffer.putInt(position + 1, y << 16 | x);
        position += EVENT_BYTES;
      }
      buffer.position(position);
      if (lastUs != writtenUs + baseUs) {
        writtenUs = lastUs - baseUs;
      }
      if (i < stop) {
        if (packet.x(i) > right || packet.y(i) > topRow) {
          outside++;
          i++;
        } else {
          advanceTo(times[i]);
        }
      }
      started |= i > 0;
    }
  }

  /** Writes time bytes until the rest fits in one byte. */
  private void advanceTo(long timeUs) throws IOException {
    long lastUs = writtenUs + baseUs;
    boolean back = timeUs < lastUs;
    if (back || timeUs - lastUs > MAX_LEAP_US || timeUs - lastUs < 0) {
      long toUs = writtenUs + (back || !started ? 0 : MAX_LEAP_US);
      if (started) {
        leaps++;
      } else {
        startShiftUs = timeUs;
      }
      baseUs = timeUs - toUs;
    }
    long overflows = (timeUs - baseUs - writtenUs) / OVERFLOW_US;
    writtenUs += overflows * OVERFLOW_US;
    for (; overflows >= Long.BYTES; overflows -= Long.BYTES) {
      output.room(Long.BYTES);
      buffer.putLong(EIGHT_OVERFLOWS);
    }
    for (; overflows > 0; overflows--) {
      output.room(1);
      buffer.put((byte) 0xff);
    }
  }

  @Override
  public List<String> losses() {
    List<String> lines = new ArrayList<>(WriterLosses.outside(outside, geometry));
    if (startShiftUs != 0) {
      lines.add(
          "the format's clock starts at 0: all times read back "
              + WriterLosses.shift(startShiftUs));
    }
    lines.addAll(WriterLosses.jumps(leaps, "the format's clock, which advances by at most a day"));
    return lines;
  }

  @Override
  public void finish() throws IOException {
    output.finish();
  }

  @Override
  public void close() throws IOException {
    output.close();
  }
}
