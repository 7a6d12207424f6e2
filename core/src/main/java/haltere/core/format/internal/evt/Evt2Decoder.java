package haltere.core.format.internal.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;
import java.nio.IntBuffer;

/** EVT2: little-endian words of 32 bits, at most one event in each. */
final class Evt2Decoder extends EvtDecoder {
  private static final int WORD_BYTES = 4;
  private static final int TIME_HIGH = 8;
  private static final int EXT_TRIGGER = 0xa;
  private static final int IMU = 0xd;
  private static final int OTHERS = 0xe;
  private static final int CONTINUED = 0xf;

  /** Words that are processed together. */
  private static final int STAGE_WORDS = 1024;

  /** Copied words; an array is read faster than a buffer. */
  private final int[] stage = new int[STAGE_WORDS];

  /**
   * A decoder before the first word.
   *
   * @param geometry the sensor; events outside are skipped
   * @param firstTurnUs start time of the first clock period, 0 for cameras
   * @param violations counts violations
   */
  public Evt2Decoder(SensorGeometry geometry, long firstTurnUs, ViolationCounts violations) {
    super(geometry, EvtClock.wide(firstTurnUs), violations);
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    IntBuffer words = in.asIntBuffer();
    int end = words.limit();
    int first = 0;
    while (first < end && out.size() < maxEvents && !times.restarted()) {
      int count = Math.min(STAGE_WORDS, end - first);
      words.get(first, stage, 0, count);
      first += decodeStage(count, offset + (long) first * WORD_BYTES, out, maxEvents);
    }
    in.position(in.position() + first * WORD_BYTES);
    return times.restarted();
  }

  /** Decodes words of the stage until the packet is full; returns their number. */
  private int decodeStage(int count, long offset, EventPacket out, int maxEvents) {
    int at = 0;
    while (at < count && out.size() < maxEvents && !times.restarted()) {
      at = decodeRun(at, count, out, maxEvents);
      if (at < count && out.size() < maxEvents) {
        at += decodeWord(stage[at], offset + (long) at * WORD_BYTES, out) ? 1 : 0;
      }
    }
    return at;
  }

  /** Decodes up to an irregular word or a full packet; returns its index. */
  private int decodeRun(int from, int end, EventPacket out, int maxEvents) {
    int at = from;
    while (at < end && out.size() < maxEvents && clock.high() >= 0) {
      int word = stage[at];
      int events = 0;
      if (word >>> 28 == TIME_HIGH) {
        clock.take(word & 0xfffffff);
        at++;
      } else {
        events = decodeEvents(at, Math.min(end - at, maxEvents - out.size()), out);
        if (events == 0) {
          break;
        }
      }
      at += events;
    }
    return at;
  }

  /**
   * Decodes events up to another word or an irregular event; returns their number. The loop has few
   * variables, so that all stay in registers.
   */
  private int decodeEvents(int from, int max, EventPacket out) {
    int[] words = stage;
    long[] timesUs = out.timesUs();
    int[] addresses = out.addresses();
    int size = out.size();
    long startUs = clock.startUs();
    int right = width - 1 << EventAddress.X_SHIFT;
    int topRow = top << EventAddress.Y_SHIFT;
    int low = lowNow(startUs);
    int count = 0;
    while (count < max) {
      int word = words[from + count];
      int newLow = word >>> 22;
      int column = word >>> 10 & 0xffe;
      int address = topRow - (word << EventAddress.Y_SHIFT & 0x7ff0000) + column + (word >>> 28);
      // negative if it is not an event, time goes back or the pixel is outside
      if ((-(word >>> 29) | (newLow & 0x3f) - low | address | right - column) < 0) {
        break;
      }
      low = newLow & 0x3f;
      timesUs[size + count] = startUs + low;
      addresses[size + count] = address;
      count++;
    }
    out.setSize(size + count);
    if (count > 0) {
      times.advance(startUs + low);
    }
    return count;
  }

  /** Decodes any word; false if the clock goes back there. */
  private boolean decodeWord(int word, long offset, EventPacket out) {
    switch (word >>> 28) {
      case 0, 1 -> {
        if (clock.high() < 0) {
          violations.add(Violation.NO_TIME_YET, offset);
          return true;
        }
        int x = word >>> 11 & 0x7ff;
        int y = top - (word & 0x7ff);
        if (x >= width || y < 0) {
          violations.add(Violation.OUTSIDE_SENSOR, offset);
          return true;
        }
        long timeUs = clock.startUs() + (word >>> 22 & 0x3f);
        if (goesBack(timeUs, offset)) {
          return false;
        }
        out.append(timeUs, EventAddress.pack(x, y, word >>> 28));
        times.advance(timeUs);
      }
      case TIME_HIGH -> clock.take(word & 0xfffffff);
      case EXT_TRIGGER, IMU, OTHERS, CONTINUED -> violations.add(Violation.OTHER_DATA, offset);
      default -> violations.add(Violation.UNKNOWN_WORD, offset);
    }
    return true;
  }
}
