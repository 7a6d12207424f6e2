package haltere.core.format.internal.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;

/**
 * EVT3: little-endian words of 16 bits, each of which changes a part of the state (row, time, start
 * of a run of pixels) or contains events. Any word may be the first of a buffer.
 */
public final class Evt3Decoder extends EvtDecoder {
  private static final int WORD_BYTES = 2;
  private static final int WORD_BITS = 16;
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

  /** Maximum events of a vector word. */
  private static final int VECTOR = 12;

  /** Pixels of a group of vector words as cameras send it. */
  private static final int GROUP = 32;

  private static final int GROUP_BYTES = 8;

  /** Pixels that are written at once. */
  private static final int AT_ONCE = 4;

  /** Events of a group, and space for surplus ones. */
  private static final int MAX_RUN = GROUP + AT_ONCE;

  /** Bytes that are processed together. */
  private static final int STAGE_BYTES = 4096;

  /** A bit for each type of word that has no effect on pixel events. */
  private static final int OTHER_WORDS =
      1 << OTHERS | 1 << CONTINUED_12 | 1 << CONTINUED_4 | 1 << EXT_TRIGGER;

  private static final long EACH_WORD = 0x0001000100010001L;

  /** Types of four words, the first of which is in the lowest bits. */
  private static final long GROUP_TYPES = 0xf000f000f000f000L;

  private static final long BASE_12_12_8 = 0x5000400040003000L;
  private static final long LOW_ROW_COLUMN_TYPES = 0x0000f000f000f000L;
  private static final long LOW_ROW_COLUMN = 0x0000200000006000L;
  private static final long ROW_COLUMN_TYPES = 0x00000000f000f000L;
  private static final long ROW_COLUMN = 0x0000000020000000L;

  /** The largest row and column of a word. */
  private static final int LAST = 0x7ff;

  /** Coordinates of a row word and of the column word after it. */
  private static final long ROW_AND_COLUMN = 0x000007ff07ff0000L;

  /** Bits that remain set above both differences if row and column are on the sensor. */
  private static final long FITS = 0x0000080008000000L;

  /** Types of the four words of a camera's event counts. */
  private static final long COUNTS = 0x7000f000f000e000L;

  /** Row of {@link #row} before the first row word and for data other than pixel events. */
  private static final int NO_ROW = 1 << 31;

  private static final int NO_ROW_OTHER = NO_ROW | 1;

  private final byte[] stage = new byte[STAGE_BYTES + GROUP_BYTES];

  /** Row, counted from the bottom, at its position in an address; negative if there is none. */
  private int row = NO_ROW;

  /** Time of the words. */
  private long timeUs;

  /** Column of the next vector word's first pixel. */
  private int vectorX;

  /** Whether the camera repeats high parts. */
  private boolean repeatedHighs;

  /** Polarity bit of vector words. */
  private int vectorOn;

