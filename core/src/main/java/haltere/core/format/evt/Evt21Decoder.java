package haltere.core.format.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;

/**
 * EVT2.1: little-endian words of 64 bits, each with a row of up to 32 neighbouring pixels that
 * fired at the same time. In the layout that is called legacy the halves of the words are swapped.
 */
public final class Evt21Decoder extends EvtDecoder {
  static final int WORD_BYTES = 8;
  private static final int VECTOR = 32;
  private static final int TIME_HIGH = 8;
  private static final int EXT_TRIGGER = 0xa;
  private static final int IMU = 0xd;
  private static final int OTHERS = 0xe;
  private static final int CONTINUED = 0xf;

  private final int turned;

  /**
   * A decoder before the first word.
   *
   * @param geometry the sensor; events outside are left out
   * @param firstTurnUs time at which the first turn of the clock begins, 0 for cameras
   * @param legacy whether the halves of the words are swapped
   * @param violations where to count what is wrong
   */
  public Evt21Decoder(
      SensorGeometry geometry, long firstTurnUs, boolean legacy, ViolationCounts violations) {
    super(geometry, EvtClock.wide(firstTurnUs), violations);
    turned = legacy ? 32 : 0;
  }

  /** How many of the words make sense, to find out in which of the layouts they are. */
  static int plausibleWords(byte[] bytes, int from, boolean legacy) {
    ByteBuffer words = ByteBuffer.wrap(bytes).order(java.nio.ByteOrder.LITTLE_ENDIAN);
    int plausible = 0;
    for (int i = from; i + WORD_BYTES <= bytes.length; i += WORD_BYTES) {
      long word = Long.rotateLeft(words.getLong(i), legacy ? 32 : 0);
      plausible +=
          switch ((int) (word >>> 60)) {
            case 0, 1 -> (int) word != 0 ? 1 : 0;
            case TIME_HIGH -> (int) word == 0 ? 2 : 0;
            default -> 0;
          };
    }
    return plausible;
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int end = start + (in.remaining() & -WORD_BYTES);
    int position = start;
    while (position < end && out.size() < maxEvents && !restarted) {
      if (handedOver == 0) {
        position = decodeRun(in, position, end, out, maxEvents);
      }
      if (position < end && out.size() < maxEvents) {
        long word = Long.rotateLeft(in.getLong(position), turned);
        if (decodeWord(word, offset + (position - start), out, maxEvents)) {
          position += WORD_BYTES;
        }
      }
    }
    in.position(position);
    return restarted;
  }

  /** Decodes until a word needs care or the packet is nearly full; returns where that is. */
  private int decodeRun(ByteBuffer in, int from, int end, EventPacket out, int maxEvents) {
    int limit = maxEvents - VECTOR;
    int size = out.size();
    if (clock.high() < 0 || size > limit) {
      return from;
    }
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int right = width - 1;
    int topRow = top;
    long startUs = clock.startUs();
    long previousUs = lastUs;
    int position = from;
    for (; position < end && size <= limit; position += WORD_BYTES) {
      long word = Long.rotateLeft(in.getLong(position), turned);
      if (word >>> 61 == 0) {
        int mask = (int) word;
        long timeUs = startUs + (word >>> 54 & 0x3f);
        int x = (int) (word >>> 43) & 0x7ff;
        int y = topRow - ((int) (word >>> 32) & 0x7ff);
        int last = x + 31 - Integer.numberOfLeadingZeros(mask);
        if ((timeUs - previousUs | y | right - last) < 0 || mask == 0) {
          break;
        }
        previousUs = timeUs;
        int address =
            y << EventAddress.Y_SHIFT | x << EventAddress.X_SHIFT | (int) (word >>> 60) & 1;
        do {
          times[size] = timeUs;
          addresses[size++] =
              address + (Integer.numberOfTrailingZeros(mask) << EventAddress.X_SHIFT);
          mask &= mask - 1;
        } while (mask != 0);
      } else if (word >>> 60 == TIME_HIGH) {
        startUs = clock.take((int) (word >>> 32) & 0xfffffff);
      } else {
        break;
      }
    }
    out.setSize(size);
    lastUs = previousUs;
    return position;
  }

  /** Decodes one word, whatever it is; false if it is not done with. */
  private boolean decodeWord(long word, long offset, EventPacket out, int maxEvents) {
    switch ((int) (word >>> 60)) {
      case 0, 1 -> {
        return decodeVector(word, offset, out, maxEvents);
      }
      case TIME_HIGH -> clock.take((int) (word >>> 32) & 0xfffffff);
      case EXT_TRIGGER, IMU, OTHERS, CONTINUED -> violations.add(Violation.OTHER_DATA, offset);
      default -> violations.add(Violation.UNKNOWN_WORD, offset);
    }
    return true;
  }

  private boolean decodeVector(long word, long offset, EventPacket out, int maxEvents) {
    int mask = (int) word;
    int x = (int) (word >>> 43) & 0x7ff;
    int y = top - ((int) (word >>> 32) & 0x7ff);
    int on = (int) (word >>> 60) & 1;
    if (clock.high() < 0) {
      violations.add(Violation.NO_TIME_YET, offset, Integer.bitCount(mask));
      return true;
    }
    int done = handedOver;
    handedOver = 0;
    long timeUs = clock.startUs() + (word >>> 54 & 0x3f);
    for (int bit = done; bit < VECTOR; bit++) {
      if ((mask >>> bit & 1) == 0) {
        continue;
      }
      if (x + bit >= width || y < 0) {
        violations.add(Violation.OUTSIDE_SENSOR, offset);
        continue;
      }
      if (out.size() == maxEvents || goesBack(timeUs, offset)) {
        handedOver = bit;
        return false;
      }
      out.append(timeUs, EventAddress.pack(x + bit, y, on));
      lastUs = timeUs;
    }
    return true;
  }
}
