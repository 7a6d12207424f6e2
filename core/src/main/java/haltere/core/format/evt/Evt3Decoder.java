package haltere.core.format.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;

/**
 * EVT3: little-endian words of 16 bits, each of which changes a part of the state (row, time, start
 * of a run of pixels) or makes events of it. Any word may be the first of a buffer.
 */
public final class Evt3Decoder extends EvtDecoder {
  private static final int WORD_BYTES = 2;
  private static final int ADDR_Y = 0;
  private static final int OTHER_ROW = 1;
  private static final int ADDR_X = 2;
  private static final int VECT_BASE_X = 3;
  private static final int VECT_12 = 4;
  private static final int VECT_8 = 5;
  private static final int TIME_LOW = 6;
  private static final int CONTINUED_4 = 7;
  private static final int TIME_HIGH = 8;
  private static final int EXT_TRIGGER = 0xa;
  private static final int OTHERS = 0xe;
  private static final int CONTINUED_12 = 0xf;

  /** Events of the longest vector word. */
  private static final int VECTOR = 12;

  /** Row of {@link #row} before the first row word and for data that are no pixel events. */
  private static final int NO_ROW = 1 << 31;

  private static final int NO_ROW_OTHER = NO_ROW | 1;

  /** Row of an address, counted from the bottom, in its place; negative if there is none. */
  private int row = NO_ROW;

  /** Time as the words say it. */
  private long timeUs;

  /** Column of the next vector word's first pixel. */
  private int vectorX;

  /** Polarity bit of vector words. */
  private int vectorOn;

