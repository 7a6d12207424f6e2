package haltere.testing;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingReader;
import haltere.core.format.TimeSegment;
import haltere.core.format.ViolationCounts;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeMap;
import java.util.function.IntSupplier;

/**
 * A recording in memory: packets of ascending times; the clock restarts where one starts before the
 * end of the previous one. It reuses one packet, as readers do, with the size set by the test.
 */
public final class MemoryRecording implements RecordingReader {
  private final SensorGeometry geometry;
  private final List<EventPacket> segments;
  private final IntSupplier packetSizes;
  private final TreeMap<Integer, Long> losses = new TreeMap<>();
  private final EventPacket lent = new EventPacket(0);
  private final ViolationCounts violations = new ViolationCounts();
  private StreamNotification before;
  private int segment;
  private int index;
  private boolean untouched = true;
  private boolean ended;
  private boolean closed;
  private long failAtUs = Long.MAX_VALUE;

  /**
   * A recording.
   *
   * @param geometry its sensor
   * @param packetSizes asked for the number of events of each packet that it hands out
   * @param segments stretches of time, none empty
   */
  public MemoryRecording(
      SensorGeometry geometry, IntSupplier packetSizes, EventPacket... segments) {
    this.geometry = geometry;
    this.packetSizes = packetSizes;
    this.segments = List.of(segments);
    before = new StreamStarted(geometry, "memory");
  }

  /**
   * A recording of one stretch, in packets of 1000 events.
   *
   * @param geometry its sensor
   * @param events all events
   */
  public MemoryRecording(SensorGeometry geometry, EventPacket events) {
    this(geometry, () -> 1000, events);
  }

  /**
   * Removes events from the first segment.
   *
   * @param index of the event after the gap
   * @param count stated number of lost events
   * @return this
   */
  public MemoryRecording losing(int index, long count) {
    losses.put(index, count);
    return this;
  }

  /**
   * Lets reading fail.
   *
   * @param timeUs at the first packet that reaches this time
   * @return this
   */
  public MemoryRecording failingAt(long timeUs) {
    failAtUs = timeUs;
    return this;
  }

  /**
   * Whether it has been closed.
   *
   * @return true afterwards
   */
  public boolean closed() {
    return closed;
  }

  @Override
  public String formatName() {
    return "memory";
  }

  @Override
  public Path path() {
    return Path.of("memory");
  }

  @Override
  public long positionBytes() {
    return index;
  }

  @Override
  public long sizeBytes() {
    return segments.stream().mapToLong(EventPacket::size).sum();
  }

  @Override
  public ViolationCounts violations() {
    return violations;
  }

  @Override
  public List<String> remarks() {
    return List.of();
  }

  @Override
  public List<TimeSegment> segments() {
    List<TimeSegment> found = new ArrayList<>();
    for (EventPacket packet : segments) {
      found.add(new TimeSegment(packet.firstTimeUs(), packet.lastTimeUs()));
    }
    return found;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.WRITERS_CHOICE);
  }

  @Override
  public SensorGeometry geometry() {
    return geometry;
  }

  @Override
  public void seek(int toSegment, long timeUs) {
    if (!untouched) {
      before = ended ? new StreamStarted(geometry, "memory") : new Reset(Reset.Cause.SEEK);
    }
    ended = false;
    segment = toSegment;
    index = segments.isEmpty() ? 0 : segments.get(toSegment).indexAtOrAfter(timeUs);
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    if (ended) {
      return false;
    }
    untouched = false;
    if (before != null) {
      StreamNotification now = before;
      before = null;
      handler.notified(now);
      return true;
    }
    if (segment < segments.size() && index >= segments.get(segment).size()) {
      index = 0;
      segment++;
      if (segment < segments.size()) {
        handler.notified(
            new Reset(
                Reset.Cause.CLOCK_RESTARTED,
                segments.get(segment - 1).lastTimeUs(),
                segments.get(segment).firstTimeUs()));
        return true;
      }
    }
    if (segment >= segments.size()) {
      ended = true;
      handler.notified(
          new EndOfStream(
              segments.isEmpty()
                  ? StreamNotification.NO_TIME_US
                  : segments.get(segments.size() - 1).lastTimeUs()));
      return true;
    }
    hand(handler);
    return true;
  }

  private void hand(StreamHandler handler) throws IOException {
    EventPacket all = segments.get(segment);
    int end = Math.min(all.size(), index + packetSizes.getAsInt());
    if (segment == 0) {
      Integer loss = losses.higherKey(index);
      end = loss == null ? end : Math.min(end, loss);
    }
    if (end > index && all.timeUs(end - 1) >= failAtUs) {
      throw new IOException("memory: the disk is gone; plug it in again");
    }
    lent.clear();
    lent.append(all, index, end);
    index = end;
    if (segment == 0 && losses.containsKey(end)) {
      before = new DataLost(-1, losses.get(end), all.timeUs(end - 1), all.timeUs(end), "the test");
    }
    handler.packet(lent);
  }

  @Override
  public void close() {
    closed = true;
  }
}
