package haltere.core.format.internal.aedat2;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.clock.WrittenClock;
import haltere.core.format.internal.decoding.HeaderText;
import haltere.core.format.internal.decoding.OutputBuffer;
import haltere.core.format.internal.decoding.WriterLosses;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/**
 * Writes AEDAT-2.0: the DVS128's layout for sensors of 128x128 pixels, the DAVIS's for all others.
 *
 * <p>The header is plain ASCII with CRLF, because jAER finds the first record by counting
 * characters. Its end line separates it from a first record whose first byte is a number sign. For
 * times beyond 32 bits, a header line of Haltere has the offset; jAER ignores it.
 */
final class Aedat2Writer implements RecordingWriter {
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

  private final OutputBuffer output;
  private final WriteOptions options;
  private final SensorGeometry geometry;
  private final AddressDecoder addresses;
  private WrittenClock clock;
  private long outside;

  private Aedat2Writer(AtomicFile file, WriteOptions options, AddressDecoder addresses) {
    output = new OutputBuffer(file, ByteOrder.BIG_ENDIAN);
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
              + " does not fit into AEDAT-2.0, whose limit is "
              + DavisAddressDecoder.MAX_WIDTH
              + "x"
              + DavisAddressDecoder.MAX_HEIGHT
              + "; choose another format or cut out a region");
    }
    AddressDecoder addresses =
        isDvs128(geometry) ? new Dvs128AddressDecoder(geometry) : new DavisAddressDecoder(geometry);
    return new Aedat2Writer(options.create(path), options, addresses);
  }

  private static boolean isDvs128(SensorGeometry geometry) {
    return geometry.width() == 128 && geometry.height() == 128;
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    output.requireUnfinished();
    if (packet.isEmpty()) {
      return;
    }
    if (clock == null) {
      long first = packet.firstTimeUs();
      start(first - (int) first);
    }
    long[] times = packet.timesUs();
    int[] events = packet.addresses();
    ByteBuffer buffer = output.bytes();
    int size = packet.size();
    int i = 0;
    while (i < size) {
      output.room(RecordDecoder.AEDAT2_BYTES);
      long minUs = clock.turnUs() + Integer.MIN_VALUE;
      long lastUs = clock.started() ? clock.lastUs() : Long.MAX_VALUE;
      int stop = Math.min(size, i + buffer.remaining() / RecordDecoder.AEDAT2_BYTES);
      for (; i < stop; i++) {
        long timeUs = times[i];
        if ((timeUs - lastUs) >>> 31 != 0 || (timeUs - minUs) >>> 32 != 0 || isOutside(events[i])) {
          break;
        }
        lastUs = timeUs;
        buffer.putInt(addresses.word(events[i])).putInt((int) timeUs);
      }
      if (clock.started()) {
        clock.advance(lastUs);
      }
      if (i < stop) {
        writeChecked(times[i], events[i]);
        i++;
      }
    }
  }

  private boolean isOutside(int event) {
    return EventAddress.x(event) >= geometry.width() || EventAddress.y(event) >= geometry.height();
  }

  /** Writes the first event, one outside the sensor, or one after a jump of the clock. */
  private void writeChecked(long timeUs, int event) {
    if (isOutside(event)) {
      outside++;
      return;
    }
    clock.take(timeUs, (int) timeUs);
    output.bytes().putInt(addresses.word(event)).putInt((int) timeUs);
  }

  private void start(long firstTurnUs) throws IOException {
    // a start too far from 0 for the header line is a jump
    boolean tooFar =
        firstTurnUs > AedatHeader.MAX_BASE_US || firstTurnUs < -AedatHeader.MAX_BASE_US;
    long turnUs = tooFar ? 0 : firstTurnUs;
    clock = new WrittenClock(turnUs);
    HeaderText text = new HeaderText("#", "\r\n");
    text.line(AedatHeader.VERSION + "2.0");
    text.line(" This is a raw AE data file - do not edit");
    text.line(
        " Data format is int32 address, int32 timestamp (8 bytes total), repeated for each event");
    text.line(" Timestamps tick: 1 us");
    String chip = CHIPS.get(geometry.toString());
    if (chip != null) {
      text.line(" " + AedatHeader.CHIP + " " + chip);
    }
    text.line(" " + AedatHeader.SENSOR + " " + geometry);
    if (turnUs != 0) {
      text.line(" " + AedatHeader.TIME_BASE + " " + turnUs + " us");
    }
    for (Map.Entry<String, String> entry : new TreeMap<>(options.metadata()).entrySet()) {
      String key = entry.getKey().strip();
      if (OWN_KEYS.stream().noneMatch(own -> own.equalsIgnoreCase(key + ":"))) {
        text.line(" " + key + ": " + entry.getValue());
      }
    }
    text.line(AedatHeader.END);
    output.header(text.bytes());
  }

  @Override
  public List<String> losses() {
    List<String> lines = new ArrayList<>(WriterLosses.outside(outside, geometry));
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
