package haltere.core.format.internal.dat;

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
import java.nio.LongBuffer;

/**
 * Decodes the records of a DAT file: little-endian, 32 bits of time, 32 bits of column, row and
 * polarity.
 *
 * <p>Thread rule: one thread.
 */
final class DatDecoder implements StreamDecoder {
  /** Size of a record. */
  public static final int RECORD_BYTES = 8;

  private static final int RUN = 1024;
  private static final long UNSIGNED = 0xffffffffL;

  // sign bit of values that must not be negative, nor as long as half a wrap period
  private static final long BELOW_ZERO = 1L << 63;
  private static final long HALF_A_TURN = 1L << 31;

  // constants, since the loop over records of version 2 has no free registers
  private static final int X_BITS = 14;
  private static final int Y_BITS = 14;
  private static final int ROW_SHIFT = EventAddress.Y_SHIFT - X_BITS;
  private static final int COLUMN = (1 << X_BITS) - 1 << EventAddress.X_SHIFT;
  private static final int ROW = (1 << Y_BITS) - 1 << EventAddress.Y_SHIFT;

  /**
   * Bit layout of a record's second half.
   *
   * @param xBits bits of the column, from bit 0
   * @param yBits bits of the row, after those of the column; the polarity follows
   */
  public record DatLayout(int xBits, int yBits) {
    /** Layout of version 2 and later. */
    public static final DatLayout VERSION_2 = new DatLayout(X_BITS, Y_BITS);

    /** Layout of the files of the first sensors, of 304x240 pixels. */
    public static final DatLayout VERSION_1 = new DatLayout(9, 8);
  }

  private final int width;
  private final int top;
  private final int xBits;
  private final int yBits;
  private final boolean isVersion2;
  private final ViolationCounts violations;
  private final WrappingClock clock;
  private final WrappingTimes times;

  /** Copied records; an array is read faster than a buffer. */
  private final long[] stage = new long[RUN];

  private final long[] wideAddresses = new long[RUN];

  /**
   * A decoder before the first record.
   *
   * @param geometry the sensor; events outside are skipped
   * @param layout of the records
   * @param firstTurnUs offset of the file's times before the first wrap
   * @param violations counts violations
   */
  public DatDecoder(
      SensorGeometry geometry, DatLayout layout, long firstTurnUs, ViolationCounts violations) {
    width = geometry.width();
    top = geometry.height() - 1;
    xBits = layout.xBits();
    yBits = layout.yBits();
    isVersion2 = layout.equals(DatLayout.VERSION_2);
    this.violations = violations;
    clock = new WrappingClock(1L << 32, firstTurnUs);
    times = new WrappingTimes(clock);
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    LongBuffer words = in.asLongBuffer();
    int start = in.position();
    int position = start;
    int end = start + (in.remaining() & -RECORD_BYTES);
    while (position < end && out.size() < maxEvents && !times.restarted()) {
      int records =
          Math.min(RUN, Math.min(maxEvents - out.size(), (end - position) / RECORD_BYTES));
      words.get((position - start) / RECORD_BYTES, stage, 0, records);
      if (!decodeRun(records, out)) {
        records = decodeSingly(in, position, records, offset + (position - start), out);
      }
      position += records * RECORD_BYTES;
    }
    in.position(position);
    return times.restarted();
  }

  /** Decodes staged records of version 2 if all are regular; otherwise none. */
  private boolean decodeRun(int count, EventPacket out) {
    if (!clock.started() || !isVersion2) {
      return false;
    }
    int size = out.size();
    prepare(count, clock.turnUs(), out.timesUs(), size);
    if (!finish(count, clock.lastUs(), out)) {
      return false;
    }
    out.setSize(size + count);
    clock.advance(out.timeUs(size + count - 1));
    return true;
  }

  /** One integer width and no branch, so that the compiler vectorises the loop. */
  private void prepare(int count, long turnUs, long[] timesUs, int size) {
    long[] records = stage;
    long[] wide = wideAddresses;
    long topRow = (long) top << EventAddress.Y_SHIFT;
    for (int i = 0; i < count; i++) {
      timesUs[size + i] = turnUs + (records[i] & UNSIGNED);
    }
    for (int i = 0; i < count; i++) {
      long word = records[i] >>> 32;
      wide[i] =
          topRow
              - (word << ROW_SHIFT & ROW)
              + (word << EventAddress.X_SHIFT & COLUMN)
              + (word >>> X_BITS + Y_BITS & 1);
    }
  }

  /** Stores the addresses in the packet; false if a record is irregular. */
  private boolean finish(int count, long beforeUs, EventPacket out) {
    long[] wide = wideAddresses;
    long[] timesUs = out.timesUs();
    int[] addresses = out.addresses();
    int size = out.size();
    long right = width - 1L << EventAddress.X_SHIFT;
    long last = beforeUs;
    long odd = 0;
    for (int i = 0; i < count; i++) {
      long address = wide[i];
      long timeUs = timesUs[size + i];
      addresses[size + i] = (int) address;
      odd |= timeUs - last | address | right - (address & COLUMN);
      last = timeUs;
    }
    return (odd & (BELOW_ZERO | HALF_A_TURN)) == 0;
  }

  /** Decodes single records; returns their number before the clock went back. */
  private int decodeSingly(ByteBuffer in, int position, int records, long offset, EventPacket out) {
    for (int i = 0; i < records; i++) {
      int from = position + i * RECORD_BYTES;
      long at = offset + (long) i * RECORD_BYTES;
      int word = in.getInt(from + 4);
      int x = word & (1 << xBits) - 1;
      int y = top - (word >>> xBits & (1 << yBits) - 1);
      if (x >= width || y < 0) {
        violations.add(Violation.OUTSIDE_SENSOR, at);
        continue;
      }
      long timeUs = clock.read(in.getInt(from) & UNSIGNED);
      if (!times.take(timeUs)) {
        violations.add(StepBack.kind(times), at);
        return i;
      }
      out.append(timeUs, EventAddress.pack(x, y, word >>> xBits + yBits & 1));
    }
    return records;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.wrapping(RecordingClock.Zero.WRITERS_CHOICE, 1L << 32);
  }

  @Override
  public EventTimes times() {
    return times;
  }
}
