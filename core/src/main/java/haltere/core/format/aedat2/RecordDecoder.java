package haltere.core.format.aedat2;

import haltere.core.event.EventPacket;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.stream.StreamNotification;
import java.nio.ByteBuffer;

/**
 * Turns the records of an AEDAT-1.0 or AEDAT-2.0 file into packets: bytes in, events out. All state
 * is here: the clock, and how far violations have been counted.
 *
 * <p>Thread rule: one thread.
 */
public final class RecordDecoder {
  /** Size of a record of AEDAT-2.0. */
  public static final int AEDAT2_BYTES = 8;

  /** Size of a record of AEDAT-1.0. */
  public static final int AEDAT1_BYTES = 6;

  private static final int RUN = 1024;

  private final AddressDecoder addresses;
  private final int recordBytes;
  private final RecordClock clock;
  private final ViolationCounts violations;
  private final long[] run = new long[RUN];
  private long countedTo;
  private boolean restarted;
  private long restartUs;

  /**
   * A decoder before the first record.
   *
   * @param addresses meaning of the address words
   * @param recordBytes {@link #AEDAT2_BYTES} or {@link #AEDAT1_BYTES}
   * @param firstTurnUs what to add to the file's times, 0 where its header does not say
   * @param violations where to count what is wrong
   */
  public RecordDecoder(
      AddressDecoder addresses, int recordBytes, long firstTurnUs, ViolationCounts violations) {
    if (recordBytes != AEDAT2_BYTES && recordBytes != AEDAT1_BYTES) {
      throw new IllegalArgumentException("records have 6 or 8 bytes, not " + recordBytes);
    }
    this.addresses = addresses;
    this.recordBytes = recordBytes;
    this.violations = violations;
    clock = new RecordClock(firstTurnUs);
  }

  /**
   * Decodes records until the input holds no whole record, the packet is full, or the clock goes
   * back. Violations are counted only at offsets that no call has reached before.
   *
   * @param in big-endian bytes from a record's start; its position is moved behind what was decoded
   * @param offset of that position in the file
   * @param out events are appended
   * @param maxEvents events that the packet may hold
   * @return true if the clock went back at the input's position: the record there has not been
   *     decoded and will be, as the first of a new segment, after {@link #acceptRestart()}
   */
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int position = start;
    int end = in.limit() - recordBytes;
    while (position <= end && out.size() < maxEvents && !restarted) {
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
    return restarted;
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

  /** Record by record; returns how many were dealt with before the clock went back. */
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
      if (clock.goesBack(timeUs)) {
        restarted = true;
        restartUs = timeUs;
        count(Violation.CLOCK_WENT_BACK, at + (long) i * recordBytes);
        countedTo = Math.max(countedTo, at + (i + 1L) * recordBytes);
        return i;
      }
      clock.take(timeUs);
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

  /**
   * Time of the last event.
   *
   * @return microseconds, or {@link StreamNotification#NO_TIME_US} before the first
   */
  public long lastUs() {
    return clock.started() ? clock.lastUs() : StreamNotification.NO_TIME_US;
  }

  /**
   * What is being added to the file's times.
   *
   * @return microseconds
   */
  public long turnUs() {
    return clock.turnUs();
  }

  /**
   * Time of the first event of the new segment, after {@link #decode} said that the clock went
   * back.
   *
   * @return microseconds
   */
  public long restartUs() {
    return restartUs;
  }

  /** Goes on after the clock went back. */
  public void acceptRestart() {
    if (!restarted) {
      throw new IllegalStateException("the clock did not go back");
    }
    restarted = false;
    clock.take(restartUs);
  }

  /**
   * Starts anew at any record, without memory of a last time.
   *
   * @param turnUs what to add to the file's times
   */
  public void reset(long turnUs) {
    restarted = false;
    clock.reset(turnUs);
  }

  /**
   * Goes on at a record in the middle, as if what was before had been decoded.
   *
   * @param turnUs what to add to the file's times
   * @param lastUs time of the last event before
   */
  public void resume(long turnUs, long lastUs) {
    restarted = false;
    clock.resume(turnUs, lastUs);
  }
}
