package haltere.core.format.internal.reader;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingOutline;
import haltere.core.format.RecordingReader;
import haltere.core.format.SampleCounts;
import haltere.core.format.TimeSegment;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.format.internal.decoding.SampleCursor;
import haltere.core.format.internal.index.KeptIndex;
import haltere.core.format.internal.index.TimeIndex;
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
 * The reader of every format whose events an {@link EventCursor} can decode: it adds the stream's
 * notifications, finds segments, and seeks. Violations are counted once, even if data are read
 * again.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class DecodingReader implements RecordingReader {
  private enum ReaderState {
    BEFORE_START,
    RUNNING,
    ENDED
  }

  private final String formatName;
  private final RecordingFile file;
  private final SensorGeometry geometry;
  private final List<String> remarks;
  private final KeptIndex indexes;
  private final EventCursor.EventCursors cursors;
  private final ViolationCounts violations;
  private final EventCursor cursor;
  private final PacketBuffer buffer;
  private final Optional<SampleCursor.SampleCursors> samples;
  private final ViolationCounts sampleViolations = new ViolationCounts();

  private ReaderState state = ReaderState.BEFORE_START;
  private long deliveredUs = StreamNotification.NO_TIME_US;
  private boolean sought;
  private TimeIndex index;

  /** Time segment of the samples of a recording without events; null until requested. */
  private List<TimeSegment> sampleSegments;

  /** null if only events are requested */
  private SampleOrder order;

  /**
   * A reader at the start of a recording.
   *
   * @param formatName the format's name
   * @param file the file, closed with the reader
   * @param geometry sensor of the events
   * @param remarks remarks for users on how the file is read
   * @param options size of packets
   * @param violations the violations found so far; receives all others
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
      EventCursor.EventCursors cursors)
      throws IOException {
    this(formatName, file, geometry, remarks, options, violations, cursors, Optional.empty());
  }

  /**
   * A reader at the start of a recording of a format that may hold more than events.
   *
   * @param formatName the format's name
   * @param file the file, closed with the reader
   * @param geometry sensor of the events
   * @param remarks remarks for users on how the file is read
   * @param options size of packets, and whether samples are read
   * @param violations the violations found so far; receives all others
   * @param cursors decode the events
   * @param samples read frames, inertial samples and triggers; used on request only
   * @throws IOException if the file cannot be read
   */
  public DecodingReader(
      String formatName,
      RecordingFile file,
      SensorGeometry geometry,
      List<String> remarks,
      ReadOptions options,
      ViolationCounts violations,
      EventCursor.EventCursors cursors,
      Optional<SampleCursor.SampleCursors> samples)
      throws IOException {
    this.formatName = Objects.requireNonNull(formatName, "formatName");
    this.file = file;
    this.geometry = Objects.requireNonNull(geometry, "geometry");
    this.remarks = new ArrayList<>(remarks);
    this.violations = violations;
    this.cursors = cursors;
    String readAs = String.join("|", formatName, geometry.toString(), options.topic().orElse(""));
    indexes = new KeptIndex(file, readAs, options.keepIndex(), cursors);
    this.samples = file.isStream() ? Optional.empty() : samples;
    if (options.samples() && this.samples.isPresent()) {
      order = new SampleOrder(samples.get().open(sampleViolations));
    }
    cursor = cursors.open(violations);
    buffer = new PacketBuffer(cursor, options.packetEvents());
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
    List<String> all = new ArrayList<>(remarks);
    if (buffer.isUnordered()) {
      all.add("the events are in another order than that of time; sort the file by time");
    }
    if (order != null) {
      order.remark().ifPresent(all::add);
    }
    return List.copyOf(all);
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    switch (state) {
      case BEFORE_START:
        state = ReaderState.RUNNING;
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
              buffer.hasEvents() ? buffer.nextUs() : StreamNotification.NO_TIME_US));
      return true;
    }
    if (!buffer.hasEvents()) {
      buffer.fill();
    }
    if (order != null && isSampleDue()) {
      SensorSample sample = order.take();
      violations.take(Violation.INCOMPLETE_SAMPLE, sampleViolations);
      handler.sample(sample);
    } else if (buffer.hasEvents()) {
      EventPacket events = buffer.take(order == null ? Long.MAX_VALUE : order.nextUs());
      deliveredUs = events.lastTimeUs();
      handler.packet(events);
    } else if (buffer.isBeforeRestart()) {
      deliverRestart(handler);
    } else {
      state = ReaderState.ENDED;
      handler.notified(new EndOfStream(deliveredUs));
    }
    return true;
  }

  /** Whether a frame, an inertial sample or a trigger comes before the next events. */
  private boolean isSampleDue() throws IOException {
    if (buffer.hasEvents()) {
      return order.isDueBefore(buffer.nextUs(), buffer.offset());
    }
    return buffer.isBeforeRestart()
        ? order.isDueBeforeRestart(cursor.positionBytes())
        : order.isDueBeforeEnd();
  }

  private void deliverRestart(StreamHandler handler) {
    Reset reset =
        new Reset(Reset.Cause.CLOCK_RESTARTED, buffer.newestUs(), cursor.times().restartUs());
    if (order != null) {
      order.restarted();
    }
    buffer.acceptRestart();
    handler.notified(reset);
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
  public SampleCounts countSamples() throws IOException {
    if (samples.isEmpty()) {
      return SampleCounts.NONE;
    }
    SampleCounts counts = SampleCounts.NONE;
    try (SampleCursor counter = samples.get().open(new ViolationCounts())) {
      while (nextSample(counter)) {
        counts = counts.plus(counter.sample().kind());
      }
    }
    return counts;
  }

  @Override
  public boolean isSeekable() {
    return !file.isStream();
  }

  @Override
  public List<TimeSegment> segments() throws IOException {
    List<TimeSegment> ofEvents = index().segments();
    return ofEvents.isEmpty() && order != null ? sampleSegments() : ofEvents;
  }

  @Override
  public boolean hasEvents() throws IOException {
    return !index().segments().isEmpty();
  }

  private List<TimeSegment> sampleSegments() throws IOException {
    if (sampleSegments == null) {
      long firstUs = Long.MAX_VALUE;
      long lastUs = Long.MIN_VALUE;
      try (SampleCursor other = samples.orElseThrow().open(new ViolationCounts())) {
        while (nextSample(other)) {
          firstUs = Math.min(firstUs, other.sample().timeUs());
          lastUs = Math.max(lastUs, other.sample().timeUs());
        }
      }
      sampleSegments = firstUs > lastUs ? List.of() : List.of(new TimeSegment(firstUs, lastUs));
    }
    return sampleSegments;
  }

  private boolean nextSample(SampleCursor from) throws IOException {
    if (Thread.currentThread().isInterrupted()) {
      throw new InterruptedIOException("interrupted while reading " + file.path());
    }
    return from.next(Long.MAX_VALUE) == SampleCursor.SampleStep.SAMPLE;
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
    // without segments of events, the only segment is that of the samples
    int wanted = segments.isEmpty() ? 0 : Objects.checkIndex(segment, segments.size());
    if (state == ReaderState.ENDED) {
      state = ReaderState.BEFORE_START;
    }
    sought = true;
    long fromUs = timeUs;
    if (!segments.isEmpty() && segments.get(wanted).lastUs() < fromUs) {
      wanted++;
      fromUs = Long.MIN_VALUE;
    }
    if (wanted >= segments.size()) {
      buffer.moved(StreamNotification.NO_TIME_US, true);
      seekSamplesOutsideOfEvents(segments.isEmpty(), timeUs);
      return;
    }
    if (order != null) {
      Optional<long[]> before = index.stateBefore(wanted, fromUs);
      if (before.isPresent()) {
        order.seek(before.get(), fromUs, index.startOffset(wanted));
      } else {
        startSamples();
        order.dropBefore(fromUs);
      }
    }
    buffer.moved(index.seek(cursor, wanted, fromUs), false);
    buffer.fillFrom(fromUs);
  }

  /** A recording without events may have samples; after the last event there are none. */
  private void seekSamplesOutsideOfEvents(boolean noEvents, long timeUs) throws IOException {
    if (order == null) {
      return;
    }
    startSamples();
    if (noEvents) {
      order.dropBefore(timeUs);
    } else {
      order.seekEnd();
    }
  }

  private void startSamples() throws IOException {
    order.close();
    order = new SampleOrder(samples.orElseThrow().open(sampleViolations));
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
