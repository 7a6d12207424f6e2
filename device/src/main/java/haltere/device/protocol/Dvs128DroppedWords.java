package haltere.device.protocol;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.function.Consumer;

/** Summary of DVS128 words: number of events, clock reset, and wraps since then. */
final class Dvs128DroppedWords extends DroppedWords {
  private static final int WRAPS_AT_ONCE = 1024;

  private long events;
  private long wraps;
  private boolean reset;

  @Override
  public long events() {
    return events;
  }

  @Override
  void scan(ByteBuffer dropped) {
    ByteBuffer words = dropped.slice().order(ByteOrder.LITTLE_ENDIAN);
    for (int at = 0;
        at + Dvs128Decoder.WORD_BYTES <= words.limit();
        at += Dvs128Decoder.WORD_BYTES) {
      int word = words.getInt(at);
      if ((word & Dvs128Decoder.NOT_AN_EVENT) == 0) {
        events++;
      } else if ((word & Dvs128Decoder.WRAP_BIT) != 0) {
        wraps++;
      } else if ((word & Dvs128Decoder.RESET_BIT) != 0) {
        reset = true;
        wraps = 0;
      }
    }
  }

  @Override
  void join(DroppedWords later) {
    Dvs128DroppedWords other = (Dvs128DroppedWords) later;
    events += other.events;
    wraps = other.reset ? other.wraps : wraps + other.wraps;
    reset |= other.reset;
  }

  @Override
  void forget() {
    events = 0;
    wraps = 0;
    reset = false;
  }

  @Override
  public void replay(Consumer<ByteBuffer> decoder) {
    if (reset) {
      decoder.accept(words(Dvs128Decoder.RESET_BIT, 1));
    }
    for (long left = wraps; left > 0; left -= WRAPS_AT_ONCE) {
      decoder.accept(words(Dvs128Decoder.WRAP_BIT, (int) Math.min(left, WRAPS_AT_ONCE)));
    }
  }

  private static ByteBuffer words(int word, int count) {
    ByteBuffer words =
        ByteBuffer.allocate(count * Dvs128Decoder.WORD_BYTES).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < count; i++) {
      words.putInt(word);
    }
    return words.flip();
  }
}
