package haltere.core.format;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorReading;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

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
  private final KeptIndex indexes;
  private final EventCursor.Factory cursors;
  private final ViolationCounts violations;
  private final EventCursor cursor;
  private final EventPacket packet = new EventPacket(0);
  private final Optional<ReadingCursor.Factory> readings;
  private final ViolationCounts readingViolations = new ViolationCounts();
  private final EventPacket piece = new EventPacket(0);

  private State state = State.BEFORE_START;
  private long deliveredUs = StreamNotification.NO_TIME_US;
  private boolean restart;
  private boolean atEnd;
  private boolean sought;
  private boolean primed;
  private TimeIndex index;
  private ReadingOrder order;
  private int given;
  private long packetOffset;

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
    this(formatName, file, geometry, remarks, options, violations, cursors, Optional.empty());
  }

  /**
   * A reader at the start of a recording of a format that may hold more than events.
   *
   * @param formatName the format's name
   * @param file the file, closed with the reader
   * @param geometry sensor of the events
   * @param remarks what a user should know about how the file is read
   * @param options how large packets are, and whether readings are wanted
   * @param violations what was found wrong up to now, and where everything else is counted
   * @param cursors decode the events
   * @param readings read frames, inertial samples and triggers; asked only if those are wanted
   * @throws IOException if the file cannot be read
   */
  public DecodingReader(
      String formatName,
      RecordingFile file,
      SensorGeometry geometry,
      List<String> remarks,
      ReadOptions options,
      ViolationCounts violations,
      EventCursor.Factory cursors,
      Optional<ReadingCursor.Factory> readings)
      throws IOException {
    this.formatName = Objects.requireNonNull(formatName, "formatName");
    this.file = file;
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.remarks = new ArrayList<>(remarks);
    packetEvents = options.packetEvents();
    this.violations = violations;
    this.cursors = cursors;
    String reading = String.join("|", formatName, geometry.toString(), options.topic().orElse(""));
    indexes = new KeptIndex(file, reading, options.keepIndex(), cursors);
    this.readings = file.isStream() ? Optional.empty() : readings;
    if (options.readings() && this.readings.isPresent()) {
      order = new ReadingOrder(readings.get().open(readingViolations));
    }
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
    return List.copyOf(remarks);
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
    if (order != null) {
      nextOrdered(handler);
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
    } else {
      giveNotification(handler);
    }
    return true;
  }

  private void giveNotification(StreamHandler handler) {
    if (restart) {
      restart = false;
      Reset reset =
          new Reset(
              Reset.Cause.CLOCK_RESTARTED, cursor.times().lastUs(), cursor.times().restartUs());
      cursor.times().acceptRestart();
      handler.notified(reset);
    } else {
      state = State.ENDED;
      handler.notified(new EndOfStream(deliveredUs));
    }
  }

  /** As {@link #next}, with readings between the events. */
  private void nextOrdered(StreamHandler handler) throws IOException {
    if (!primed) {
      packet.clear();
      given = 0;
      packetOffset = cursor.positionBytes();
      fill();
      primed = !packet.isEmpty();
    }
    if (primed) {
      if (order.isDueBefore(packet.timeUs(given), packetOffset)) {
        giveReading(handler);
      } else {
        giveEvents(handler, packet.indexAtOrAfter(order.nextUs(), given));
      }
    } else if (restart
        ? order.isDueBeforeRestart(cursor.positionBytes())
        : order.isDueBeforeEnd()) {
      giveReading(handler);
    } else {
      if (restart) {
        order.restarted();
      }
      giveNotification(handler);
    }
  }

  private void giveReading(StreamHandler handler) {
    SensorReading reading = order.take();
    violations.take(Violation.INCOMPLETE_READING, readingViolations);
    handler.reading(reading);
  }

  private void giveEvents(StreamHandler handler, int to) {
    deliveredUs = packet.timeUs(to - 1);
    int from = given;
    given = to;
    primed = to < packet.size();
    if (from == 0 && !primed) {
      handler.packet(packet);
      return;
    }
    piece.clear();
    piece.append(packet, from, to);
    handler.packet(piece);
  }

  @Override
  public RecordingClock clock() {
    return cursor.clock();
  }

  @Override
  public Map<String, String> metadata() {
    return cursor.metadata();
  }

  @Override
  public Optional<String> compression() {
    return cursor.compression();
  }

  @Override
  public Optional<RecordingOutline> outline() throws IOException {
    try (EventCursor other = cursors.open(new ViolationCounts())) {
      return other.outline();
    }
  }

  @Override
  public ReadingCounts countReadings() throws IOException {
    if (readings.isEmpty()) {
      return ReadingCounts.NONE;
    }
    ReadingCounts counts = ReadingCounts.NONE;
    try (ReadingCursor counter = readings.get().open(new ViolationCounts())) {
      while (counter.next(Long.MAX_VALUE) == ReadingCursor.Step.READING) {
        if (Thread.currentThread().isInterrupted()) {
          throw new InterruptedIOException("interrupted while reading " + file.path());
        }
        counts = counts.plus(counter.reading().kind());
      }
    }
    return counts;
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
  public boolean isSeekable() {
    return !file.isStream();
  }

  @Override
  public List<TimeSegment> segments() throws IOException {
    return index().segments();
  }

  private TimeIndex index() throws IOException {
    if (index == null) {
      index = indexes.find(cursor, remarks);
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
      seekReadingsOutsideOfEvents(segments.isEmpty(), timeUs);
      return;
    }
    if (order != null) {
      order.seek(index.stateBefore(wanted, fromUs), fromUs, index.startOffset(wanted));
    }
    index.seek(cursor, wanted, fromUs);
    dropBefore(fromUs);
  }

  /** A recording without events may hold readings; behind the last event there is nothing. */
  private void seekReadingsOutsideOfEvents(boolean noEvents, long timeUs) throws IOException {
    if (order == null) {
      return;
    }
    order.close();
    order = new ReadingOrder(readings.orElseThrow().open(readingViolations));
    if (noEvents) {
      order.dropBefore(timeUs);
    } else {
      order.seekEnd();
    }
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
    given = 0;
    packetOffset = cursor.positionBytes();
    primed = kept > 0;
  }

  @Override
  public void close() throws IOException {
    try {
      cursor.close();
      if (order != null) {
        order.close();
      }
    } finally {
      file.close();
    }
  }

  @Override
  public String toString() {
    return file.path().toString();
  }
}
