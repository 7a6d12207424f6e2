package haltere.core.format.internal.aedat4;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingOutline;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.AscendingTimes;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.format.internal.decoding.StepBack;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Decodes the events of one stream of an AEDAT-4 file: 16 bytes each, time in microseconds as 64
 * bits, column and row as 16 bits, polarity as a byte.
 *
 * <p>Thread rule: one thread.
 */
final class Aedat4Cursor implements EventCursor {
  static final int EVENT_BYTES = 16;

  /** Number of values of a cursor's state. */
  static final int STATE_LONGS = 3;

  /** Packets decoded in order before a second thread is started. */
  private static final int PACKETS_ALONE = 8;

  /** Maximum number of restarts of that thread after damage. */
  private static final int MAX_RESTARTS = 16;

  /** Events per decoded run. */
  static final int RUN = 1024;

  private static final long POLARITY = 1L << 32;

  private final SensorGeometry geometry;
  private final EventRun events;
  private final Layout layout;
  private final long fileBytes;
  private final Path path;
  private final RecordingFile file;
  private final int eventStream;
  private final ViolationCounts violations;
  private final Decompressor decompressor;
  private final PacketWalk walk;

  private DecodeAhead ahead;
  private DecodeAhead.Slot slot;
  private boolean alone;
  private int packetsInOrder;
  private long bytesInOrder;
  private int restarts;
  private boolean inPacket;
  private long count;
  private long index;
  private final AscendingTimes times = new AscendingTimes();

  Aedat4Cursor(
      RecordingFile file,
      Layout layout,
      SensorGeometry geometry,
      int eventStream,
      ViolationCounts violations) {
    this.geometry = geometry;
    events = new EventRun(geometry);
    this.layout = layout;
    fileBytes = file.size();
    path = file.path();
    this.file = file;
    this.eventStream = eventStream;
    this.violations = violations;
    decompressor = new Decompressor(file);
    walk = layout.walk(decompressor.window(), violations);
  }

  /**
   * Layout of the packets of a file.
   *
   * @param known numbers of its streams
   * @param start offset of the first packet
   * @param end end of the packets
   * @param cutOff whether the file is truncated there
   * @param metadata of the file
   * @param compression stated compression of the packets
   */
  record Layout(
      Set<Integer> known,
      long start,
      long end,
      boolean cutOff,
      Map<String, String> metadata,
      Optional<Aedat4Compression> compression) {
    PacketWalk walk(FileWindow window, ViolationCounts violations) {
      return new PacketWalk(window, known, start, end, cutOff, violations);
    }
  }

  @Override
  public Stop read(EventPacket out, int maxEvents) throws IOException {
    out.ensureCapacity(maxEvents);
    while (out.size() < maxEvents) {
      if (!inPacket && !nextPacket()) {
        return Stop.END;
      }
      try {
        if (decode(out, maxEvents)) {
          return Stop.CLOCK_WENT_BACK;
        }
      } catch (DamagedPacketException e) {
        damaged();
      }
    }
    return Stop.MORE;
  }

  /** Opens the next packet of the selected stream. */
  private boolean nextPacket() throws IOException {
    while (walk.find()) {
      if (walk.stream() != eventStream) {
        violations.add(Violation.OTHER_DATA, walk.position());
        walk.pass();
        violations.reached(walk.position());
        continue;
      }
      try {
        openPacket();
        return true;
      } catch (DamagedPacketException e) {
        damaged();
      }
    }
    return false;
  }

  private void openPacket() throws IOException, DamagedPacketException {
    if (takeDecodedAhead()) {
      count = slot.events().size();
    } else {
      decompressor.open(walk.payload(), walk.size());
      count = decompressor.events();
    }
    index = 0;
    inPacket = true;
  }

  /** Uses the packet if it is decoded already; starts the decoding thread if it is worthwhile. */
  private boolean takeDecodedAhead() throws IOException {
    if (ahead == null && !startAhead()) {
      return false;
    }
    if (slot != null) {
      ahead.release();
    }
    slot = ahead.take();
    if (slot == null || slot.position() != walk.position()) {
      // an interrupt, or damage after which the positions differ
      stopAhead();
      alone = ++restarts > MAX_RESTARTS;
      return false;
    }
    return slot.isDecoded();
  }

  private boolean startAhead() throws IOException {
    bytesInOrder += walk.size();
    if (alone
        || ++packetsInOrder <= PACKETS_ALONE
        || bytesInOrder < (long) packetsInOrder * DecodeAhead.MIN_PACKET_BYTES
        || !isPacked()) {
      return false;
    }
    ahead = new DecodeAhead(path, layout, geometry, eventStream, walk.position());
    walk.setWindow(new FileWindow(file, DecodeAhead.HEADER_WINDOW));
    return true;
  }

  private boolean isPacked() throws IOException {
    int at = walk.size() < 4 ? -1 : decompressor.window().require(walk.payload(), 4);
    return at >= 0
        && LittleEndian.getInt(decompressor.window().bytes(), at) != walk.size() - 4
        && Runtime.getRuntime().availableProcessors() > 1;
  }

  private void stopAhead() throws IOException {
    slot = null;
    packetsInOrder = 0;
    bytesInOrder = 0;
    if (ahead != null) {
      ahead.close();
      ahead = null;
      walk.setWindow(decompressor.window());
    }
  }

