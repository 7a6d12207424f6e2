package haltere.core.format;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.internal.clock.EventOrder;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Reads a recording split into several files as one: the stream continues from part to part, and so
 * does a segment unless the clock goes back.
 *
 * <p>Thread rule: one thread at a time.
 */
final class PartsReader implements RecordingReader {
  /** The section of a segment in one part. */
  private record Piece(int part, int segment, TimeSegment times) {}

  /** State of the stream of a part. */
  private enum PartState {
    FRESH,
    RUNNING,
    ENDED
  }

  private static final Piece START = new Piece(0, 0, new TimeSegment(0, 0));

  private static final StreamHandler PASSED_OVER =
      new StreamHandler() {
        @Override
        public void packet(EventPacket packet) {
          throw new IllegalStateException("a stream begins with its start");
        }

        @Override
        public void notified(StreamNotification notification) {
          // the joined stream has its own start
        }
      };

  private final Path folder;
  private final List<RecordingReader> parts;
  private final Relay relay = new Relay();
  private final PartState[] states;
  private List<List<Piece>> segments;
  private int current;
  private boolean started;
  private boolean ended;

  /** Whether the stream has continued to the next part and nothing of it has been read. */
  private boolean entering;

  private final EventOrder order = new EventOrder();
  private long lastUs = StreamNotification.NO_TIME_US;

  /** Packet to pass on after a notification of a clock restart; null if there is none. */
  private EventPacket heldPacket;

  private SensorSample heldSample;

  /**
   * Joins parts.
   *
   * @param folder path of the joined recording
   * @param parts at least one, in order, each at its start
   * @throws RecordingProblem if their sensors differ in size
   */
  PartsReader(Path folder, List<RecordingReader> parts) throws IOException {
    this.folder = folder;
    this.parts = List.copyOf(parts);
    states = new PartState[parts.size()];
    Arrays.fill(states, PartState.FRESH);
    SensorGeometry first = geometry();
    for (RecordingReader part : parts) {
      if (!part.geometry().equals(first)) {
        throw new RecordingProblem(
            folder,
            "its parts are of different sensors ("
                + first
                + " and "
                + part.geometry()
                + "); read them one by one");
      }
    }
  }

  /** Filters the stream of a part for the joined stream. */
  private final class Relay implements StreamHandler {
    private StreamHandler out;
    private boolean given;

    @Override
    public void packet(EventPacket packet) {
      given = true;
      boolean isBack = isBack(packet.firstTimeUs());
      order.raise(packet, 0);
      if (isBack) {
        heldPacket = new EventPacket(packet.size());
        heldPacket.append(packet, 0, packet.size());
      } else {
        out.packet(packet);
      }
      entering = false;
      lastUs = packet.lastTimeUs();
    }

    @Override
    public void sample(SensorSample sample) {
      given = true;
      if (isBack(sample.timeUs())) {
        heldSample = sample;
      } else {
        out.sample(sample);
      }
      entering = false;
      lastUs = Math.max(lastUs, sample.timeUs());
    }

