package haltere.core.format.evt;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import java.nio.ByteBuffer;

/** EVT2: little-endian words of 32 bits, at most one event in each. */
public final class Evt2Decoder extends EvtDecoder {
  private static final int WORD_BYTES = 4;
  private static final int TIME_HIGH = 8;
  private static final int EXT_TRIGGER = 0xa;
  private static final int IMU = 0xd;
  private static final int OTHERS = 0xe;
  private static final int CONTINUED = 0xf;

  /**
   * A decoder before the first word.
   *
   * @param geometry the sensor; events outside are left out
   * @param firstTurnUs time at which the first turn of the clock begins, 0 for cameras
   * @param violations where to count what is wrong
   */
  public Evt2Decoder(SensorGeometry geometry, long firstTurnUs, ViolationCounts violations) {
    super(geometry, EvtClock.wide(firstTurnUs), violations);
  }

  @Override
  public boolean decode(ByteBuffer in, long offset, EventPacket out, int maxEvents) {
    out.ensureCapacity(maxEvents);
    int start = in.position();
    int end = start + (in.remaining() & -WORD_BYTES);
    int position = start;
    while (position < end && out.size() < maxEvents && !restarted) {
      position = decodeRun(in, position, end, out, maxEvents);
      if (position < end && out.size() < maxEvents) {
        int word = in.getInt(position);
        if (decodeWord(word, offset + (position - start), out)) {
          position += WORD_BYTES;
        }
      }
    }
    in.position(position);
    return restarted;
  }

  /** Decodes until a word needs care or the packet is full; returns where that is. */
  private int decodeRun(ByteBuffer in, int from, int end, EventPacket out, int maxEvents) {
    if (clock.high() < 0) {
      return from;
    }
    long[] times = out.timesUs();
    int[] addresses = out.addresses();
    int right = width - 1;
    int topRow = top;
    int size = out.size();
    long startUs = clock.startUs();
    long previousUs = lastUs;
    int position = from;
    int stop = (int) Math.min(end, position + (long) (maxEvents - size) * WORD_BYTES);
    for (; position < stop; position += WORD_BYTES) {
      int word = in.getInt(position);
      if (word >>> 29 == 0) {
        long timeUs = startUs + (word >>> 22 & 0x3f);
        int x = word >>> 11 & 0x7ff;
        int y = topRow - (word & 0x7ff);
        if ((timeUs - previousUs | y | right - x) < 0) {
          break;
        }
        times[size] = timeUs;
        addresses[size++] = y << EventAddress.Y_SHIFT | x << EventAddress.X_SHIFT | word >>> 28;
        previousUs = timeUs;
      } else if (word >>> 28 == TIME_HIGH) {
        startUs = clock.take(word & 0xfffffff);
      } else {
        break;
      }
    }
    out.setSize(size);
    lastUs = previousUs;
    return position;
  }

  /** Decodes one word, whatever it is; false if the clock goes back there. */
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
        lastUs = timeUs;
      }
      case TIME_HIGH -> clock.take(word & 0xfffffff);
      case EXT_TRIGGER, IMU, OTHERS, CONTINUED -> violations.add(Violation.OTHER_DATA, offset);
      default -> violations.add(Violation.UNKNOWN_WORD, offset);
    }
    return true;
  }
}
