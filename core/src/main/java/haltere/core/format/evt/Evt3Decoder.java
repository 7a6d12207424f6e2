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

  /** Pixels of a group of vector words as cameras send it. */
  private static final int GROUP = 32;

  private static final int GROUP_BYTES = 8;

  /** So many bytes without a vector word, and the stream is no longer taken for one with them. */
  private static final int PATIENCE_BYTES = 128;

  /** The types of the words of a group, as one little-endian number. */
  private static final long BASE_12_12_8 = 0x5000400040003000L;

  private static final long GROUP_TYPES = 0xf000f000f000f000L;

  /** Events of a group, and room for what is too much. */
  private static final int LONGEST_RUN = GROUP + 4;

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
    out.ensureCapacity(maxEvents + LONGEST_RUN);
    int start = in.position();
    int end = start + (in.remaining() & -WORD_BYTES);
    int position = start;
    while (position < end && out.size() < maxEvents && !restarted) {
      if (handedOver == 0 && clock.high() >= 0 && timeUs >= lastUs) {
        position = decodeSingles(in, position, end, offset - start, out, maxEvents);
        position = decodeVectors(in, position, end, out, maxEvents);
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

  /**
   * Decodes until there is a vector word, a word needs care or the packet is full; returns where
   * that is. The loop is as bare as it is because it lives from its registers: what is not needed
   * for nearly every word is elsewhere.
   */
  private int decodeSingles(
      ByteBuffer in, int from, int end, long fileOffset, EventPacket out, int maxEvents) {
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int before = out.size();
    int size = before;
    int right = width - 1;
    int topRow = top;
    int rowBits = row;
    long startUs = clock.startUs();
    int high = clock.high();
    long now = timeUs;
    int others = 0;
    boolean careForOthers =
        violations.reached() > fileOffset + from || violations.count(Violation.OTHER_DATA) == 0;
    int stop = (int) Math.min(end, from + (long) (maxEvents - size) * WORD_BYTES);
    int position = from;
    words:
    for (; position < stop; position += WORD_BYTES) {
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
        case TIME_LOW:
          long low = startUs + (word & 0xfff);
          if (low < now) {
            break words;
          }
          now = low;
          break;
        case TIME_HIGH:
          if ((word & 0xfff) != high) {
            break words;
          }
          break;
        case OTHERS, CONTINUED_12, CONTINUED_4, EXT_TRIGGER:
          if (careForOthers) {
            break words;
          }
          others++;
          break;
        default:
          break words;
      }
    }
    violations.add(Violation.OTHER_DATA, fileOffset + from, others);
    setState(out, before, size, rowBits, now);
    return position;
  }

  /**
   * The same for streams with vector words: decodes from one on, until there has been none for a
   * while, a word needs care or the packet is nearly full.
   */
  private int decodeVectors(ByteBuffer in, int from, int end, EventPacket out, int maxEvents) {
    int limit = maxEvents - GROUP;
    int before = out.size();
    int size = before;
    if (from >= end || size > limit || !isVector(in.getShort(from))) {
      return from;
    }
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int right = width - 1;
    int topRow = top;
    int rowBits = row;
    long startUs = clock.startUs();
    int high = clock.high();
    long now = timeUs;
    int position = from;
    int patience = from + PATIENCE_BYTES;
    words:
    for (; position < end && size <= limit; position += WORD_BYTES) {
      int word = in.getShort(position) & 0xffff;
      switch (word >>> 12) {
        case ADDR_Y:
          rowBits = topRow - (word & 0x7ff) << EventAddress.Y_SHIFT;
          break;
        case ADDR_X:
          int x = word & 0x7ff;
          if ((rowBits | right - x) < 0 || position > patience) {
            break words;
          }
          times[size] = now;
          addresses[size++] = rowBits | x << EventAddress.X_SHIFT | word >>> 11 & 1;
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
            break words;
          }
          break;
        case VECT_BASE_X:
          vectorX = word & 0x7ff;
          vectorOn = word >>> 11 & 1;
          patience = position + PATIENCE_BYTES;
          int group = groupMask(in, position, end);
          if (group == 0 || (rowBits | right + 1 - GROUP - vectorX) < 0) {
            break;
          }
          size =
              appendPixels(
                  times,
                  addresses,
                  size,
                  now,
                  rowBits | vectorX << EventAddress.X_SHIFT | vectorOn,
                  group);
          vectorX += GROUP;
          position += GROUP_BYTES - WORD_BYTES;
          break;
        case VECT_12, VECT_8:
          int length = word >>> 12 == VECT_12 ? 12 : 8;
          if ((rowBits | right + 1 - length - vectorX) < 0) {
            break words;
          }
          size =
              appendPixels(
                  times,
                  addresses,
                  size,
                  now,
                  rowBits | vectorX << EventAddress.X_SHIFT | vectorOn,
                  word & (1 << length) - 1);
          vectorX += length;
          break;
        default:
          break words;
      }
    }
    setState(out, before, size, rowBits, now);
    return position;
  }

  private static boolean isVector(short word) {
    int type = word >>> 12 & 0xf;
    return type >= VECT_BASE_X && type <= VECT_8;
  }

  private void setState(EventPacket out, int before, int size, int rowBits, long now) {
    out.setSize(size);
    row = rowBits;
    timeUs = now;
    if (size > before) {
      lastUs = out.timesUs()[size - 1];
    }
  }

  /**
   * The pixels of a group of vector words as cameras send it: a start and 12, 12 and 8 pixels; 0 if
   * there is none.
   */
  private static int groupMask(ByteBuffer in, int position, int end) {
    if (position + GROUP_BYTES > end) {
      return 0;
    }
    long words = in.getLong(position);
    if ((words & GROUP_TYPES) != BASE_12_12_8) {
      return 0;
    }
    return (int) (words >>> 16) & 0xfff
        | ((int) (words >>> 32) & 0xfff) << 12
        | (int) (words >>> 48) << 24;
  }

  /**
   * Appends the events of vector words, four at a time without asking whether there are as many:
   * what is too much is overwritten by the next events. Returns the new size.
   */
  private static int appendPixels(
      long[] times, int[] addresses, int size, long timeUs, int address, int pixels) {
    int next = size + Integer.bitCount(pixels);
    int mask = pixels;
    for (int i = size; i < next; i += 4) {
      times[i] = timeUs;
      times[i + 1] = timeUs;
      times[i + 2] = timeUs;
      times[i + 3] = timeUs;
      addresses[i] = address + (Integer.numberOfTrailingZeros(mask) << EventAddress.X_SHIFT);
      mask &= mask - 1;
      addresses[i + 1] = address + (Integer.numberOfTrailingZeros(mask) << EventAddress.X_SHIFT);
      mask &= mask - 1;
      addresses[i + 2] = address + (Integer.numberOfTrailingZeros(mask) << EventAddress.X_SHIFT);
      mask &= mask - 1;
      addresses[i + 3] = address + (Integer.numberOfTrailingZeros(mask) << EventAddress.X_SHIFT);
      mask &= mask - 1;
    }
    return next;
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