    /** Reports a clock restart if the first event of a part is before the last event. */
    private boolean isBack(long timeUs) {
      boolean back = entering && !goesOn(lastUs, timeUs);
      if (back) {
        order.continueAfter(StreamNotification.NO_TIME_US);
        out.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, lastUs, timeUs));
      }
      return back;
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof EndOfStream) {
        states[current] = PartState.ENDED;
        if (current == parts.size() - 1) {
          ended = true;
          deliver(new EndOfStream(lastUs));
        }
      } else if (!started) {
        started = true;
        deliver(new StreamStarted(geometry(), folder.toString()));
      } else {
        if (notification instanceof Reset) {
          order.continueAfter(StreamNotification.NO_TIME_US);
        }
        deliver(notification);
      }
    }

    private void deliver(StreamNotification notification) {
      given = true;
      out.notified(notification);
    }
  }

  @Override
  public boolean next(StreamHandler handler) throws IOException {
    if (heldPacket != null) {
      EventPacket packet = heldPacket;
      heldPacket = null;
      handler.packet(packet);
      return true;
    }
    if (heldSample != null) {
      SensorSample sample = heldSample;
      heldSample = null;
      handler.sample(sample);
      return true;
    }
    relay.out = handler;
    relay.given = false;
    while (!relay.given && !ended) {
      states[current] = PartState.RUNNING;
      parts.get(current).next(relay);
      if (states[current] == PartState.ENDED && !ended) {
        enter(current + 1);
      }
    }
    return relay.given;
  }

  /** Goes to the start of a part, without a notification. */
  private void enter(int part) throws IOException {
    current = part;
    entering = true;
    if (states[part] != PartState.FRESH) {
      parts.get(part).seek(0, Long.MIN_VALUE);
    }
    parts.get(part).next(PASSED_OVER);
    states[part] = PartState.RUNNING;
  }

  @Override
  public List<TimeSegment> segments() throws IOException {
    return pieces().stream().map(PartsReader::span).toList();
  }

  @Override
  public boolean hasEvents() throws IOException {
    for (RecordingReader part : parts) {
      if (part.hasEvents()) {
        return true;
      }
    }
    return false;
  }

  private static boolean goesOn(long lastUs, long firstUs) {
    return firstUs >= lastUs || EventOrder.isLate(lastUs, firstUs);
  }

  private static TimeSegment span(List<Piece> pieces) {
    return new TimeSegment(
        pieces.get(0).times.firstUs(), pieces.get(pieces.size() - 1).times.lastUs());
  }

  private List<List<Piece>> pieces() throws IOException {
    if (segments == null) {
      List<List<Piece>> joined = new ArrayList<>();
      for (int part = 0; part < parts.size(); part++) {
        List<TimeSegment> stretches = parts.get(part).segments();
        for (int segment = 0; segment < stretches.size(); segment++) {
          TimeSegment times = stretches.get(segment);
          boolean isNext =
              segment == 0
                  && !joined.isEmpty()
                  && goesOn(span(joined.get(joined.size() - 1)).lastUs(), times.firstUs());
          if (!isNext) {
            joined.add(new ArrayList<>());
          }
          joined.get(joined.size() - 1).add(new Piece(part, segment, times));
        }
      }
      segments = joined;
    }
    return segments;
  }

  @Override
  public void seek(int segment, long timeUs) throws IOException {
    List<List<Piece>> all = pieces();
    Piece position = START;
    long fromUs = timeUs;
    if (!all.isEmpty()) {
      boolean behind = span(all.get(segment)).lastUs() < timeUs && segment < all.size() - 1;
      position = behind ? all.get(segment + 1).get(0) : position(all.get(segment), timeUs);
      fromUs = behind ? Long.MIN_VALUE : timeUs;
    }
    current = position.part;
    entering = false;
    order.continueAfter(StreamNotification.NO_TIME_US);
    heldPacket = null;
    heldSample = null;
    if (ended) {
      ended = false;
      started = false;
      lastUs = StreamNotification.NO_TIME_US;
    }
    parts.get(current).seek(position.segment, fromUs);
    if (started && states[current] != PartState.RUNNING) {
      parts.get(current).next(PASSED_OVER);
      parts.get(current).seek(position.segment, fromUs);
      states[current] = PartState.RUNNING;
    }
  }

  /** The piece that reaches a time, or the last one. */
  private static Piece position(List<Piece> pieces, long timeUs) {
    for (Piece piece : pieces) {
      if (piece.times.lastUs() >= timeUs) {
        return piece;
      }
    }
    return pieces.get(pieces.size() - 1);
  }

  @Override
  public SensorGeometry geometry() {
    return parts.get(0).geometry();
  }

  @Override
  public String formatName() {
    return parts.get(0).formatName();
  }

  @Override
  public Path path() {
    return folder;
  }

  @Override
  public long positionBytes() {
    long bytes = parts.get(current).positionBytes();
    for (RecordingReader part : parts.subList(0, current)) {
      bytes += part.sizeBytes();
    }
    return bytes;
  }

  @Override
  public long sizeBytes() {
    return parts.stream().mapToLong(RecordingReader::sizeBytes).sum();
  }

  @Override
  public ViolationCounts violations() {
    ViolationCounts all = new ViolationCounts();
    long before = 0;
    for (RecordingReader part : parts) {
      for (Violation kind : Violation.values()) {
        all.add(kind, before + part.violations().firstOffset(kind), part.violations().count(kind));
      }
      before += part.sizeBytes();
    }
    return all;
  }

  @Override
  public List<String> remarks() {
    List<String> all = new ArrayList<>();
    all.add("read as one recording of " + parts.size() + " parts");
    parts.forEach(part -> part.remarks().stream().filter(r -> !all.contains(r)).forEach(all::add));
    return all;
  }

  @Override
  public RecordingClock clock() {
    return parts.get(0).clock();
  }

  @Override
  public Map<String, String> metadata() {
    return parts.get(0).metadata();
  }

  @Override
  public Optional<String> compression() {
    return parts.get(0).compression();
  }

  @Override
  public Optional<RecordingOutline> outline() throws IOException {
    RecordingOutline whole = RecordingOutline.NOTHING;
    for (RecordingReader part : parts) {
      Optional<RecordingOutline> outline = part.outline();
      if (outline.isEmpty()) {
        return Optional.empty();
      }
      whole = whole.plus(outline.get());
    }
    return Optional.of(whole);
  }

  @Override
  public SampleCounts countSamples() throws IOException {
    SampleCounts counts = SampleCounts.NONE;
    for (RecordingReader part : parts) {
      counts = counts.plus(part.countSamples());
    }
    return counts;
  }

  @Override
  public void close() throws IOException {
    IOException broken = null;
    for (RecordingReader part : parts) {
      try {
        part.close();
      } catch (IOException problem) {
        broken = problem;
      }
    }
    if (broken != null) {
      throw broken;
    }
  }

  @Override
  public String toString() {
    return folder.toString();
  }
}
