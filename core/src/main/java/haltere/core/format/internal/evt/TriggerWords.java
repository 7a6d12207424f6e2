package haltere.core.format.internal.evt;

import haltere.core.event.Trigger;
import java.nio.ByteBuffer;

/**
 * Finds time words and external triggers among EVT words. Inertial samples, which few cameras
 * write, are skipped: their units are not stated.
 *
 * <p>Thread rule: one thread.
 */
public final class TriggerWords {
  private static final int TIME_LOW = 6;
  private static final int TIME_HIGH = 8;
  private static final int EXT_TRIGGER = 0xa;

  /** The encodings. */
  public enum WordEncoding {
    /** Words of 32 bits. */
    EVT2(4),
    /** Words of 64 bits. */
    EVT21(8),
    /** Words of 64 bits whose halves are exchanged. */
    EVT21_LEGACY(8),
    /** Words of 16 bits. */
    EVT3(2);

    private final int bytes;

    WordEncoding(int bytes) {
      this.bytes = bytes;
    }
  }

  private final WordEncoding encoding;
  private final EvtClock clock;
  private long timeUs;
  private Trigger trigger;

  /**
   * Words from the start of a recording.
   *
   * @param encoding of the words
   * @param firstTurnUs time at the first value 0 of the clock
   */
  public TriggerWords(WordEncoding encoding, long firstTurnUs) {
    this.encoding = encoding;
    clock =
        encoding == WordEncoding.EVT3 ? EvtClock.narrow(firstTurnUs) : EvtClock.wide(firstTurnUs);
  }

  /** Size of a word in bytes. */
  int bytes() {
    return encoding.bytes;
  }

  /**
   * Reads words up to a trigger, or all complete ones.
   *
   * @param buffer little-endian words; its position moves behind those that were read
   * @return null if there is no trigger
   */
  public Trigger next(ByteBuffer buffer) {
    trigger = null;
    switch (encoding) {
      case EVT2 -> narrowWords(buffer);
      case EVT3 -> shortWords(buffer);
      default -> wideWords(buffer, encoding == WordEncoding.EVT21_LEGACY ? 32 : 0);
    }
    return trigger;
  }

  private void narrowWords(ByteBuffer buffer) {
    int end = buffer.limit() - 4;
    int position = buffer.position();
    while (position <= end && trigger == null) {
      int word = buffer.getInt(position);
      position += 4;
      switch (word >>> 28) {
        case TIME_HIGH -> clock.take(word & 0xfffffff);
        case EXT_TRIGGER -> take(word >>> 22 & 0x3f, word >>> 8 & 0x1f, word & 1);
        default -> {
          // an event, or data that is not read
        }
      }
    }
    buffer.position(position);
  }

  private void wideWords(ByteBuffer buffer, int turned) {
    int end = buffer.limit() - 8;
    int position = buffer.position();
    while (position <= end && trigger == null) {
      long word = Long.rotateLeft(buffer.getLong(position), turned);
      position += 8;
      switch ((int) (word >>> 60)) {
        case TIME_HIGH -> clock.take((int) (word >>> 32) & 0xfffffff);
        case EXT_TRIGGER ->
            take((int) (word >>> 54) & 0x3f, (int) (word >>> 40) & 0x1f, (int) (word >>> 32) & 1);
        default -> {
          // an event, or data that is not read
        }
      }
    }
    buffer.position(position);
  }

  private void take(int low, int channel, int value) {
    if (clock.high() >= 0) {
      take(clock.startUs() + low, channel, value != 0);
    }
  }

  private void shortWords(ByteBuffer buffer) {
    int end = buffer.limit() - 2;
    int position = buffer.position();
    while (position <= end && trigger == null) {
      int word = buffer.getShort(position) & 0xffff;
      position += 2;
      switch (word >>> 12) {
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
        case EXT_TRIGGER -> {
          if (clock.high() >= 0) {
            take(timeUs, word >>> 8 & 0xf, (word & 1) != 0);
          }
        }
        default -> {
          // an event, or data that is not read
        }
      }
    }
    buffer.position(position);
  }

  private void take(long atUs, int channel, boolean rising) {
    Trigger.Edge edge = rising ? Trigger.Edge.RISING : Trigger.Edge.FALLING;
    trigger = new Trigger(atUs, Trigger.Source.EXTERNAL_INPUT, edge, channel);
  }

  /**
   * Goes to a place of the decoder of the same words.
   *
   * @param state values of {@link EvtDecoder#save}
   * @param at index of the first of them
   */
  public void restore(long[] state, int at) {
    clock.restore(state[at + 1], (int) state[at + 2]);
    if (encoding == WordEncoding.EVT3) {
      timeUs = state[at + 3];
    }
  }
}
