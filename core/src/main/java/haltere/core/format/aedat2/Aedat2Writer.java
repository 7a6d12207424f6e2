package haltere.core.format.aedat2;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WrappingClock;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes AEDAT-2.0: the DVS128's layout for sensors of 128x128 pixels, the DAVIS's for all others.
 *
 * <p>The header is plain ASCII with CRLF, because jAER finds the first record by counting
 * characters, and has its end line, because only that tells a first record whose first byte is that
 * of a number sign from one more line. Times beyond 32 bits are kept by a header line of our own
 * that says what to add to them; jAER passes over it.
 */
final class Aedat2Writer implements RecordingWriter {
  private static final int BUFFER_BYTES = 256 * 1024;
  private static final List<String> OWN_KEYS =
      List.of(AedatHeader.CHIP, AedatHeader.HARDWARE, AedatHeader.SENSOR, AedatHeader.TIME_BASE);

  /** jAER's chip classes by sensor size, so that jAER opens the right one. */
  private static final Map<String, String> CHIPS =
      Map.of(
          "128x128", "ch.unizh.ini.jaer.chip.retina.DVS128",
          "240x180", "eu.seebetter.ini.chips.davis.DAVIS240C",
          "346x260", "eu.seebetter.ini.chips.davis.Davis346blue",
          "640x480", "eu.seebetter.ini.chips.davis.Davis640",
          "208x192", "eu.seebetter.ini.chips.davis.Davis208PixelParade");

  private final AtomicFile file;
  private final WriteOptions options;
  private final SensorGeometry geometry;
  private final AddressDecoder addresses;
  private final ByteBuffer buffer = ByteBuffer.allocateDirect(BUFFER_BYTES);
  private WrappingClock reader;
  private long shiftUs;
  private long shifts;
  private long outside;

  private Aedat2Writer(AtomicFile file, WriteOptions options, AddressDecoder addresses) {
    this.file = file;
    this.options = options;
    this.geometry = options.geometry();
    this.addresses = addresses;
  }

  static Aedat2Writer create(Path path, WriteOptions options) throws IOException {
    SensorGeometry geometry = options.geometry();
    if (geometry.width() > DavisAddressDecoder.MAX_WIDTH
        || geometry.height() > DavisAddressDecoder.MAX_HEIGHT) {
      throw new RecordingProblem(
          path,
          "a sensor of "
              + geometry
              + " does not fit into AEDAT-2.0, which has room for "
              + DavisAddressDecoder.MAX_WIDTH
              + "x"
              + DavisAddressDecoder.MAX_HEIGHT
              + "; choose another format or cut out a region");
    }
    AddressDecoder addresses =
        isDvs128(geometry) ? new Dvs128AddressDecoder(geometry) : new DavisAddressDecoder(geometry);
    return new Aedat2Writer(AtomicFile.create(path, options.overwrite()), options, addresses);
  }

  private static boolean isDvs128(SensorGeometry geometry) {
    return geometry.width() == 128 && geometry.height() == 128;
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    if (reader == null && !packet.isEmpty()) {
      long first = packet.firstTimeUs();
      start(first - (int) first);
    }
    int size = packet.size();
    for (int i = 0; i < size; i++) {
      int address = packet.address(i);
      if (!geometry.contains(packet.x(i), packet.y(i))) {
        outside++;
        continue;
      }
      long timeUs = packet.timeUs(i);
      long readUs = reader.read((int) timeUs);
      reader.take(readUs);
      if (readUs - timeUs != shiftUs) {
        shiftUs = readUs - timeUs;
        shifts++;
      }
      if (buffer.remaining() < RecordDecoder.AEDAT2_BYTES) {
        flush();
      }
      buffer.putInt(addresses.word(address)).putInt((int) timeUs);
    }
  }

  private void flush() throws IOException {
    buffer.flip();
    file.write(buffer);
    buffer.clear();
  }

  private void start(long firstTurnUs) throws IOException {
    // A start too far from 0 for the header line counts as a leap.
    boolean tooFar =
        firstTurnUs > AedatHeader.MAX_BASE_US || firstTurnUs < -AedatHeader.MAX_BASE_US;
    long turnUs = tooFar ? 0 : firstTurnUs;
    reader = new WrappingClock(1L << 32, turnUs);
    StringBuilder text = new StringBuilder();
    line(text, AedatHeader.VERSION + "2.0");
    line(text, " This is a raw AE data file - do not edit");
    line(
        text,
        " Data format is int32 address, int32 timestamp (8 bytes total), repeated for each event");
    line(text, " Timestamps tick: 1 us");
    String chip = CHIPS.get(geometry.toString());
    if (chip != null) {
      line(text, " " + AedatHeader.CHIP + " " + chip);
    }
    line(text, " " + AedatHeader.SENSOR + " " + geometry);
    if (turnUs != 0) {
      line(text, " " + AedatHeader.TIME_BASE + " " + turnUs + " us");
    }
    for (Map.Entry<String, String> entry : new TreeMap<>(options.metadata()).entrySet()) {
      String key = entry.getKey().strip();
      if (OWN_KEYS.stream().noneMatch(own -> own.equalsIgnoreCase(key + ":"))) {
        line(text, " " + key + ": " + entry.getValue());
      }
    }
    line(text, AedatHeader.END);
    ByteBuffer bytes = ByteBuffer.wrap(text.toString().getBytes(StandardCharsets.US_ASCII));
    file.write(bytes);
  }

  private static void line(StringBuilder text, String line) {
    text.append('#');
    line.chars().forEach(c -> text.append(c < ' ' ? ' ' : c > '~' ? '?' : (char) c));
    text.append("\r\n");
  }

  @Override
  public List<String> losses() {
    List<String> lines = new ArrayList<>();
    if (outside > 0) {
      lines.add(outside + " events outside of " + geometry + " were left out");
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
