package haltere.core.format.internal.eventstream;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.AscendingTimes;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.decoding.StreamDecoder;
import java.nio.ByteBuffer;

/**
 * Decodes an Event Stream: a byte states the time step and the data that follow. The clock of the
 * format cannot go back.
 *
 * <p>Thread rule: one thread.
 */
final class EventStreamDecoder implements StreamDecoder {
  /** Kind of the events. */
  public enum StreamKind {
    /** Messages of any bytes. */
    GENERIC,
    /** Pixel events. */
    DVS,
    /** Pixel events and the two ends of exposure measurements. */
    ATIS,
    /** Pixels with a colour. */
    COLOUR
  }

  private static final int EVENT_BYTES = 5;
  private static final int COLOUR_BYTES = 8;
  private static final int RESET = 0xfe;
  private static final int OVERFLOW = 0xff;
  private static final long EIGHT_OVERFLOWS = -1;
  private static final int DVS_OVERFLOW_US = 0x7f;
  private static final int WIDE_OVERFLOW_US = 0xfe;
  private static final int ATIS_OVERFLOW = 0xfc;
  private static final int ATIS_OVERFLOW_US = 0x3f;
  private static final int MAX_COUNT = 5;

  private final StreamKind kind;
  private final int width;
  private final int top;
  private final boolean exposures;
  private final ViolationCounts violations;
  private long timeUs;
  private final AscendingTimes times = new AscendingTimes();
  private long skip;

  /**
   * A decoder before the first byte after the header.
   *
   * @param kind of the events
   * @param geometry the sensor; events outside are skipped
   * @param violations counts violations
   */
  public EventStreamDecoder(StreamKind kind, SensorGeometry geometry, ViolationCounts violations) {
    this(kind, geometry, false, violations);
  }

  /** With {@code exposures}, exposure measurements are decoded as pixel events too. */
  EventStreamDecoder(
      StreamKind kind, SensorGeometry geometry, boolean exposures, ViolationCounts violations) {
    this.kind = kind;
    this.exposures = exposures;
    this.violations = violations;
    width = geometry.width();
    top = geometry.height() - 1;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    long from = offset - in.position();
    int before = out.size();
    int position =
        switch (kind) {
          case DVS -> decodeDvs(in, from, out, maxEvents);
          case ATIS -> decodeAtis(in, from, out, maxEvents);
          case COLOUR -> decodeColour(in, from);
          case GENERIC -> decodeGeneric(in, from);
        };
    if (out.size() > before) {
      times.advance(out.lastTimeUs());
    }
    in.position(position);
    return false;
  }

  private int decodeDvs(ByteBuffer in, long from, EventPacket out, int maxEvents) {
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int size = out.size();
    int right = width - 1;
    int topRow = top;
    long now = timeUs;
    int end = in.limit();
    int position = in.position();
    while (position < end && size < maxEvents) {
      int first = in.get(position) & 0xff;
      if (first < RESET) {
        if (position + EVENT_BYTES > end) {
          break;
        }
        int pixel = in.getInt(position + 1);
        int x = pixel & 0xffff;
        int y = topRow - (pixel >>> 16);
        now += first >>> 1;
        if ((y | right - x) >= 0) {
          times[size] = now;
          addresses[size++] = y << EventAddress.Y_SHIFT | x << EventAddress.X_SHIFT | first & 1;
        } else {
          violations.add(Violation.OUTSIDE_SENSOR, from + position);
        }
        position += EVENT_BYTES;
      } else if (position + Long.BYTES <= end && in.getLong(position) == EIGHT_OVERFLOWS) {
        now += Long.BYTES * DVS_OVERFLOW_US;
        position += Long.BYTES;
      } else {
        now += first == OVERFLOW ? DVS_OVERFLOW_US : 0;
        position++;
      }
    }
    timeUs = now;
    out.setSize(size);
    return position;
  }

  private int decodeAtis(ByteBuffer in, long from, EventPacket out, int maxEvents) {
    int end = in.limit();
    int position = in.position();
    while (position < end && out.size() < maxEvents) {
      int first = in.get(position) & 0xff;
      if ((first & ATIS_OVERFLOW) == ATIS_OVERFLOW) {
        timeUs += (long) ATIS_OVERFLOW_US * (first & 3);
        position++;
        continue;
      }
      if (position + EVENT_BYTES > end) {
        break;
      }
      int x = in.getShort(position + 1) & 0xffff;
      int y = top - (in.getShort(position + 3) & 0xffff);
      timeUs += first >>> 2;
      if ((first & 1) != 0 && !exposures) {
        violations.add(Violation.OTHER_DATA, from + position);
      } else if (x >= width || y < 0) {
        violations.add(Violation.OUTSIDE_SENSOR, from + position);
      } else {
        out.append(timeUs, EventAddress.pack(x, y, first >>> 1 & 1));
      }
      position += EVENT_BYTES;
    }
    return position;
  }

  private int decodeColour(ByteBuffer in, long from) {
    int end = in.limit();
    int position = in.position();
    while (position < end) {
      int first = in.get(position) & 0xff;
      if (first >= RESET) {
        timeUs += first == OVERFLOW ? WIDE_OVERFLOW_US : 0;
        position++;
      } else if (position + COLOUR_BYTES > end) {
        break;
      } else {
        timeUs += first;
        violations.add(Violation.OTHER_DATA, from + position);
        position += COLOUR_BYTES;
      }
    }
    return position;
  }

  private int decodeGeneric(ByteBuffer in, long from) {
    int end = in.limit();
    int position = in.position();
    while (position < end) {
      int skipped = (int) Math.min(skip, end - position);
      skip -= skipped;
      position += skipped;
      if (position == end) {
        break;
      }
      int first = in.get(position) & 0xff;
      if (first >= RESET) {
        timeUs += first == OVERFLOW ? WIDE_OVERFLOW_US : 0;
        position++;
        continue;
      }
      // the length has groups of 7 bits, the lowest first; bit 0 marks further ones
      long length = 0;
      int bytes = 0;
      boolean more = true;
      while (more && bytes < MAX_COUNT && position + 1 + bytes < end) {
        int piece = in.get(position + 1 + bytes) & 0xff;
        length |= (long) (piece >>> 1) << 7 * bytes++;
        more = (piece & 1) != 0;
      }
      if (more && bytes < MAX_COUNT) {
        break;
      }
      timeUs += first;
      violations.add(more ? Violation.IMPOSSIBLE_LENGTH : Violation.OTHER_DATA, from + position);
      position += 1 + bytes;
      skip = length;
    }
    return position;
  }

  @Override
  public boolean unfinished() {
    return skip > 0;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.RECORDING_START);
  }

  @Override
  public EventTimes times() {
    return times;
  }

  @Override
  public int stateLongs() {
    return 3;
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = timeUs;
    times.save(state, at + 1);
    state[at + 2] = skip;
  }

  @Override
  public void restore(long[] state, int at) {
    timeUs = state[at];
    times.restore(state, at + 1);
    skip = state[at + 2];
  }
}
