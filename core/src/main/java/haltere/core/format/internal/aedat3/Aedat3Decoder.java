package haltere.core.format.internal.aedat3;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.AscendingTimes;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.decoding.StepBack;
import haltere.core.format.internal.decoding.StreamDecoder;
import java.nio.ByteBuffer;

/**
 * Decodes the packets of an AEDAT-3 file. Each has a header of 28 bytes (kind, source, bytes of an
 * event, offset and overflow of its time, capacity, number of events, number of valid ones) and
 * events of one kind; those of polarity have 8 bytes, address and time. After an impossible header,
 * the next one of polarity events is searched.
 *
 * <p>Thread rule: one thread.
 */
final class Aedat3Decoder implements StreamDecoder {
  static final int EVENT_BYTES = 8;

  private static final int TIME_BITS = 31;
  private static final long NO_SOURCE = -1;

  private final SensorGeometry geometry;
  private final boolean oldLayout;
  private final long fileBytes;
  private final ViolationCounts violations;

  private long events;
  private long skip;
  private long turnUs;
  private long source = NO_SOURCE;
  private final AscendingTimes times = new AscendingTimes();
  private boolean lost;

  /**
   * A decoder before the first packet.
   *
   * @param geometry the sensor; events outside are skipped
   * @param oldLayout whether addresses are those of version 3.0
   * @param fileBytes size of the file
   * @param violations counts violations
   */
  public Aedat3Decoder(
      SensorGeometry geometry, boolean oldLayout, long fileBytes, ViolationCounts violations) {
    this.geometry = geometry;
    this.oldLayout = oldLayout;
    this.fileBytes = fileBytes;
    this.violations = violations;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int position = start;
    int limit = in.limit();
    while (position < limit && out.size() < maxEvents && !times.restarted()) {
      long at = offset + (position - start);
      if (events > 0) {
        int there = (limit - position) / EVENT_BYTES;
        int count = (int) Math.min(Math.min(events, there), maxEvents - out.size());
        if (count == 0) {
          break;
        }
        int done = decodeEvents(in, position, at, count, out);
        events -= done;
        position += done * EVENT_BYTES;
      } else if (skip > 0) {
        int step = (int) Math.min(skip, limit - position);
        skip -= step;
        position += step;
      } else if (limit - position < PacketHeader.BYTES) {
        break;
      } else {
        position += header(in, position, at);
      }
    }
    in.position(position);
    return times.restarted();
  }

  /** Reads a header; returns the number of bytes to advance. */
  private int header(ByteBuffer in, int position, long offset) {
    PacketHeader header = PacketHeader.read(in, position);
    long bytesLeft = fileBytes - offset - PacketHeader.BYTES;
    if (!header.isPossible() || lost && !header.canFollowDamage(bytesLeft)) {
      if (!lost) {
        violations.add(Violation.IMPOSSIBLE_LENGTH, offset);
      }
      lost = true;
      return 1;
    }
    lost = false;
    if (header.payloadBytes() > bytesLeft) {
      violations.addOnce(Violation.CUT_OFF, offset);
    }
    boolean ours =
        header.kind() == PacketHeader.POLARITY
            && (source == NO_SOURCE || source == header.source());
    if (ours) {
      source = header.source();
      events = header.number();
      skip = header.payloadBytes() - events * EVENT_BYTES;
      turnUs = (long) header.overflow() << TIME_BITS;
    } else {
      violations.add(Violation.OTHER_DATA, offset, header.number());
      skip = header.payloadBytes();
    }
    return PacketHeader.BYTES;
  }

  /** Returns the number decoded before the clock went back. */
  private int decodeEvents(ByteBuffer in, int position, long offset, int count, EventPacket out) {
    boolean fromTop = geometry.origin() == Origin.TOP;
    int width = geometry.width();
    int height = geometry.height();
    for (int i = 0; i < count; i++) {
      int at = position + i * EVENT_BYTES;
      int word = in.getInt(at);
      int time = in.getInt(at + 4);
      int x = oldLayout ? word >>> 18 : word >>> 17;
      int y = oldLayout ? word >>> 4 & 0x3fff : word >>> 2 & 0x7fff;
      if ((word & 1) == 0) {
        violations.add(Violation.OTHER_DATA, offset + (long) i * EVENT_BYTES);
        continue;
      }
      if (x >= width || y >= height) {
        violations.add(Violation.OUTSIDE_SENSOR, offset + (long) i * EVENT_BYTES);
        continue;
      }
      long timeUs = turnUs + (time & Integer.MAX_VALUE);
      if (times.goesBack(timeUs)) {
        violations.add(StepBack.kind(times), offset + (long) i * EVENT_BYTES);
        return i;
      }
      times.advance(timeUs);
      out.append(timeUs, EventAddress.pack(x, fromTop ? height - 1 - y : y, word >>> 1 & 1));
    }
    return count;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.CAMERA_START);
  }

  @Override
  public EventTimes times() {
    return times;
  }

  @Override
  public int stateLongs() {
    return 6;
  }

  /** {@link Aedat3SampleCursor} uses these values too. */
  @Override
  public void save(long[] state, int at) {
    state[at] = events;
    state[at + 1] = skip;
    state[at + 2] = turnUs;
    state[at + 3] = source;
    times.save(state, at + 4);
    state[at + 5] = lost ? 1 : 0;
  }

  @Override
  public void restore(long[] state, int at) {
    events = state[at];
    skip = state[at + 1];
    turnUs = state[at + 2];
    source = state[at + 3];
    times.restore(state, at + 4);
    lost = state[at + 5] != 0;
  }
}
