package haltere.device.protocol;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.internal.aedat2.Dvs128AddressDecoder;
import haltere.core.stream.StreamNotification;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Decodes the data of a DVS128: little-endian words of 32 bits, address in the lower half (as in
 * AEDAT-2, see {@link Dvs128AddressDecoder}), time in the upper. The two highest bits of the time
 * are a code: 1x adds 16,384 us to the clock, 01 sets it to 0, 00 is an event at the 14 bits of
 * microseconds that follow. An address with bit 15 is an edge on the camera's input.
 *
 * <p>A time that decreases by more than half of the 14 bits indicates a missing wrap word, which is
 * compensated. After a smaller decrease, an error of the camera, the event gets the previous time.
 * Both are counted. Any decrease after missing bytes indicates missing wrap words.
 */
public final class Dvs128Decoder implements WireDecoder {
  /** Microseconds from one wrap word to the next. */
  public static final int WRAP_US = 1 << 14;

  static final int WORD_BYTES = 4;
  static final int WRAP_BIT = 0x8000_0000;
  static final int RESET_BIT = 0x4000_0000;
  static final int SYNC_BIT = 0x8000;
  static final int NOT_AN_EVENT = WRAP_BIT | RESET_BIT | SYNC_BIT;
  private static final int PIXEL_BITS = 0x7f00;
  private static final int STAGE_WORDS = 1024;
  private static final int MAX_AWAIT_WRAPS = 500_000 / WRAP_US;

  private final boolean samples;
  private final int[] stage = new int[STAGE_WORDS];
  private long offsetUs;
  private long lastUs = StreamNotification.NO_TIME_US;

  /** Remaining wraps for which a clock reset is awaited; 0 if it is not. */
  private int wrapsToAwaitReset;

  /** Whether words of unknown content are missing since {@link #lastUs}. */
  private boolean unknownGap;

  private Trigger trigger;
  private volatile long unknownWords;

  /**
   * A decoder whose clock is at 0.
   *
   * @param samples whether edges on the camera's input are requested, as triggers
   */
  public Dvs128Decoder(boolean samples) {
    this.samples = samples;
  }

  /**
   * Drops everything until the clock is reset, or for half a second of the camera's clock if there
   * is no reset.
   */
  public void awaitReset() {
    wrapsToAwaitReset = MAX_AWAIT_WRAPS;
  }

  @Override
  public Stop decode(ByteBuffer in, EventPacket out, int maxEvents) {
    while (in.remaining() >= WORD_BYTES) {
      int room = maxEvents - out.size();
      if (room <= 0) {
        return Stop.PACKET_FULL;
      }
      int words = Math.min(Math.min(room, STAGE_WORDS), in.remaining() / WORD_BYTES);
      int start = in.position();
      in.slice().order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().get(stage, 0, words);
      int done = 0;
      Stop stop = null;
      while (done < words && stop == null) {
        done = wrapsToAwaitReset > 0 ? done : decodeEvents(done, words, out);
        if (done < words) {
          stop = decodeWord(stage[done++], out);
        }
      }
      in.position(start + done * WORD_BYTES);
      if (stop != null) {
        return stop;
      }
    }
    if (in.hasRemaining()) {
      unknownWords++;
      in.position(in.limit());
    }
    return Stop.INPUT_USED;
  }

  /** Decodes events from an index on while their times ascend; returns the end index. */
  private int decodeEvents(int from, int to, EventPacket out) {
    int size = out.size();
    out.ensureCapacity(size + to - from);
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    long offset = offsetUs;
    long last = lastUs;
    int i = from;
    for (; i < to; i++) {
      int word = stage[i];
      long timeUs = offset + (word >>> 16);
      if ((word & NOT_AN_EVENT) != 0 || timeUs < last) {
        break;
      }
      last = timeUs;
      times[size] = timeUs;
      addresses[size++] = address(word);
    }
    lastUs = last;
    unknownGap &= size == out.size();
    out.setSize(size);
    return i;
  }

  /** The packed address of an event: {@link Dvs128AddressDecoder} without checks. */
  private static int address(int word) {
    return (word & PIXEL_BITS) << 8 | (word & 0xff) ^ 0xff;
  }

  /** Decodes a word of any kind. */
  private Stop decodeWord(int word, EventPacket out) {
    if ((word & WRAP_BIT) != 0) {
      offsetUs += WRAP_US;
      wrapsToAwaitReset = Math.max(0, wrapsToAwaitReset - 1);
      return null;
    }
    if ((word & RESET_BIT) != 0) {
      return reset();
    }
    if (wrapsToAwaitReset > 0) {
      return null;
    }
    long timeUs = timeOf(word >>> 16);
    if ((word & SYNC_BIT) != 0) {
      if (!samples) {
        return null;
      }
      trigger = new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.FALLING, 0);
      return Stop.SAMPLE;
    }
    out.append(timeUs, address(word));
    return null;
  }

  private Stop reset() {
    offsetUs = 0;
    lastUs = StreamNotification.NO_TIME_US;
    unknownGap = false;
    boolean awaited = wrapsToAwaitReset > 0;
    wrapsToAwaitReset = 0;
    return awaited ? null : Stop.CLOCK_RESET;
  }

  private long timeOf(int low) {
    long timeUs = offsetUs + low;
    if (timeUs < lastUs) {
      unknownWords += unknownGap ? 0 : 1;
      if (unknownGap || lastUs - timeUs > WRAP_US / 2) {
        long missing = (lastUs - timeUs + WRAP_US - 1) / WRAP_US;
        offsetUs += missing * WRAP_US;
        timeUs += missing * WRAP_US;
      } else {
        timeUs = lastUs;
      }
    }
    lastUs = timeUs;
    unknownGap = false;
    return timeUs;
  }

  @Override
  public SensorSample sample() {
    return trigger;
  }

  @Override
  public void breakOff() {
    // each word is complete, and the summary has all wraps
  }

  @Override
  public void breakOffUnknown() {
    unknownGap = true;
  }

  @Override
  public long unknownWords() {
    return unknownWords;
  }

  @Override
  public DroppedWords droppedWords() {
    return new Dvs128DroppedWords();
  }
}
