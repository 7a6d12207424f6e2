package haltere.core.format.internal.bag;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;

/**
 * The encodings {@code mono} and {@code libcaer}: a word of 64 bits for an event, with 32 bits of
 * time. {@code mono} has nanoseconds since the message's time base, {@code libcaer} microseconds;
 * its 31-bit clock may wrap once within a message.
 */
final class WordDecoder extends MessageDecoder {
  private static final int WORD_BYTES = 8;
  private static final long TURN_US = 1L << 31;
  private static final int SIDE = 0x7fff;

  private final boolean libcaer;
  private long baseNs;
  private long lastLow;
  private long turnUs;

  WordDecoder(SensorGeometry geometry, boolean libcaer, ViolationCounts violations) {
    super(geometry, violations);
    this.libcaer = libcaer;
  }

  @Override
  void startMessage(EventMessage message) {
    baseNs = message.timeBaseNs();
    lastLow = 0;
    turnUs = 0;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    int from = in.position();
    int at = from;
    boolean back = false;
    for (; in.limit() - at >= WORD_BYTES && out.size() < maxEvents; at += WORD_BYTES) {
      long word = in.getLong(at);
      long here = offset + (at - from);
      back = !(libcaer ? decodeLibcaer(word, here, out) : decodeMono(word, here, out));
      if (back) {
        break;
      }
    }
    in.position(at);
    return back;
  }

  private boolean decodeMono(long word, long offset, EventPacket out) {
    long timeUs = Math.floorDiv(baseNs + (word & 0xffff_ffffL), NS_PER_US);
    int x = (int) (word >>> 32) & 0xffff;
    int row = (int) (word >>> 48) & SIDE;
    return take(out, timeUs, x, row, (int) (word >>> 63), offset);
  }

  private boolean decodeLibcaer(long word, long offset, EventPacket out) {
    int low = (int) (word >>> 32);
    if (low < 0) {
      violations.add(Violation.UNKNOWN_WORD, offset);
      return true;
    }
    long turn = low < lastLow ? turnUs + TURN_US : turnUs;
    long timeUs = Math.floorDiv(baseNs, NS_PER_US) + turn + low;
    int x = (int) word >>> 17 & SIDE;
    int row = (int) word >>> 2 & SIDE;
    if (!take(out, timeUs, x, row, (int) word >>> 1 & 1, offset)) {
      return false;
    }
    turnUs = turn;
    lastLow = low;
    return true;
  }

  @Override
  public int stateLongs() {
    return super.stateLongs() + 3;
  }

  @Override
  public void save(long[] state, int at) {
    super.save(state, at);
    state[at + 1] = baseNs;
    state[at + 2] = lastLow;
    state[at + 3] = turnUs;
  }

  @Override
  public void restore(long[] state, int at) {
    super.restore(state, at);
    baseNs = state[at + 1];
    lastLow = state[at + 2];
    turnUs = state[at + 3];
  }

  @Override
  public RecordingClock clock() {
    return libcaer
        ? RecordingClock.continuous(RecordingClock.Zero.YEAR_1970)
        : RecordingClock.continuous(RecordingClock.Zero.CAMERA_START);
  }
}
