package haltere.core.format.dat;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WrappingClock;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * Writes DAT of version 2 with CD events. The times of the records have 32 bits. Longer ones come
 * back here, since the reader counts the turns of that clock and a header line of our own says
 * where the first turn begins; other programs see the low 32 bits, which {@link #losses} tells.
 */
final class DatWriter implements RecordingWriter {
  private static final int BUFFER_BYTES = 256 * 1024;
  private static final long TURN_US = 1L << 32;
  private static final Set<String> OWN_KEYS =
      Set.of("data", "version", "width", "height", "end", DatFormat.TIME_BASE);

  private final AtomicFile file;
  private final WriteOptions options;
  private final int width;
  private final int top;
  private final ByteBuffer buffer =
      ByteBuffer.allocateDirect(BUFFER_BYTES).order(ByteOrder.LITTLE_ENDIAN);
  private WrappingClock reader;
  private long shiftUs;
  private long shifts;
  private long outside;
  private long narrowed;

  DatWriter(Path path, WriteOptions options) throws IOException {
    SensorGeometry geometry = options.geometry();
    if (geometry.width() > DatFormat.MAX_SIDE || geometry.height() > DatFormat.MAX_SIDE) {
      throw new RecordingProblem(
          path,
          "a sensor of "
              + geometry
              + " does not fit into DAT, which has room for 16384x16384;"
              + " choose another format or cut out a region");
    }
    this.options = options;
    width = geometry.width();
    top = geometry.height() - 1;
    file = AtomicFile.create(path, options.overwrite());
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    if (packet.isEmpty()) {
      return;
    }
    if (reader == null) {
      start(Math.floorDiv(packet.firstTimeUs(), TURN_US) * TURN_US);
    }
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int size = packet.size();
    int right = width - 1;
    int topRow = top;
    int i = 0;
    while (i < size) {
      if (buffer.remaining() < DatDecoder.RECORD_BYTES) {
        flush();
      }
      long turnUs = reader.turnUs() - shiftUs;
      long lastUs = reader.started() ? reader.lastUs() - shiftUs : Long.MAX_VALUE;
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
      if (reader.started()) {
        reader.advance(lastUs + shiftUs);
      }
      if (i < stop) {
        writeWithCare(times[i], addresses[i]);
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

  /** The first event, one outside, or one to which the clock does not simply go on. */
  private void writeWithCare(long timeUs, int address) {
    int x = EventAddress.x(address);
    int y = top - EventAddress.y(address);
    if (x >= width || y < 0) {
      outside++;
      return;
    }
    long readUs = reader.read(timeUs & 0xffffffffL);
    reader.take(readUs);
    if (readUs - timeUs != shiftUs) {
      shiftUs = readUs - timeUs;
      shifts++;
    }
    buffer.putLong(record(timeUs, x, y, address));
  }

  private void flush() throws IOException {
    buffer.flip();
    file.write(buffer);
    buffer.clear();
  }

  private void start(long firstTurnUs) throws IOException {
    // A start too far from 0 for the header line counts as a leap.
    boolean tooFar = firstTurnUs > DatFormat.MAX_BASE_US || firstTurnUs < -DatFormat.MAX_BASE_US;
    long turnUs = tooFar ? 0 : firstTurnUs;
    reader = new WrappingClock(TURN_US, turnUs);
    StringBuilder text = new StringBuilder();
    line(text, "Data file containing CD events");
    line(text, "Version 2");
    line(text, "Width " + width);
    line(text, "Height " + (top + 1));
    if (turnUs != 0) {
      line(text, DatFormat.TIME_BASE + " " + turnUs);
    }
    for (Map.Entry<String, String> entry : new TreeMap<>(options.metadata()).entrySet()) {
      String key = entry.getKey().strip().replaceAll("\\s+", "_");
      if (!key.isEmpty() && !OWN_KEYS.contains(key.toLowerCase(Locale.ROOT))) {
        line(text, key + " " + entry.getValue());
      }
    }
    file.write(ByteBuffer.wrap(text.toString().getBytes(StandardCharsets.US_ASCII)));
    file.write(ByteBuffer.wrap(new byte[] {DatFormat.CD, DatDecoder.RECORD_BYTES}));
  }

  private static void line(StringBuilder text, String line) {
    text.append("% ");
    line.chars().forEach(c -> text.append(c < ' ' ? ' ' : c > '~' ? '?' : (char) c));
    text.append('\n');
  }

  @Override
  public List<String> losses() {
    List<String> lines = new ArrayList<>();
    if (outside > 0) {
      lines.add(outside + " events outside of " + options.geometry() + " were left out");
    }
    if (narrowed > 0) {
      lines.add(
          "the format's times have 32 bits: other programs read those of about "
              + narrowed
              + " events less a multiple of 4294967296 us");
    }
    if (shifts > 0) {
      lines.add(
          shifts
              + " leaps of time are too long for the format's 32-bit clock;"
              + " the times behind them read back shifted");
    }
    return lines;
  }

  @Override
  public void finish() throws IOException {
    if (reader == null) {
      start(0);
    }
    flush();
    file.commit();
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
