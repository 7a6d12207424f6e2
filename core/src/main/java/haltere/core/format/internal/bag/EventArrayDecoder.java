package haltere.core.format.internal.bag;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.stream.StreamNotification;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;

/**
 * Single events: column and row in 16 bits, seconds and nanoseconds in 32, polarity in a byte. ROS
 * 1 packs them into 13 bytes. ROS 2 aligns seconds and nanoseconds to 4 bytes and columns to 2, so
 * that each event but the first has a padding byte before it, and two before the seconds.
 *
 * <p>Nanoseconds are rounded down to microseconds.
 */
final class EventArrayDecoder extends MessageDecoder {
  private static final int PACKED_BYTES = 13;
  private static final int ALIGNED_BYTES = 16;
  private static final int RUN = 4096;
  private static final long US_PER_S = 1_000_000;
  private static final int NS_PER_S = 1_000_000_000;

  private final boolean cdr;
  private boolean first;

  EventArrayDecoder(SensorGeometry geometry, boolean cdr, ViolationCounts violations) {
    super(geometry, violations);
    this.cdr = cdr;
  }

  /** Bytes of a number of events. */
  static long bytes(long events, boolean cdr) {
    return cdr && events > 0 ? PACKED_BYTES + (events - 1) * ALIGNED_BYTES : events * PACKED_BYTES;
  }

  @Override
  void startMessage(EventMessage message) {
    first = cdr;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    byte[] data = in.array();
    int from = in.position();
    int end = in.limit();
    out.ensureCapacity(maxEvents);
    int at = from;
    if (first) {
      if (out.size() >= maxEvents || end - at < PACKED_BYTES) {
        return false;
      }
      if (!decodeOne(data, at, 0, 4, offset, out)) {
        return true;
      }
      first = false;
      at += PACKED_BYTES;
    }
    int stride = cdr ? ALIGNED_BYTES : PACKED_BYTES;
    int pixel = cdr ? 1 : 0;
    int seconds = cdr ? 7 : 4;
    while (end - at >= stride && out.size() < maxEvents) {
      int run = Math.min(Math.min((end - at) / stride, maxEvents - out.size()), RUN);
      if (decodeRun(data, at, run, stride, pixel, seconds, out)) {
        at += run * stride;
        continue;
      }
      for (int i = 0; i < run; i++) {
        if (!decodeOne(data, at, pixel, seconds, offset + (at - from), out)) {
          in.position(at);
          return true;
        }
        at += stride;
      }
    }
    in.position(at);
    return false;
  }

  private boolean decodeOne(
      byte[] data, int at, int pixel, int seconds, long offset, EventPacket out) {
    int x = LittleEndian.getUnsignedShort(data, at + pixel);
    int row = LittleEndian.getUnsignedShort(data, at + pixel + 2);
    long second = LittleEndian.getInt(data, at + seconds);
    if (!cdr) {
      second &= 0xffff_ffffL;
    }
    long nanoseconds = LittleEndian.getInt(data, at + seconds + 4) & 0xffff_ffffL;
    long timeUs = second * US_PER_S + nanoseconds / NS_PER_US;
    return take(out, timeUs, x, row, data[at + seconds + 8] == 0 ? 0 : 1, offset);
  }

  /** Decodes events if all are regular; otherwise none. */
  private boolean decodeRun(
      byte[] data, int from, int events, int stride, int pixel, int seconds, EventPacket out) {
    if (times.lastUs() == StreamNotification.NO_TIME_US) {
      return false;
    }
    VarHandle ints = LittleEndian.INT;
    int size = out.size();
    long[] timesUs = out.timesUs();
    int[] addresses = out.addresses();
    int maxX = width - 1;
    int maxRow = top;
    long last = times.lastUs();
    long back = 0;
    int odd = 0;
    int at = from;
    for (int i = 0; i < events; i++, at += stride) {
      int word = (int) ints.get(data, at + pixel);
      int second = (int) ints.get(data, at + seconds);
      int nanosecond = (int) ints.get(data, at + seconds + 4);
      int on = data[at + seconds + 8];
      int x = word & 0xffff;
      int row = word >>> 16;
      long time = second * US_PER_S + nanosecond / (int) NS_PER_US;
      odd |= maxX - x | maxRow - row | on | 1 - on | second | nanosecond | NS_PER_S - nanosecond;
      back |= time - last;
      last = time;
      timesUs[size + i] = time;
      addresses[size + i] = maxRow - row << EventAddress.Y_SHIFT | x << EventAddress.X_SHIFT | on;
    }
    if (odd < 0 || back < 0) {
      return false;
    }
    times.advance(last);
    out.setSize(size + events);
    return true;
  }

  @Override
  public int stateLongs() {
    return super.stateLongs() + 1;
  }

  @Override
  public void save(long[] state, int at) {
    super.save(state, at);
    state[at + 1] = first ? 1 : 0;
  }

  @Override
  public void restore(long[] state, int at) {
    super.restore(state, at);
    first = state[at + 1] != 0;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.YEAR_1970);
  }
}
