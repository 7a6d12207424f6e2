package haltere.core.format.internal.bag;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;

/**
 * The encoding {@code libcaer_cmp}: words of 16 bits, with the type in the upper four. Times count
 * microseconds from the message's base of time, in 24 bits that begin at 0 with each message; a
 * column word precedes row words, each with one event or a group of eight pixels.
 */
final class LibcaerPackedDecoder extends MessageDecoder {
  private static final int WORD_BYTES = 2;
  private static final int TIME_HIGH = 0;
  private static final int TIME_LOW = 1;
  private static final int COLUMN = 2;
  private static final int ROW = 3;
  private static final int FIRST_ROW = 4;
  private static final int ROWS_8 = 5;
  private static final int LOW_BITS = 12;
  private static final int LOW = (1 << LOW_BITS) - 1;
  private static final int SIDE = 0x7ff;
  private static final int ON_SHIFT = 11;
  private static final int RUN = 8;
  private static final int MAX_ROW = 1 << 15;

  private long baseUs;
  private int time;
  private int column;
  private int firstRow;
  private int on;

  /** Events of the word at the input's position that have already been appended. */
  private int handedOver;

  LibcaerPackedDecoder(SensorGeometry geometry, ViolationCounts violations) {
    super(geometry, violations);
  }

  @Override
  void startMessage(EventMessage message) {
    baseUs = Math.floorDiv(message.timeBaseNs(), NS_PER_US);
    time = 0;
    handedOver = 0;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    int from = in.position();
    int at = from;
    boolean back = false;
    while (in.limit() - at >= WORD_BYTES && out.size() < maxEvents && !back) {
      int word = in.getShort(at) & 0xffff;
      long here = offset + (at - from);
      boolean done = true;
      switch (word >>> LOW_BITS) {
        case TIME_HIGH -> time = (word & LOW) << LOW_BITS | time & LOW;
        case TIME_LOW -> time = time & ~LOW | word & LOW;
        case COLUMN -> column = word & SIDE;
        case ROW -> {
          back = !take(out, baseUs + time, column, word & SIDE, word >>> ON_SHIFT & 1, here);
          done = !back;
        }
        case FIRST_ROW -> {
          firstRow = word & SIDE;
          on = word >>> ON_SHIFT & 1;
        }
        case ROWS_8 -> {
          for (; handedOver < RUN && out.size() < maxEvents && !back; handedOver++) {
            if ((word >>> handedOver & 1) != 0) {
              back = !take(out, baseUs + time, column, firstRow + handedOver, on, here);
              handedOver -= back ? 1 : 0;
            }
          }
          done = handedOver == RUN;
          if (done) {
            handedOver = 0;
            firstRow = Math.min(firstRow + RUN, MAX_ROW);
          }
        }
        default -> violations.add(Violation.UNKNOWN_WORD, here);
      }
      at += done ? WORD_BYTES : 0;
    }
    in.position(at);
    return back;
  }

  @Override
  public int stateLongs() {
    return super.stateLongs() + 3;
  }

  @Override
  public void save(long[] state, int at) {
    super.save(state, at);
    state[at + 1] = baseUs;
    state[at + 2] = (long) time << 32 | column;
    state[at + 3] = (long) firstRow << 32 | handedOver << 1 | on;
  }

  @Override
  public void restore(long[] state, int at) {
    super.restore(state, at);
    baseUs = state[at + 1];
    time = (int) (state[at + 2] >> 32);
    column = (int) state[at + 2];
    firstRow = (int) (state[at + 3] >> 32);
    handedOver = (int) state[at + 3] >> 1;
    on = (int) state[at + 3] & 1;
  }

  @Override
  public RecordingClock clock() {
    return RecordingClock.continuous(RecordingClock.Zero.YEAR_1970);
  }
}
