package haltere.core.format.internal.dat;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.clock.WrittenClock;
import haltere.core.format.internal.decoding.HeaderText;
import haltere.core.format.internal.decoding.OutputBuffer;
import haltere.core.format.internal.decoding.WriterLosses;
import haltere.core.format.internal.evt.PropheseeHeader;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Writes DAT of version 2 with CD events. The times of the records have 32 bits. Haltere's reader
 * restores longer ones from the wraps and a header line with the start of the first period; other
 * programs read the low 32 bits, which {@link #losses} reports.
 */
final class DatWriter implements RecordingWriter {
  private static final Set<String> OWN_KEYS =
      Set.of("data", "version", "width", "height", "end", DatFormat.TIME_BASE);

  private final OutputBuffer output;
  private final WriteOptions options;
  private final int width;
  private final int top;
  private WrittenClock clock;
  private long outside;
  private long narrowed;

  DatWriter(Path path, WriteOptions options) throws IOException {
    SensorGeometry geometry = options.geometry();
    if (geometry.width() > DatFormat.MAX_SIDE || geometry.height() > DatFormat.MAX_SIDE) {
      throw new RecordingProblem(
          path,
          "a sensor of "
              + geometry
              + " does not fit into DAT, whose limit is 16384x16384; choose another format "
              + "or cut out a region");
    }
    this.options = options;
    width = geometry.width();
    top = geometry.height() - 1;
    output = new OutputBuffer(options.create(path), ByteOrder.LITTLE_ENDIAN);
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    output.requireUnfinished();
    if (packet.isEmpty()) {
      return;
    }
    if (clock == null) {
      start(Math.floorDiv(packet.firstTimeUs(), WrittenClock.TURN_US) * WrittenClock.TURN_US);
    }
    ByteBuffer buffer = output.bytes();
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    int right = width - 1;
    int topRow = top;
    int i = 0;
    while (i < size) {
      output.room(DatDecoder.RECORD_BYTES);
      long turnUs = clock.turnUs();
      long lastUs = clock.started() ? clock.lastUs() : Long.MAX_VALUE;
      int position = buffer.position();
      int stop = Math.min(size, i + buffer.remaining() / DatDecoder.RECORD_BYTES);
      for (; i < stop; i++) {
        long timeUs = times[i];
        int address = addresses[i];
        int x = EventAddress.x(address);
        int y = topRow - EventAddress.y(address);
        if ((timeUs - lastUs) >>> 31 != 0 || (timeUs - turnUs) >>> 32 != 0 || (y | right - x) < 0) {
          break;
        }
        lastUs = timeUs;
        buffer.putLong(position, record(timeUs, x, y, address));
        position += DatDecoder.RECORD_BYTES;
      }
      buffer.position(position);
      if (clock.started()) {
        clock.advance(lastUs);
      }
      if (i < stop) {
        writeChecked(times[i], addresses[i]);
        i++;
      }
    }
    if (packet.firstTimeUs() >>> 32 != 0 || packet.lastTimeUs() >>> 32 != 0) {
      narrowed += size;
    }
  }

  private static long record(long timeUs, int x, int y, int address) {
    int word = (address & EventAddress.ON_BIT) << 28 | y << 14 | x;
    return (long) word << 32 | timeUs & 0xffffffffL;
  }

  /** Writes the first event, one outside the sensor, or one after a jump of the clock. */
  private void writeChecked(long timeUs, int address) {
    int x = EventAddress.x(address);
    int y = top - EventAddress.y(address);
    if (x >= width || y < 0) {
      outside++;
      return;
    }
    clock.take(timeUs, timeUs & 0xffffffffL);
    output.bytes().putLong(record(timeUs, x, y, address));
  }

  private void start(long firstTurnUs) throws IOException {
    // a start too far from 0 for the header line is a jump
    boolean tooFar = firstTurnUs > DatFormat.MAX_BASE_US || firstTurnUs < -DatFormat.MAX_BASE_US;
    long turnUs = tooFar ? 0 : firstTurnUs;
    clock = new WrittenClock(turnUs);
    HeaderText text = PropheseeHeader.text();
    text.line("Data file containing CD events");
    text.line("Version 2");
    text.line("Width " + width);
    text.line("Height " + (top + 1));
    if (turnUs != 0) {
      text.line(DatFormat.TIME_BASE + " " + turnUs);
    }
    PropheseeHeader.addMetadata(text, options.metadata(), OWN_KEYS);
    output.header(text.bytes());
    output.bytes().put((byte) DatFormat.CD).put((byte) DatDecoder.RECORD_BYTES);
  }

  @Override
  public List<String> losses() {
    List<String> lines = new ArrayList<>(WriterLosses.outside(outside, options.geometry()));
    if (narrowed > 0) {
      lines.add(
          "the format's times have 32 bits: other programs read the times of about "
              + narrowed
              + " events less a multiple of 4294967296 us");
    }
    if (clock != null) {
      lines.addAll(WriterLosses.jumps(clock.leaps(), "the format's 32-bit clock"));
    }
    return lines;
  }

  @Override
  public void finish() throws IOException {
    if (clock == null) {
      start(0);
    }
    output.finish();
  }

  @Override
  public void close() throws IOException {
    output.close();
  }
}
