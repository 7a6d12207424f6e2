package haltere.core.format.aedat2;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.TimeSegment;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * Reads AEDAT-1.0 and AEDAT-2.0. What is skipped or wrong is counted the first time that it is
 * read, however often the reader goes back.
 */
final class AedatReader implements RecordingReader {
  /** Small enough to stay in the cache between reading and decoding. */
  static final int BUFFER_BYTES = 256 * 1024;

  private enum State {
    BEFORE_START,
    RUNNING,
    ENDED
  }

  private final String formatName;
  private final RecordFile file;
  private final AedatSensor sensor;
  private final List<String> remarks;
  private final int recordBytes;
  private final long dataOffset;
  private final long firstTurnUs;
  private final int packetEvents;
  private final ViolationCounts violations = new ViolationCounts();
  private final RecordDecoder decoder;
  private final ByteBuffer buffer;
  private final EventPacket packet;

  private State state = State.BEFORE_START;
  private long offset;
  private long deliveredUs = StreamNotification.NO_TIME_US;
  private boolean restart;
  private boolean sought;
  private boolean primed;
  private RecordIndex index;

  AedatReader(
      String formatName,
      RecordFile file,
      AedatHeader header,
      AedatSensor sensor,
      List<String> remarks,
      int recordBytes,
      ReadOptions options) {
    this.formatName = formatName;
    this.file = file;
    this.sensor = sensor;
    this.remarks = List.copyOf(remarks);
    this.recordBytes = recordBytes;
    dataOffset = header.dataOffset();
    firstTurnUs = header.firstTurnUs().orElse(0);
    decoder = new RecordDecoder(sensor.decoder(), recordBytes, firstTurnUs, violations);
    long records = (file.size() - dataOffset) / recordBytes;
    packetEvents = (int) Math.max(1, Math.min(options.packetEvents(), records));
    packet = new EventPacket(packetEvents);
    buffer = newBuffer().limit(0);
    offset = dataOffset;
    if (header.cutOff()) {
      violations.add(Violation.CUT_OFF, dataOffset);
    }
  }

  /** No larger than the file. */
  private ByteBuffer newBuffer() {
    long rest = Math.max(recordBytes, file.size() - dataOffset);
    return ByteBuffer.allocateDirect((int) Math.min(BUFFER_BYTES, rest));
  }

  @Override
  public SensorGeometry geometry() {
    return sensor.geometry();
  }

  @Override
  public String formatName() {
    return formatName;
  }

  @Override
  public Path path() {
    return file.path();
  }

  @Override
  public long positionBytes() {
    return Math.min(offset, file.size());
  }

  @Override
  public long sizeBytes() {
    return file.size();
  }

  @Override
  public ViolationCounts violations() {
    return violations;
  }

  @Override
  public List<String> remarks() {
    return remarks;
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    switch (state) {
      case BEFORE_START:
        state = State.RUNNING;
        sought = false;
        deliveredUs = StreamNotification.NO_TIME_US;
        handler.notified(new StreamStarted(sensor.geometry(), file.path().toString()));
        return true;
      case ENDED:
        return false;
      default:
        break;
    }
    if (sought) {
      sought = false;
      handler.notified(
          new Reset(
              Reset.Cause.SEEK,
              deliveredUs,
              primed ? packet.firstTimeUs() : StreamNotification.NO_TIME_US));
      return true;
    }
    if (!primed) {
      packet.clear();
      fill();
    }
    primed = false;
    if (!packet.isEmpty()) {
      deliveredUs = packet.lastTimeUs();
      handler.packet(packet);
    } else if (restart) {
      restart = false;
      Reset reset = new Reset(Reset.Cause.CLOCK_RESTARTED, decoder.lastUs(), decoder.restartUs());
      decoder.acceptRestart();
      handler.notified(reset);
    } else {
      state = State.ENDED;
      handler.notified(new EndOfStream(deliveredUs));
    }
    return true;
  }

  /** Decodes until the packet is full, the clock goes back or the file ends. */
  private void fill() throws IOException {
    while (packet.size() < packetEvents && !restart) {
      if (buffer.remaining() < recordBytes) {
        file.read(buffer, offset);
        if (buffer.remaining() < recordBytes) {
          if (buffer.hasRemaining() || offset < file.size()) {
            cutOff();
          }
          return;
        }
      }
      int from = buffer.position();
      restart = decoder.decode(buffer, offset, packet, packetEvents);
      offset += buffer.position() - from;
    }
  }

  private void cutOff() {
    if (violations.count(Violation.CUT_OFF) == 0) {
      violations.add(Violation.CUT_OFF, offset);
    }
    buffer.position(buffer.limit());
  }

  @Override
  public List<TimeSegment> segments() throws IOException {
    return index().segments();
  }

  private RecordIndex index() throws IOException {
    if (index == null) {
      RecordDecoder scanner =
          new RecordDecoder(sensor.decoder(), recordBytes, firstTurnUs, new ViolationCounts());
      index = RecordIndex.scan(file, dataOffset, scanner, newBuffer());
    }
    return index;
  }

  @Override
  public void seek(int segment, long timeUs) throws IOException {
    List<TimeSegment> segments = index().segments();
    int wanted = segments.isEmpty() ? 0 : Objects.checkIndex(segment, segments.size());
    if (state == State.ENDED) {
      state = State.BEFORE_START;
    }
    sought = true;
    primed = false;
    restart = false;
    long fromUs = timeUs;
    if (!segments.isEmpty() && segments.get(wanted).lastUs() < fromUs) {
      wanted++;
      fromUs = Long.MIN_VALUE;
    }
    if (wanted >= segments.size()) {
      offset = file.size();
      buffer.limit(0);
      return;
    }
    int waypoint = index.waypointBefore(wanted, fromUs);
    index.restore(waypoint, decoder);
    offset = index.offset(waypoint);
    buffer.limit(0);
    dropBefore(fromUs);
  }

  /**
   * Decodes up to the first packet that has an event at or after a time, and drops those before.
   */
  private void dropBefore(long timeUs) throws IOException {
    int before;
    do {
      packet.clear();
      fill();
      before = packet.indexAtOrAfter(timeUs);
    } while (before == packet.size() && !packet.isEmpty());
    int kept = packet.size() - before;
    for (int i = 0; i < kept; i++) {
      packet.move(before + i, i);
    }
    packet.truncate(kept);
    primed = kept > 0;
  }

  @Override
  public void close() throws IOException {
    file.close();
  }

  @Override
  public String toString() {
    return file.path().toString();
  }
}