  /**
   * A decoder before the first word.
   *
   * @param geometry the sensor; events outside are left out
   * @param firstTurnUs time at which the first turn of the clock begins, 0 for cameras
   * @param violations where to count what is wrong
   */
  public Evt3Decoder(SensorGeometry geometry, long firstTurnUs, ViolationCounts violations) {
    super(geometry, EvtClock.narrow(firstTurnUs), violations);
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents + VECTOR);
    int start = in.position();
    int end = start + (in.remaining() & -WORD_BYTES);
    int position = start;
    while (position < end && out.size() < maxEvents && !restarted) {
      if (handedOver == 0) {
        position = decodeRun(in, position, end, offset - start, out, maxEvents);
      }
      if (position < end && out.size() < maxEvents) {
        int word = in.getShort(position) & 0xffff;
        if (decodeWord(word, offset + (position - start), out, maxEvents)) {
          position += WORD_BYTES;
        }
      }
    }
    in.position(position);
    return restarted;
  }

  /** Decodes until a word needs care or the packet is nearly full; returns where that is. */
  private int decodeRun(
      ByteBuffer in, int from, int end, long fileOffset, EventPacket out, int maxEvents) {
    int limit = maxEvents - VECTOR;
    int size = out.size();
    if (clock.high() < 0 || size > limit || timeUs < lastUs) {
      return from;
    }
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int before = size;
    int right = width - 1;
    int topRow = top;
    int rowBits = row;
    int vector = vectorX;
    int on = vectorOn;
    long startUs = clock.startUs();
    int high = clock.high();
    long now = timeUs;
    int position = from;
    int others = 0;
    int firstOther = 0;
    long counted = violations.reached() - fileOffset;
    words:
    for (; position < end && size <= limit; position += WORD_BYTES) {
      int word = in.getShort(position) & 0xffff;
      switch (word >>> 12) {
        case ADDR_Y:
          rowBits = topRow - (word & 0x7ff) << EventAddress.Y_SHIFT;
          break;
        case ADDR_X:
          int x = word & 0x7ff;
          if ((rowBits | right - x) < 0) {
            break words;
          }
          times[size] = now;
          addresses[size++] = rowBits | x << EventAddress.X_SHIFT | word >>> 11 & 1;
          break;
        case VECT_BASE_X:
          vector = word & 0x7ff;
          on = word >>> 11 & 1;
          break;
        case VECT_12, VECT_8:
          int length = word >>> 12 == VECT_12 ? 12 : 8;
          int mask = word & (1 << length) - 1;
          if ((rowBits | right + 1 - length - vector) < 0) {
            break words;
          }
          int address = rowBits + (vector << EventAddress.X_SHIFT) + on;
          vector += length;
          int next = size + Integer.bitCount(mask);
          while (size < next) {
            // Four at a time without asking whether there are as many: what is too much is
            // overwritten by the next events.
            int first = Integer.numberOfTrailingZeros(mask);
            mask &= mask - 1;
            int second = Integer.numberOfTrailingZeros(mask);
            mask &= mask - 1;
            int third = Integer.numberOfTrailingZeros(mask);
            mask &= mask - 1;
            int fourth = Integer.numberOfTrailingZeros(mask);
            mask &= mask - 1;
            times[size] = now;
            times[size + 1] = now;
            times[size + 2] = now;
            times[size + 3] = now;
            addresses[size] = address + (first << EventAddress.X_SHIFT);
            addresses[size + 1] = address + (second << EventAddress.X_SHIFT);
            addresses[size + 2] = address + (third << EventAddress.X_SHIFT);
            addresses[size + 3] = address + (fourth << EventAddress.X_SHIFT);
            size += 4;
          }
          size = next;
          break;
        case TIME_LOW:
          long low = startUs + (word & 0xfff);
          if (low < now) {
            break words;
          }
          now = low;
          break;
        case TIME_HIGH:
          if ((word & 0xfff) != high) {
            if ((word & 0xfff) < high) {
              break words;
            }
            high = word & 0xfff;
            startUs = clock.take(high);
            now = startUs;
          }
          break;
        case OTHERS, CONTINUED_12, CONTINUED_4, EXT_TRIGGER:
          if (position >= counted && others++ == 0) {
            firstOther = position;
          }
          break;
        default:
          break words;
      }
    }
    violations.add(Violation.OTHER_DATA, fileOffset + firstOther, others);
    out.setSize(size);
    row = rowBits;
    vectorX = vector;
    vectorOn = on;
    timeUs = now;
    if (size > before) {
      lastUs = times[size - 1];
    }
    return position;
  }

  /** Decodes one word, whatever it is; false if it is not done with. */
  private boolean decodeWord(int word, long offset, EventPacket out, int maxEvents) {
    switch (word >>> 12) {
      case ADDR_Y -> row = top - (word & 0x7ff) << EventAddress.Y_SHIFT;
      case OTHER_ROW -> {
        row = NO_ROW_OTHER;
        violations.add(Violation.OTHER_DATA, offset);
      }
      case ADDR_X -> {
        return decodeMask(word & 0x7ff, word >>> 11 & 1, 1, offset, out, maxEvents);
      }
      case VECT_BASE_X -> {
        vectorX = word & 0x7ff;
        vectorOn = word >>> 11 & 1;
      }
      case VECT_12, VECT_8 -> {
        int length = word >>> 12 == VECT_12 ? 12 : 8;
        int mask = word & (1 << length) - 1;
        if (!decodeMask(vectorX, vectorOn, mask, offset, out, maxEvents)) {
          return false;
        }
        vectorX = Math.min(vectorX + length, MAX_SIDE);
      }
      case TIME_LOW -> {
        if (clock.high() >= 0) {
          timeUs = clock.startUs() + (word & 0xfff);
        }
      }
      case TIME_HIGH -> {
        if ((word & 0xfff) != clock.high()) {
          timeUs = clock.take(word & 0xfff);
        }
      }
      case EXT_TRIGGER, OTHERS, CONTINUED_12, CONTINUED_4 ->
          violations.add(Violation.OTHER_DATA, offset);
      default -> violations.add(Violation.UNKNOWN_WORD, offset);
    }
    return true;
  }

  private boolean decodeMask(int x, int on, int mask, long offset, EventPacket out, int maxEvents) {
    if (row == NO_ROW_OTHER) {
      violations.add(Violation.OTHER_DATA, offset);
      return true;
    }
    if (clock.high() < 0 || row == NO_ROW) {
      violations.add(Violation.NO_TIME_YET, offset, Integer.bitCount(mask));
      return true;
    }
    int done = handedOver;
    handedOver = 0;
    for (int bit = done; bit < VECTOR; bit++) {
      if ((mask >>> bit & 1) == 0) {
        continue;
      }
      if (x + bit >= width || row < 0) {
        violations.add(Violation.OUTSIDE_SENSOR, offset);
        continue;
      }
      if (out.size() == maxEvents || goesBack(timeUs, offset)) {
        handedOver = bit;
        return false;
      }
      out.append(timeUs, row | x + bit << EventAddress.X_SHIFT | on);
      lastUs = timeUs;
    }
    return true;
  }

  @Override
  public int stateLongs() {
    return super.stateLongs() + 2;
  }

  @Override
  public void save(long[] state, int at) {
    super.save(state, at);
    state[at + 3] = timeUs;
    state[at + 4] = (long) row << 32 | vectorX << 1 | vectorOn;
  }

  @Override
  public void restore(long[] state, int at) {
    super.restore(state, at);
    timeUs = state[at + 3];
    row = (int) (state[at + 4] >> 32);
    vectorX = (int) state[at + 4] >>> 1;
    vectorOn = (int) state[at + 4] & 1;
  }
}
