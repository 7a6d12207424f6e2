package haltere.device.protocol;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;

/**
 * Summary of EVT3 words: number of events, clock wraps, and the last time, row and start of a run.
 */
final class Evt3DroppedWords extends DroppedWords {
  private static final int NONE = -1;
  private static final int ROW = 0;
  private static final int OTHER_ROW = 1;
  private static final int COLUMN = 2;
  private static final int RUN_START = 3;
  private static final int MASK_12 = 4;
  private static final int MASK_8 = 5;
  private static final int TIME_LOW = 6;
  static final int TIME_HIGH = 8;
  private static final int LAST_HIGH = TIME_HIGH << 12 | 0xfff;
  private static final int FIRST_HIGH = TIME_HIGH << 12;

  /** Minimum decrease of the high part that is a wrap. */
  private static final int TURN_FALL = 2048;

  private static final int WORDS_AT_ONCE = 8;

  /** More columns than any sensor has; reachable by masks of 12 and of 8 pixels. */
  private static final int MAX_ADVANCE_PX = 2400;

  private long events;
  private long turns;
  private int firstHigh = NONE;
  private int high = NONE;
  private int low = NONE;
  private int row = NONE;
  private int run = NONE;

  /** Pixels by which masks advanced before the first start of a run. */
  private int advancedPx;

  @Override
  public long events() {
    return events;
  }

  @Override
  void scan(ByteBuffer dropped) {
    ByteBuffer words = dropped.slice().order(ByteOrder.LITTLE_ENDIAN);
    for (int at = 0;
        at + Evt3WireDecoder.WORD_BYTES <= words.limit();
        at += Evt3WireDecoder.WORD_BYTES) {
      int word = words.getShort(at) & 0xffff;
      switch (word >> 12) {
        case ROW, OTHER_ROW -> row = word;
        case COLUMN -> events++;
        case RUN_START -> run = word;
        case MASK_12 -> mask(word & 0xfff, 12);
        case MASK_8 -> mask(word & 0xff, 8);
        case TIME_LOW -> low = word;
        case TIME_HIGH -> high(word);
        default -> {}
      }
    }
  }

  private void mask(int pixels, int length) {
    events += Integer.bitCount(pixels);
    advance(length);
  }

  private void advance(int length) {
    if (run != NONE) {
      run = run & ~0x7ff | Math.min(0x7ff, (run & 0x7ff) + length);
    } else {
      advancedPx = Math.min(MAX_ADVANCE_PX, advancedPx + length);
    }
  }

  private void high(int word) {
    if (word == high) {
      return;
    }
    if (high == NONE) {
      firstHigh = word;
    } else if (high - word >= TURN_FALL) {
      turns++;
    }
    high = word;
    low = NONE;
  }

  @Override
  void join(DroppedWords later) {
    Evt3DroppedWords other = (Evt3DroppedWords) later;
    events += other.events;
    if (other.firstHigh != NONE) {
      high(other.firstHigh);
      turns += other.turns;
      high = other.high;
      low = other.low;
    } else if (other.low != NONE) {
      low = other.low;
    }
    row = other.row == NONE ? row : other.row;
    advance(other.advancedPx);
    run = other.run == NONE ? run : other.run;
  }

  @Override
  void forget() {
    events = 0;
    turns = 0;
    firstHigh = NONE;
    high = NONE;
    low = NONE;
    row = NONE;
    run = NONE;
    advancedPx = 0;
  }

  @Override
  public void replay(Consumer<ByteBuffer> decoder) {
    give(decoder, firstHigh);
    for (long left = turns; left > 0; left--) {
      give(decoder, LAST_HIGH, FIRST_HIGH);
    }
    for (int left = advancedPx; left > 0; ) {
      int length = left % 12 == 0 ? 12 : 8;
      give(decoder, (length == 12 ? MASK_12 : MASK_8) << 12);
      left -= length;
    }
    give(decoder, high, low, row, run);
  }

  private static void give(Consumer<ByteBuffer> decoder, int... words) {
    ByteBuffer bytes =
        ByteBuffer.allocate(WORDS_AT_ONCE * Evt3WireDecoder.WORD_BYTES)
            .order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      if (word != NONE) {
        bytes.putShort((short) word);
      }
    }
    decoder.accept(bytes.flip());
  }
}