  /**
   * A decoder before the first word.
   *
   * @param geometry the sensor; events outside are skipped
   * @param firstTurnUs start time of the first clock period, 0 for cameras
   * @param violations counts violations
   */
  public Evt3Decoder(SensorGeometry geometry, long firstTurnUs, ViolationCounts violations) {
    super(geometry, EvtClock.narrow(firstTurnUs), violations);
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents + MAX_RUN);
    int start = in.position();
    int end = in.remaining() & -WORD_BYTES;
    int first = 0;
    while (first < end && out.size() < maxEvents && !times.restarted()) {
      int bytes = Math.min(STAGE_BYTES, end - first);
      in.get(start + first, stage, 0, bytes);
      first += decodeStage(bytes, first + bytes == end, offset + first, out, maxEvents);
    }
    in.position(start + first);
    return times.restarted();
  }

  /** Decodes words of the stage until the packet is full; returns their number of bytes. */
  private int decodeStage(int bytes, boolean last, long offset, EventPacket out, int maxEvents) {
    int at = 0;
    while (at < bytes && out.size() < maxEvents && !times.restarted()) {
      if (handedOver == 0 && clock.high() >= 0 && timeUs >= times.lastUs() && top <= LAST) {
        at = decodeRun(at, bytes, offset, out, maxEvents);
        if (bytes - at < GROUP_BYTES && !last) {
          return at;
        }
      }
      if (at < bytes && out.size() < maxEvents) {
        int word = (int) WordArray.eightBytes(stage, at) & 0xffff;
        at += decodeWord(word, offset + at, out, maxEvents) ? WORD_BYTES : 0;
      }
    }
    return at;
  }

  /**
   * Decodes up to an irregular word, a possibly full packet or the last three words; returns its
   * index. Four words are examined together, since branches are predictable only for the usual
   * sequences; repeated high parts are skipped without a branch on their number. Space is checked
   * in words, which saves a register in the loop.
   */
  private int decodeRun(int from, int end, long offset, EventPacket out, int maxEvents) {
    byte[] words = stage;
    long[] timesUs = out.timesUs();
    int[] addresses = out.addresses();
    int before = out.size();
    int size = before;
    long corner = FITS | (long) Math.min(width - 1, LAST) << 32 | (long) top << 16;
    int rowBits = row;
    long startUs = clock.startUs();
    long sameHighs = (TIME_HIGH << 12 | clock.high()) * EACH_WORD;
    boolean passOver = repeatedHighs;
    int low = (int) (timeUs - startUs);
    long others = 0;
    boolean reportOthers =
        violations.reached() > offset + from || violations.count(Violation.OTHER_DATA) == 0;
    int stop = lastFitting(from, end, maxEvents - size);
    int at = from;
    while (at <= stop) {
      long ahead = WordArray.eightBytes(words, at);
      int passed = 0;
      if (passOver) {
        passed = Long.numberOfTrailingZeros(ahead ^ sameHighs) >>> 4;
        at += passed * WORD_BYTES;
        if (passed > 1) {
          continue;
        }
        ahead >>>= passed * WORD_BITS;
      }
      if ((ahead & LOW_ROW_COLUMN_TYPES) == LOW_ROW_COLUMN) {
        int newLow = (int) ahead & 0xfff;
        long left = corner - (ahead & ROW_AND_COLUMN);
        if (newLow < low || (left & FITS) != FITS) {
          break;
        }
        low = newLow;
        rowBits = row(left) << EventAddress.Y_SHIFT;
        timesUs[size] = startUs + low;
        addresses[size++] =
            rowBits | column(ahead) << EventAddress.X_SHIFT | (int) (ahead >>> 43) & 1;
        at += 3 * WORD_BYTES;
        continue;
      }
      if ((ahead & ROW_COLUMN_TYPES) == ROW_COLUMN) {
        long moved = ahead << WORD_BITS;
        long left = corner - (moved & ROW_AND_COLUMN);
        if ((left & FITS) != FITS) {
          break;
        }
        rowBits = row(left) << EventAddress.Y_SHIFT;
        timesUs[size] = startUs + low;
        addresses[size++] =
            rowBits | column(moved) << EventAddress.X_SHIFT | (int) (moved >>> 43) & 1;
        at += 2 * WORD_BYTES;
        continue;
      }
      int value = (int) ahead & 0x7ff;
      int type = (int) ahead >>> 12 & 0xf;
      if (type == ADDR_X) {
        if ((rowBits | column(corner) - value) < 0) {
          break;
        }
        timesUs[size] = startUs + low;
        addresses[size++] = rowBits | value << EventAddress.X_SHIFT | (int) ahead >>> 11 & 1;
        at += WORD_BYTES;
      } else if (type == ADDR_Y) {
        rowBits = row(corner) - value << EventAddress.Y_SHIFT;
        at += WORD_BYTES;
      } else if ((ahead & GROUP_TYPES) == BASE_12_12_8) {
        if ((rowBits | column(corner) + 1 - GROUP - value | maxEvents - GROUP - size) < 0) {
          break;
        }
        vectorX = value + GROUP;
        vectorOn = (int) ahead >>> 11 & 1;
        size =
            appendPixels(
                timesUs,
                addresses,
                size,
                startUs + low,
                rowBits | value << EventAddress.X_SHIFT | vectorOn,
                (int) (ahead >>> 16) & 0xfff
                    | ((int) (ahead >>> 32) & 0xfff) << 12
                    | (int) (ahead >>> 48) << 24);
        at += GROUP_BYTES;
        stop = lastFitting(at, end, maxEvents - size);
      } else if (type == VECT_BASE_X && passed > 0) {
        continue; // its group is complete when it is read from here
      } else if (!reportOthers && (ahead & GROUP_TYPES) == COUNTS) {
        others += GROUP_BYTES / WORD_BYTES;
        at += GROUP_BYTES;
      } else if (type == TIME_LOW && ((int) ahead & 0xfff) >= low) {
        low = (int) ahead & 0xfff;
        at += WORD_BYTES;
      } else if ((OTHER_WORDS >>> type & 1) != 0 && !reportOthers) {
        others++;
        at += WORD_BYTES;
      } else {
        break;
      }
    }
    violations.add(Violation.OTHER_DATA, offset + from, others);
    out.setSize(size);
    row = rowBits;
    timeUs = startUs + low;
    if (size > before) {
      times.advance(timesUs[size - 1]);
    }
    return at;
  }

  /** Row of a row word that is the second of four words. */
  private static int row(long words) {
    return (int) (words >>> WORD_BITS) & LAST;
  }

  /** Column of a column word that is the third of four words. */
  private static int column(long words) {
    return (int) (words >>> 2 * WORD_BITS) & LAST;
  }

  /**
   * Start of the last four words for which there is space if each word outside a group is an event.
   */
  private static int lastFitting(int from, int end, int events) {
    return Math.min(end - GROUP_BYTES, from + (events - 1) * WORD_BYTES);
  }

  /**
   * Appends the events of vector words, four at a time; the next events overwrite any surplus.
   * Returns the new size.
   */
  private static int appendPixels(
      long[] times, int[] addresses, int size, long timeUs, int address, int pixels) {
    int next = size + Integer.bitCount(pixels);
    int mask = pixels;
    int i = size;
    do {
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
      i += AT_ONCE;
    } while (i < next);
    return next;
  }

  /** Decodes any word; false if it is not completed. */
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
        } else {
          repeatedHighs = true;
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
      times.advance(timeUs);
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
