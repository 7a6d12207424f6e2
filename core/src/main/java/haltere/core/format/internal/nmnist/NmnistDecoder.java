package haltere.core.format.internal.nmnist;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.clock.WrappingClock;
import haltere.core.format.internal.clock.WrappingTimes;
import haltere.core.format.internal.decoding.StepBack;
import haltere.core.format.internal.decoding.StreamDecoder;
import java.nio.ByteBuffer;

/**
 * Decodes the records of N-MNIST and N-Caltech101: big-endian, 8 bits of column, 8 of row, a
 * polarity and 23 bits of time. A row of 240 is not an event: it advances the time of all later
 * records by 8,192 us.
 *
 * <p>Thread rule: one thread.
 */
final class NmnistDecoder implements StreamDecoder {
  /** Size of a record. */
  public static final int RECORD_BYTES = 5;

  static final long TURN_US = 1L << 23;
  private static final int OVERFLOW_ROW = 240;
  private static final long OVERFLOW_US = 1 << 13;
  private static final int TIME_MASK = (1 << 23) - 1;

  private final int width;
  private final int top;
  private final ViolationCounts violations;
  private final WrappingClock clock = new WrappingClock(TURN_US, 0);
  private final WrappingTimes times = new WrappingTimes(clock);
  private long overflowUs;

  /**
   * A decoder before the first record.
   *
   * @param geometry the sensor; events outside are skipped
   * @param violations counts violations
   */
  public NmnistDecoder(SensorGeometry geometry, ViolationCounts violations) {
    width = geometry.width();
    top = geometry.height() - 1;
    this.violations = violations;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int position = start;
    int end = in.limit() - RECORD_BYTES;
    while (position <= end && out.size() < maxEvents && !times.restarted()) {
      position = decodeRun(in, position, end, out, maxEvents);
      if (position <= end
          && out.size() < maxEvents
          && decodeRecord(in, position, offset + (position - start), out)) {
        position += RECORD_BYTES;
      }
    }
    in.position(position);
    return times.restarted();
  }

  /** Decodes up to an irregular record; returns its position. */
  private int decodeRun(ByteBuffer in, int from, int end, EventPacket out, int maxEvents) {
    if (!clock.started()) {
      return from;
    }
    long[] timesUs = out.timesUs();
    int[] addresses = out.addresses();
    int size = out.size();
    int right = width - 1;
    int topRow = top;
    long startUs = clock.turnUs() + overflowUs;
    long lastUs = clock.lastUs();
    int position = from;
    int stop = (int) Math.min(end, from + (maxEvents - size - 1L) * RECORD_BYTES);
    for (; position <= stop; position += RECORD_BYTES) {
      int word = in.getInt(position);
      int x = word >>> 24;
      int row = word >>> 16 & 0xff;
      int y = topRow - row;
      long timeUs = startUs + ((word & 0x7fff) << 8 | in.get(position + 4) & 0xff);
      if ((timeUs - lastUs | y | right - x) < 0
          || row == OVERFLOW_ROW
          || timeUs - lastUs >= TURN_US / 2) {
        break;
      }
      lastUs = timeUs;
      timesUs[size] = timeUs;
      addresses[size++] = y << EventAddress.Y_SHIFT | x << EventAddress.X_SHIFT | word >>> 15 & 1;
    }
    out.setSize(size);
    clock.advance(lastUs);
    return position;
  }

  /** Decodes any record; false if the clock goes back there. */
  private boolean decodeRecord(ByteBuffer in, int position, long offset, EventPacket out) {
    int word = in.getInt(position);
    int x = word >>> 24;
    int row = word >>> 16 & 0xff;
    if (row == OVERFLOW_ROW) {
      overflowUs += OVERFLOW_US;
      violations.add(Violation.OTHER_DATA, offset);
      return true;
    }
    if (x >= width || row > top) {
      violations.add(Violation.OUTSIDE_SENSOR, offset);
      return true;
    }
    int value = (word << 8 | in.get(position + 4) & 0xff) & TIME_MASK;
    long timeUs = clock.read(value + overflowUs);
    if (!times.take(timeUs)) {
      violations.add(StepBack.kind(times), offset);
      return false;
    }
    out.append(timeUs, EventAddress.pack(x, top - row, word >>> 15 & 1));
    return true;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.wrapping(RecordingClock.Zero.RECORDING_START, TURN_US);
  }

  @Override
  public EventTimes times() {
    return times;
  }

  @Override
  public int stateLongs() {
    return WrappingTimes.STATE_LONGS + 1;
  }

  @Override
  public void save(long[] state, int at) {
    times.save(state, at);
    state[at + WrappingTimes.STATE_LONGS] = overflowUs;
  }

  @Override
  public void restore(long[] state, int at) {
    overflowUs = state[at + WrappingTimes.STATE_LONGS];
    times.restore(state, at);
  }
}
