package haltere.device.protocol;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Decodes the data of a DAVIS camera with logic version 18: little-endian words of 16 bits. Bit 15
 * marks a time (15 bits of microseconds); else bits 14 to 12 are a code: row, column with polarity,
 * wraps of the time, samples of frames, bytes of inertial samples, and special words. Rows count
 * from the top in the words and from the bottom in the packets.
 *
 * <p>A time that decreases without a wrap is an error: the previous time is kept, and the error is
 * counted. After missing bytes it indicates missing wraps, which are compensated.
 */
public final class DavisDecoder implements WireDecoder {
  /** Wrap period of the time in microseconds. */
  public static final int WRAP_US = 1 << 15;

  static final int WORD_BYTES = 2;
  static final int TIME_BIT = 0x8000;
  static final int SPECIAL = 0;
  static final int ROW = 1;
  static final int COLUMN_OFF = 2;
  static final int COLUMN_ON = 3;
  static final int SAMPLE = 4;
  static final int BYTES = 5;
  static final int TEN_BITS = 6;
  static final int WRAP = 7;
  static final int CLOCK_RESET = 1;
  private static final int DATA = 0xfff;
  private static final int STAGE_WORDS = 1024;
  private static final int MAX_AWAIT_WRAPS = 500_000 / WRAP_US;
  private static final int NO_ROW = -1;

  /** The row after missing bytes of unknown content. */
  private static final int MISSING_ROW = -2;

  private final DavisLayout layout;
  private final boolean samples;
  private final int top;
  private final short[] stage = new short[STAGE_WORDS];
  private final DavisFrameAssembly frames;
  private final DavisInertialAssembly inertial;
  private long offsetUs;
  private long timeUs;
  private int row = NO_ROW;
  private boolean timeMayFall = true;

  /** Whether words of unknown content are missing since {@link #timeUs}. */
  private boolean unknownGap;

  private int wrapsToAwaitReset;
  private SensorSample sample;
  private volatile long unknownWords;

  /**
   * A decoder whose clock is at 0.
   *
   * @param layout of the camera's words
   * @param samples whether frames, inertial samples and triggers are requested
   */
  public DavisDecoder(DavisLayout layout, boolean samples) {
    this.layout = layout;
    this.samples = samples;
    top = layout.geometry().height() - 1;
    frames = new DavisFrameAssembly(layout);
    inertial = new DavisInertialAssembly(layout);
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
    out.ensureCapacity(maxEvents);
    while (in.remaining() >= WORD_BYTES) {
      if (out.size() >= maxEvents) {
        return Stop.PACKET_FULL;
      }
      int words = Math.min(STAGE_WORDS, in.remaining() / WORD_BYTES);
      int start = in.position();
      in.slice().order(ByteOrder.LITTLE_ENDIAN).asShortBuffer().get(stage, 0, words);
      int done = 0;
      Stop stop = null;
      while (done < words && stop == null && out.size() < maxEvents) {
        stop = decodeWord(stage[done++] & 0xffff, out);
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

  private Stop decodeWord(int word, EventPacket out) {
    if ((word & TIME_BIT) != 0) {
      setTime(offsetUs + (word & WRAP_US - 1));
      return null;
    }
    int data = word & DATA;
    switch (word >> 12) {
      case ROW -> {
        if (data < layout.rows()) {
          row = unknownGap ? MISSING_ROW : data;
        } else {
          unknownWords++;
        }
      }
      case COLUMN_OFF -> event(data, 0, out);
      case COLUMN_ON -> event(data, 1, out);
      case WRAP -> {
        offsetUs += (long) WRAP_US * data;
        wrapsToAwaitReset = Math.max(0, wrapsToAwaitReset - Math.max(1, data));
        setTime(offsetUs);
      }
      case SPECIAL -> {
        return special(data);
      }
      default -> aside(word >> 12, data);
    }
    return null;
  }

  private void setTime(long newUs) {
    long missingUs = 0;
    if (newUs < timeUs && unknownGap) {
      missingUs = (timeUs - newUs + WRAP_US - 1) / WRAP_US * WRAP_US;
      offsetUs += missingUs;
    } else if (newUs < timeUs && !timeMayFall) {
      unknownWords++;
      return;
    }
    timeUs = newUs + missingUs;
    timeMayFall = false;
    unknownGap = false;
  }

  private void event(int column, int on, EventPacket out) {
    if (column >= layout.columns() || row == NO_ROW) {
      unknownWords++;
    } else if (wrapsToAwaitReset == 0 && row != MISSING_ROW) {
      int x = layout.swapped() ? row : column;
      int y = top - (layout.swapped() ? column : row);
      out.append(timeUs, EventAddress.pack(x, y, on));
    }
  }

  private Stop special(int data) {
    switch (data) {
      case CLOCK_RESET -> {
        return reset();
      }
      case 2 -> {
        return trigger(Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.FALLING);
      }
      case 3 -> {
        return trigger(Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING);
      }
      case 4 -> {
        return trigger(Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.PULSE);
      }
      case 16 -> {
        return trigger(Trigger.Source.SIGNAL_GENERATOR, Trigger.Edge.FALLING);
      }
      case 17 -> {
        return trigger(Trigger.Source.SIGNAL_GENERATOR, Trigger.Edge.RISING);
      }
      case 5 -> inertial.begin();
      case 7 -> {
        return deliver(inertial.end(timeUs));
      }
      case 8, 9, 10, 11, 12, 13, 14, 15 -> {
        return deliver(frames.mark(data, timeUs));
      }
      default -> unknownWords++;
    }
    return null;
  }

  private Stop trigger(Trigger.Source source, Trigger.Edge edge) {
    return samples ? deliver(new Trigger(timeUs, source, edge, 0)) : null;
  }

  private Stop deliver(SensorSample whole) {
    if (whole == null || !samples || wrapsToAwaitReset > 0) {
      return null;
    }
    sample = whole;
    return Stop.SAMPLE;
  }

  private Stop reset() {
    offsetUs = 0;
    timeUs = 0;
    unknownGap = false;
    frames.breakOff();
    inertial.breakOff();
    boolean awaited = wrapsToAwaitReset > 0;
    wrapsToAwaitReset = 0;
    return awaited ? null : Stop.CLOCK_RESET;
  }

  /** Words of frames and inertial samples. */
  private void aside(int code, int data) {
    if (!samples) {
      return;
    }
    switch (code) {
      case SAMPLE -> frames.sample(data & 0x3ff);
      case BYTES -> {
        int value = data & 0xff;
        switch (data >> 8) {
          case 0 -> inertial.add(value);
          case 1 -> frames.regionHigh(value);
          case 2 -> frames.regionLow(value);
          case 3 -> inertial.configure(value);
          default -> unknownWords++;
        }
      }
      default -> {
        // the exposure in clock cycles, equivalent to the times of its start and end
        unknownWords += data >> 10 == 0 ? 0 : 1;
      }
    }
  }

  @Override
  public SensorSample sample() {
    return sample;
  }

  @Override
  public void breakOff() {
    frames.breakOff();
    inertial.breakOff();
    timeMayFall = true;
  }

  @Override
  public void breakOffUnknown() {
    frames.breakOff();
    inertial.breakOff();
    row = MISSING_ROW;
    unknownGap = true;
  }

  @Override
  public long unknownWords() {
    return unknownWords;
  }

  @Override
  public DroppedWords droppedWords() {
    return new DavisDroppedWords(layout);
  }
}
