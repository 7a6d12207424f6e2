package haltere.device.protocol;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;

/**
 * Summary of DAVIS words: number of events, clock reset, wraps since then, the last time and the
 * last row.
 */
final class DavisDroppedWords extends DroppedWords {
  private static final int NONE = -1;
  private static final int MAX_WRAPS = 0xfff;
  private static final int WORDS_AT_ONCE = 1024;

  private final DavisLayout layout;
  private long events;
  private boolean reset;
  private long wraps;
  private int time = NONE;
  private int row = NONE;

  DavisDroppedWords(DavisLayout layout) {
    this.layout = layout;
  }

  @Override
  public long events() {
    return events;
  }

  @Override
  void scan(ByteBuffer dropped) {
    ByteBuffer words = dropped.slice().order(ByteOrder.LITTLE_ENDIAN);
    for (int at = 0; at + DavisDecoder.WORD_BYTES <= words.limit(); at += DavisDecoder.WORD_BYTES) {
      int word = words.getShort(at) & 0xffff;
      int data = word & 0xfff;
      if ((word & DavisDecoder.TIME_BIT) != 0) {
        time = word;
        continue;
      }
      switch (word >> 12) {
        case DavisDecoder.ROW -> row = data < layout.rows() ? word : row;
        case DavisDecoder.COLUMN_OFF, DavisDecoder.COLUMN_ON ->
            events += data < layout.columns() ? 1 : 0;
        case DavisDecoder.WRAP -> {
          wraps += data;
          time = NONE;
        }
        case DavisDecoder.SPECIAL -> {
          if (data == DavisDecoder.CLOCK_RESET) {
            reset = true;
            wraps = 0;
            time = NONE;
          }
        }
        default -> {}
      }
    }
  }

  @Override
  void join(DroppedWords later) {
    DavisDroppedWords other = (DavisDroppedWords) later;
    events += other.events;
    boolean newTime = other.reset || other.wraps > 0 || other.time != NONE;
    time = newTime ? other.time : time;
    wraps = other.reset ? other.wraps : wraps + other.wraps;
    reset |= other.reset;
    row = other.row == NONE ? row : other.row;
  }

  @Override
  void forget() {
    events = 0;
    reset = false;
    wraps = 0;
    time = NONE;
    row = NONE;
  }

  @Override
  public void replay(Consumer<ByteBuffer> decoder) {
    ByteBuffer words =
        ByteBuffer.allocate(WORDS_AT_ONCE * DavisDecoder.WORD_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    if (reset) {
      words.putShort((short) DavisDecoder.CLOCK_RESET);
    }
    for (long left = wraps; left > 0; left -= MAX_WRAPS) {
      words.putShort((short) (DavisDecoder.WRAP << 12 | Math.min(left, MAX_WRAPS)));
      if (words.remaining() < 4 * DavisDecoder.WORD_BYTES) {
        decoder.accept(words.flip());
        words.clear();
      }
    }
    if (time != NONE) {
      words.putShort((short) time);
    }
    if (row != NONE) {
      words.putShort((short) row);
    }
    decoder.accept(words.flip());
  }
}
