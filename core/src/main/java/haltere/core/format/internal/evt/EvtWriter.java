package haltere.core.format.internal.evt;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.HeaderText;
import haltere.core.format.internal.decoding.OutputBuffer;
import haltere.core.format.internal.decoding.WriterLosses;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Common part of the writers of EVT words: the header, the clock's high part, the buffer.
 *
 * <p>The first clock period begins at 0 or, if that is too far away, at a base in a header line of
 * Haltere, so that times before 0 and times since 1970 are restored. Other programs ignore that
 * line and read the times minus the base, which {@link #losses} reports. Every wrap within a longer
 * gap is written, since readers count wraps. A clock that goes back is written unchanged within its
 * period.
 */
abstract sealed class EvtWriter implements RecordingWriter
    permits Evt2Writer, Evt21Writer, Evt3Writer {
  private static final long MAX_TURNS = 1 << 22;

  /** Maximum wraps written at the start, a few bytes each, so that all programs see them. */
  private static final long MAX_START_TURNS = 1 << 14;

  private static final Set<String> OWN_KEYS =
      Set.of("evt", "format", "geometry", "endianness", "end", EvtFormat.TIME_BASE);

  final ByteBuffer buffer;
  final int width;
  final int top;

  /** The clock of a reader after the written high parts. */
  final EvtClock reader;

  private final OutputBuffer output;
  private final WriteOptions options;
  private final long turnLengthUs;
  private long baseUs;
  private long statedBaseUs;
  private boolean started;
  private long shifts;
  private long outside;

  EvtWriter(Path path, WriteOptions options, EvtClock reader) throws IOException {
    SensorGeometry geometry = options.geometry();
    if (geometry.width() > EvtDecoder.MAX_SIDE || geometry.height() > EvtDecoder.MAX_SIDE) {
      throw new RecordingProblem(
          path,
          "a sensor of "
              + geometry
              + " does not fit into EVT words, whose limit is 2048x2048; choose another "
              + "format or cut out a region");
    }
    this.options = options;
    this.reader = reader;
    width = geometry.width();
    top = geometry.height() - 1;
    turnLengthUs = reader.turnLengthUs();
    output = new OutputBuffer(options.create(path), ByteOrder.LITTLE_ENDIAN);
    buffer = output.bytes();
  }

  /** The header lines for the encoding. */
  abstract List<String> encodingLines();

  /** Appends events that are on the sensor. */
  abstract void append(EventPacket packet) throws IOException;

  /** Writes an edge on an input. */
  abstract void putTrigger(long timeUs, int channel, int value) throws IOException;

  /** Number of the last input that the words can represent. */
  abstract int lastChannel();

  /** Writes a high part. */
  abstract void putHigh(int value) throws IOException;

  @Override
  public final void write(EventPacket packet) throws IOException {
    output.requireUnfinished();
    if (!packet.isEmpty()) {
      startAt(packet.firstTimeUs());
    }
    append(packet);
  }

  private void startAt(long timeUs) throws IOException {
    if (!started) {
      long turns = Math.floorDiv(timeUs, turnLengthUs);
      start(turns >= 0 && turns <= MAX_START_TURNS ? 0 : turns * turnLengthUs);
    }
  }

  /** Writes an edge on one of the camera's inputs; other samples cannot be represented. */
  @Override
  public final boolean write(SensorSample sample) throws IOException {
    output.requireUnfinished();
    if (!(sample instanceof Trigger trigger)
        || trigger.source() != Trigger.Source.EXTERNAL_INPUT
        || trigger.edge() == Trigger.Edge.PULSE
        || trigger.channel() > lastChannel()) {
      return false;
    }
    startAt(trigger.timeUs());
    int value = trigger.edge() == Trigger.Edge.RISING ? 1 : 0;
    putTrigger(trigger.timeUs(), trigger.channel(), value);
    return true;
  }

  /** Counts an event that cannot be written. */
  final void skip() {
    outside++;
  }

  /** Reserves space in the buffer. */
  final void room(int bytes) throws IOException {
    if (buffer.remaining() < bytes) {
      output.flush();
    }
  }

  /**
   * Writes high parts until the reader's clock is at a time. If this is impossible, all times from
   * there on are shifted by whole periods.
   */
  final void moveTo(long timeUs) throws IOException {
    long turns =
        Math.floorDiv(timeUs, turnLengthUs)
            - Math.floorDiv(baseUs, turnLengthUs)
            - reader.turnUs() / turnLengthUs;
    if (turns < 0 || turns > MAX_TURNS) {
      baseUs += turns * turnLengthUs;
      shifts++;
      turns = 0;
    }
    for (; turns > 0; turns--) {
      high(reader.last());
      high(0);
    }
    int value = reader.highOf(timeUs);
    while (reader.wraps(value)) {
      high(reader.high() - reader.longestFall());
    }
    high(value);
  }

  private void high(int value) throws IOException {
    if (value != reader.high()) {
      reader.take(value);
      putHigh(value);
    }
  }

  private void start(long turnUs) throws IOException {
    started = true;
    baseUs = turnUs;
    HeaderText text = PropheseeHeader.text();
    if (Math.abs(turnUs) > EvtFormat.MAX_BASE_US) {
      shifts++;
    } else if (turnUs != 0) {
      statedBaseUs = turnUs;
      text.line(EvtFormat.TIME_BASE + " " + turnUs);
    }
    for (String line : encodingLines()) {
      text.line(line);
    }
    text.line("geometry " + options.geometry());
    PropheseeHeader.addMetadata(text, options.metadata(), OWN_KEYS);
    text.line("end");
    output.header(text.bytes());
  }

  @Override
  public final List<String> losses() {
    List<String> lines = new ArrayList<>(WriterLosses.outside(outside, options.geometry()));
    if (statedBaseUs != 0) {
      lines.add(
          "the clock of the words starts at 0: other programs read all times "
              + WriterLosses.shift(statedBaseUs));
    }
    lines.addAll(WriterLosses.jumps(shifts, "the format's clock"));
    return lines;
  }

  @Override
  public final void finish() throws IOException {
    if (!started) {
      start(0);
    }
    output.finish();
  }

  @Override
  public final void close() throws IOException {
    output.close();
  }
}
