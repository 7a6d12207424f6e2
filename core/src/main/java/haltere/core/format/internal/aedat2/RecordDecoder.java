package haltere.core.format.internal.aedat2;

import haltere.core.event.EventPacket;
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
 * Decodes the records of an AEDAT-1.0 or AEDAT-2.0 file. It holds all state: the clock and the
 * offset up to which violations have been counted.
 *
 * <p>Thread rule: one thread.
 */
final class RecordDecoder implements StreamDecoder {
  /** Size of a record of AEDAT-2.0. */
  public static final int AEDAT2_BYTES = 8;

  /** Size of a record of AEDAT-1.0. */
  public static final int AEDAT1_BYTES = 6;

  private static final int RUN = 1024;

  private final AddressDecoder addresses;
  private final int recordBytes;
  private final WrappingClock clock;
  private final WrappingTimes times;
  private final ViolationCounts violations;
  private final long[] run = new long[RUN];
  private long countedTo;

  /**
   * A decoder before the first record.
   *
   * @param addresses meaning of the address words
   * @param recordBytes {@link #AEDAT2_BYTES} or {@link #AEDAT1_BYTES}
   * @param firstTurnUs offset of the file's times, 0 if its header does not state it
   * @param violations counts violations
   */
  public RecordDecoder(
      AddressDecoder addresses, int recordBytes, long firstTurnUs, ViolationCounts violations) {
    if (recordBytes != AEDAT2_BYTES && recordBytes != AEDAT1_BYTES) {
      throw new IllegalArgumentException("records have 6 or 8 bytes, not " + recordBytes);
    }
    this.addresses = addresses;
    this.recordBytes = recordBytes;
    this.violations = violations;
    clock = new WrappingClock(1L << 32, firstTurnUs);
    times = new WrappingTimes(clock);
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int position = start;
    int end = in.limit() - recordBytes;
    while (position <= end && out.size() < maxEvents && !times.restarted()) {
      int records =
          Math.min(Math.min(RUN, maxEvents - out.size()), (in.limit() - position) / recordBytes);
      long at = offset + (position - start);
      if (!decodeRun(in, position, records, at, out)) {
        records = decodeSingly(in, position, records, at, out);
      }
      position += records * recordBytes;
      countedTo = Math.max(countedTo, offset + (position - start));
    }
    in.position(position);
    return times.restarted();
  }

  private boolean decodeRun(ByteBuffer in, int position, int records, long at, EventPacket out) {
    if (recordBytes != AEDAT2_BYTES || !clock.started()) {
      return false;
    }
    boolean counting = at >= countedTo;
    boolean again = at + (long) records * recordBytes <= countedTo;
    if (!counting && !again) {
      return false;
    }
    int before = out.size();
    in.slice(position, records * AEDAT2_BYTES).asLongBuffer().get(run, 0, records);
    int others = addresses.decodeRun(run, records, clock.turnUs(), clock.lastUs(), out);
    if (others < 0) {
      return false;
    }
    if (others > 0 && counting) {
      if (violations.count(Violation.OTHER_DATA) == 0) {
        out.truncate(before);
        return false;
      }
      violations.add(Violation.OTHER_DATA, at, others);
    }
    if (out.size() > before) {
      clock.advance(out.timesUs()[out.size() - 1]);
    }
    return true;
  }

  /** Decodes single records; returns their number before the clock went back. */
  private int decodeSingly(ByteBuffer in, int position, int records, long at, EventPacket out) {
    boolean wide = recordBytes == AEDAT2_BYTES;
    for (int i = 0; i < records; i++) {
      int from = position + i * recordBytes;
      int word = wide ? in.getInt(from) : in.getShort(from) & 0xffff;
      int address = addresses.address(word);
      if (address < 0) {
        count(kind(address), at + (long) i * recordBytes);
        continue;
      }
      long timeUs = clock.read(in.getInt(from + recordBytes - 4));
      if (!times.take(timeUs)) {
        count(StepBack.kind(times), at + (long) i * recordBytes);
        countedTo = Math.max(countedTo, at + (i + 1L) * recordBytes);
        return i;
      }
      out.append(timeUs, address);
    }
    return records;
  }

  private void count(Violation kind, long offset) {
    if (offset >= countedTo) {
      violations.add(kind, offset);
    }
  }

  private static Violation kind(int answer) {
    return switch (answer) {
      case AddressDecoder.OTHER -> Violation.OTHER_DATA;
      case AddressDecoder.OUTSIDE -> Violation.OUTSIDE_SENSOR;
      default -> Violation.UNKNOWN_WORD;
    };
  }

  /**
   * Size of the records that are decoded.
   *
   * @return bytes
   */
  public int recordBytes() {
    return recordBytes;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.wrapping(RecordingClock.Zero.CAMERA_START, 1L << 32);
  }

  @Override
  public EventTimes times() {
    return times;
  }
}
