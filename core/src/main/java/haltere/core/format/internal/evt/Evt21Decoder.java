package haltere.core.format.internal.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;
import java.nio.LongBuffer;

/**
 * EVT2.1: little-endian words of 64 bits, each with a row of up to 32 neighbouring pixels that
 * fired at the same time. In the legacy layout the halves of the words are swapped.
 */
final class Evt21Decoder extends EvtDecoder {
  static final int WORD_BYTES = 8;
  private static final int VECTOR = 32;
  private static final int COLUMN = 0x7fff << EventAddress.X_SHIFT;
  private static final int TIME_HIGH = 8;
  private static final int EXT_TRIGGER = 0xa;
  private static final int IMU = 0xd;
  private static final int OTHERS = 0xe;
  private static final int CONTINUED = 0xf;

  /** Words that are processed together. */
  private static final int STAGE_WORDS = 512;

  /** Copied words; an array is read faster than a buffer. */
  private final long[] stage = new long[STAGE_WORDS];

  /** Addresses of the first pixels of the staged words; negative for irregular words. */
  private final long[] firstPixels = new long[STAGE_WORDS];

  private final boolean legacy;

  /**
   * A decoder before the first word.
   *
   * @param geometry the sensor; events outside are skipped
   * @param firstTurnUs start time of the first clock period, 0 for cameras
   * @param legacy whether the halves of the words are swapped
   * @param violations counts violations
   */
  public Evt21Decoder(
      SensorGeometry geometry, long firstTurnUs, boolean legacy, ViolationCounts violations) {
    super(geometry, EvtClock.wide(firstTurnUs), violations);
    this.legacy = legacy;
  }

  /** Number of plausible words in a layout, for its detection. */
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
    LongBuffer words = in.asLongBuffer();
    int end = words.limit();
    int first = 0;
    while (first < end && out.size() < maxEvents && !times.restarted()) {
      int count = Math.min(STAGE_WORDS, end - first);
      words.get(first, stage, 0, count);
      if (legacy) {
        turn(count);
      }
      prepare(count);
      first += decodeStage(count, offset + (long) first * WORD_BYTES, out, maxEvents);
    }
    in.position(in.position() + first * WORD_BYTES);
    return times.restarted();
  }

  /** Swaps the halves of staged words. */
  private void turn(int count) {
    for (int i = 0; i < count; i++) {
      stage[i] = Long.rotateLeft(stage[i], 32);
    }
  }

  /** One integer width and no branch, so that the compiler vectorises the loop. */
  private void prepare(int count) {
    long[] words = stage;
    long[] first = firstPixels;
    long topRow = (long) top << EventAddress.Y_SHIFT;
    for (int i = 0; i < count; i++) {
      long word = words[i];
      long address =
          topRow
              - (word >>> 32 - EventAddress.Y_SHIFT & 0x7ff0000)
              + (word >>> 43 - EventAddress.X_SHIFT & 0xffe)
              + (word >>> 60 & 1);
      first[i] = address | -(word >>> 61);
    }
  }

  /** Decodes words of the stage until the packet is full; returns their number. */
  private int decodeStage(int count, long offset, EventPacket out, int maxEvents) {
    int at = 0;
    while (at < count && out.size() < maxEvents && !times.restarted()) {
      if (handedOver == 0) {
        at = decodeRun(at, count, out, maxEvents);
      }
      if (at < count && out.size() < maxEvents) {
        at += decodeWord(stage[at], offset + (long) at * WORD_BYTES, out, maxEvents) ? 1 : 0;
      }
    }
    return at;
  }

  /** Decodes up to an irregular word or a nearly full packet; returns its index. */
  private int decodeRun(int from, int end, EventPacket out, int maxEvents) {
    int at = from;
    while (at < end && clock.high() >= 0) {
      long word = stage[at];
      int next = at;
      if (word >>> 60 == TIME_HIGH) {
        clock.take((int) (word >>> 32) & 0xfffffff);
        next++;
      } else {
        next = decodeEvents(at, end, out, maxEvents - VECTOR);
        if (next == at) {
          break;
        }
      }
      at = next;
    }
    return at;
  }

  /**
   * Decodes events up to another or irregular word, or a limit of events; returns its index. The
   * loop has few variables, so that all stay in registers.
   */
  private int decodeEvents(int from, int end, EventPacket out, int limit) {
    long[] words = stage;
    long[] first = firstPixels;
    long[] timesUs = out.timesUs();
    int[] addresses = out.addresses();
    int size = out.size();
    long startUs = clock.startUs();
    int right = width << EventAddress.X_SHIFT;
    long beforeUs = startUs + lowNow(startUs);
    int at = from;
    while (at < end && size <= limit) {
      long word = words[at];
      int mask = (int) word;
      long address = first[at];
      long timeUs = startUs + (word >>> 54 & 0x3f);
      // negative if it is not an event, time goes back or the row is outside
      if ((address | timeUs - beforeUs) < 0 || mask == 0) {
        break;
      }
      int base = (int) address;
      int column = base & COLUMN;
      int last = Integer.numberOfTrailingZeros(mask) << EventAddress.X_SHIFT;
      timesUs[size] = timeUs;
      addresses[size] = base + last;
      int next = size + 1;
      mask &= mask - 1;
      while (mask != 0) {
        last = Integer.numberOfTrailingZeros(mask) << EventAddress.X_SHIFT;
        timesUs[next] = timeUs;
        addresses[next++] = base + last;
        mask &= mask - 1;
      }
      if (column + last >= right) {
        break;
      }
      beforeUs = timeUs;
      size = next;
      at++;
    }
    out.setSize(size);
    if (at > from) {
      times.advance(beforeUs);
    }
    return at;
  }

  /** Decodes any word; false if it is not completed. */
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
      times.advance(timeUs);
    }
    return true;
  }
}
