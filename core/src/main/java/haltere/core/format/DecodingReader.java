package haltere.core.format;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * The reader of every format whose events an {@link EventCursor} can decode: it makes the stream's
 * notifications, finds segments, and seeks. What is skipped or wrong is counted the first time that
 * it is read, however often the reader goes back.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class DecodingReader implements RecordingReader {
  private enum State {
    BEFORE_START,
    RUNNING,
    ENDED
  }

  private final String formatName;
  private final RecordingFile file;
  private final SensorGeometry geometry;
  private final List<String> remarks;
  private final int packetEvents;
  private final EventCursor.Factory cursors;
  private final ViolationCounts violations;
  private final EventCursor cursor;
  private final EventPacket packet = new EventPacket(0);

  private State state = State.BEFORE_START;
  private long deliveredUs = StreamNotification.NO_TIME_US;
  private boolean restart;
  private boolean atEnd;
  private boolean sought;
  private boolean primed;
  private TimeIndex index;

  /**
   * A reader at the start of a recording.
   *
   * @param formatName the format's name
   * @param file the file, closed with the reader
   * @param geometry sensor of the events
   * @param remarks what a user should know about how the file is read
   * @param options how large packets are
   * @param violations what was found wrong up to now, and where everything else is counted
   * @param cursors decode the events
   * @throws IOException if the file cannot be read
   */
  public DecodingReader(
      String formatName,
      RecordingFile file,
      SensorGeometry geometry,
      List<String> remarks,
      ReadOptions options,
      ViolationCounts violations,
      EventCursor.Factory cursors)
      throws IOException {
    this.formatName = Objects.requireNonNull(formatName, "formatName");
    this.file = file;
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.remarks = List.copyOf(remarks);
    packetEvents = options.packetEvents();
    this.violations = violations;
    this.cursors = cursors;
    cursor = cursors.open(violations);
  }

  @Override
  public SensorGeometry geometry() {
    return geometry;
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
    return Math.min(cursor.positionBytes(), file.size());
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
        handler.notified(new StreamStarted(geometry, file.path().toString()));
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
      Reset reset = new Reset(Reset.Cause.CLOCK_RESTARTED, cursor.lastUs(), cursor.restartUs());
      cursor.acceptRestart();
      handler.notified(reset);
    } else {
      state = State.ENDED;
      handler.notified(new EndOfStream(deliveredUs));
    }
    return true;
  }

  /** Decodes until the packet is full, the clock goes back or the file ends. */
  private void fill() throws IOException {
    while (packet.size() < packetEvents && !restart && !atEnd) {
      switch (cursor.read(packet, packetEvents)) {
        case CLOCK_WENT_BACK -> restart = true;
        case END -> atEnd = true;
        default -> {
          // It has read a piece and goes on.
        }
      }
    }
  }

  @Override
  public List<TimeSegment> segments() throws IOException {
    return index().segments();
  }

  private TimeIndex index() throws IOException {
    if (index == null) {
      try (EventCursor scanner = cursors.open(new ViolationCounts())) {
        index = TimeIndex.scan(file.path(), scanner);
      }
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
    atEnd = false;
    long fromUs = timeUs;
    if (!segments.isEmpty() && segments.get(wanted).lastUs() < fromUs) {
      wanted++;
      fromUs = Long.MIN_VALUE;
    }
    if (wanted >= segments.size()) {
      atEnd = true;
      return;
    }
    index.seek(cursor, wanted, fromUs);
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
    try {
      cursor.close();
    } finally {
      file.close();
    }
  }

  @Override
  public String toString() {
    return file.path().toString();
  }
}