  private void damaged() throws IOException {
    inPacket = false;
    violations.add(Violation.DAMAGED_PACKET, walk.position());
    walk.passDamaged();
    violations.reached(walk.position());
  }

  /** File offset of an event, as if the packet were uncompressed. */
  private long offset(long event) {
    return walk.payload() + (count == 0 ? 0 : (long) ((double) walk.size() * event / count));
  }

  /** Returns true if the clock goes back with the event at the index. */
  private boolean decode(EventPacket out, int maxEvents)
      throws IOException, DamagedPacketException {
    if (slot != null && slot.isDecoded() && index < count && copy(out, maxEvents)) {
      return true;
    }
    while (index < count && out.size() < maxEvents) {
      int there = (decompressor.to() - decompressor.from()) / EVENT_BYTES;
      if (there == 0) {
        if (!decompressor.more()) {
          throw new DamagedPacketException("fewer events than it says");
        }
        continue;
      }
      long left = Math.min(Math.min(there, count - index), maxEvents - out.size());
      int run = (int) Math.min(left, RUN);
      int done = decodeRun(run, out) ? run : decodeSingly(run, out);
      decompressor.use(done * EVENT_BYTES);
      index += done;
      violations.reached(offset(index));
      if (done < run) {
        return true;
      }
    }
    if (index >= count) {
      inPacket = false;
      walk.pass();
      violations.reached(walk.position());
    }
    return false;
  }

  /** Copies events of a decoded packet; returns true if the clock goes back with it. */
  private boolean copy(EventPacket out, int maxEvents) {
    EventPacket decoded = slot.events();
    int from = (int) index;
    if (times.goesBack(decoded.timeUs(from))) {
      violations.add(StepBack.kind(times), offset(index));
      return true;
    }
    int to = Math.min(decoded.size(), from + maxEvents - out.size());
    out.append(decoded, from, to);
    times.advance(out.lastTimeUs());
    index = to;
    violations.reached(offset(index));
    return false;
  }

  /** Decodes events if all are regular; otherwise none. */
  private boolean decodeRun(int run, EventPacket out) {
    if (times.lastUs() == StreamNotification.NO_TIME_US
        || !events.decode(decompressor.data(), decompressor.from(), run, times.lastUs(), out)) {
      return false;
    }
    times.advance(out.lastTimeUs());
    return true;
  }

  /** Returns the number decoded before the clock went back. */
  private int decodeSingly(int events, EventPacket out) {
    boolean top = geometry.origin() == Origin.TOP;
    for (int i = 0; i < events; i++) {
      int at = decompressor.from() + i * EVENT_BYTES;
      long time = LittleEndian.getLong(decompressor.data(), at);
      long word = LittleEndian.getLong(decompressor.data(), at + 8);
      int x = (short) word;
      int y = (short) (word >>> 16);
      if (!geometry.contains(x, y)) {
        violations.add(Violation.OUTSIDE_SENSOR, offset(index + i));
        continue;
      }
      if (times.goesBack(time)) {
        violations.add(StepBack.kind(times), offset(index + i));
        return i;
      }
      times.advance(time);
      boolean on = (word & 0xff * POLARITY) != 0;
      out.append(time, x, top ? geometry.height() - 1 - y : y, on);
    }
    return events;
  }

  @Override
  public Map<String, String> metadata() {
    return layout.metadata();
  }

  @Override
  public Optional<String> compression() {
    return layout.compression().map(Aedat4Compression::words);
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.WRITERS_CHOICE);
  }

  @Override
  public EventTimes times() {
    return times;
  }

  @Override
  public long positionBytes() {
    if (inPacket) {
      return offset(index);
    }
    return walk.position() < layout.end() ? walk.position() : fileBytes;
  }

  @Override
  public long streamNumber() {
    return eventStream;
  }

  @Override
  public boolean visitPieces(PieceVisitor visitor) throws IOException {
    Optional<PacketTable> table = PacketTable.readTable(file, layout, eventStream);
    if (table.isPresent()) {
      table.get().visit(visitor);
    }
    return table.isPresent();
  }

  @Override
  public Optional<RecordingOutline> outline() throws IOException {
    return PacketTable.readTable(file, layout, eventStream).map(PacketTable::outline);
  }

  @Override
  public int stateLongs() {
    return STATE_LONGS;
  }

  /** The state that {@link #save} writes before a packet. */
  static void save(long[] state, long position, long lastUs) {
    state[0] = position;
    state[1] = 0;
    state[2] = lastUs;
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = walk.position();
    state[at + 1] = inPacket ? index : 0;
    times.save(state, at + 2);
  }

  @Override
  public void restore(long[] state, int at) throws IOException {
    walk.moveTo(state[at]);
    stopAhead();
    alone = false;
    inPacket = false;
    times.restore(state, at + 2);
    long skipped = state[at + 1];
    if (skipped > 0 && nextPacket()) {
      try {
        decompressor.skip(Math.min(skipped, count) * EVENT_BYTES);
        index = Math.min(skipped, count);
      } catch (DamagedPacketException e) {
        damaged();
      }
    }
  }

  @Override
  public void close() throws IOException {
    try {
      stopAhead();
    } finally {
      decompressor.close();
    }
  }
}
