package haltere.device.protocol;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.evt.Evt3Decoder;
import haltere.core.stream.StreamNotification;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Decodes the EVT3 words of a Prophesee camera by {@link Evt3Decoder}, with edges on the camera's
 * input as triggers.
 */
public final class Evt3WireDecoder implements WireDecoder {
  static final int WORD_BYTES = 2;
  static final int TRIGGER = 0xa;

  private static final int LAST_TIME = 0;
  private static final int WORD_TIME = 3;
  private static final int ROW_AND_RUN = 4;
  private static final long NO_ROW = Long.MIN_VALUE;

  private final boolean samples;
  private final ViolationCounts violations = new ViolationCounts();
  private final Evt3Decoder decoder;
  private final long[] state;
  private long offset;

  /** Whether the high part of the time may be among missing bytes. */
  private boolean awaitsTime;

  private Trigger trigger;
  private volatile long unknownWords;

  /**
   * A decoder before the first word.
   *
   * @param geometry the sensor
   * @param samples whether edges on the camera's input are requested, as triggers
   */
  public Evt3WireDecoder(SensorGeometry geometry, boolean samples) {
    this.samples = samples;
    decoder = new Evt3Decoder(geometry, 0, violations);
    state = new long[decoder.stateLongs()];
  }

  @Override
  public Stop decode(ByteBuffer in, EventPacket out, int maxEvents) {
    int limit = in.limit();
    if (awaitsTime) {
      int time = next(Evt3DroppedWords.TIME_HIGH, in);
      awaitsTime = time == limit;
      offset += time - in.position();
      in.position(time);
    }
    int stop = samples ? next(TRIGGER, in) : limit;
    in.limit(stop);
    int before = in.position();
    boolean restarted = decoder.decode(in.order(ByteOrder.LITTLE_ENDIAN), offset, out, maxEvents);
    offset += in.position() - before;
    in.limit(limit);
    count();
    if (restarted) {
      decoder.times().acceptRestart();
      return Stop.CLOCK_RESET;
    }
    if (in.position() < stop && out.size() >= maxEvents) {
      return Stop.PACKET_FULL;
    }
    if (stop < limit && in.position() == stop) {
      trigger = trigger(in.getShort() & 0xffff);
      offset += WORD_BYTES;
      return Stop.SAMPLE;
    }
    if (in.hasRemaining()) {
      violations.add(Violation.CUT_OFF, offset);
      count();
      in.position(limit);
    }
    return Stop.INPUT_USED;
  }

  /** Position of the next word of a type, or the limit. */
  private static int next(int type, ByteBuffer in) {
    int at = in.position();
    while (at + WORD_BYTES <= in.limit() && (in.get(at + 1) & 0xf0) >> 4 != type) {
      at += WORD_BYTES;
    }
    return at + WORD_BYTES <= in.limit() ? at : in.limit();
  }

  private Trigger trigger(int word) {
    decoder.save(state, 0);
    return new Trigger(
        state[WORD_TIME],
        Trigger.Source.EXTERNAL_INPUT,
        (word & 1) != 0 ? Trigger.Edge.RISING : Trigger.Edge.FALLING,
        word >> 8 & 0xf);
  }

  private void count() {
    long odd = 0;
    for (Violation kind : Violation.values()) {
      odd += kind.isDamage() ? violations.count(kind) : 0;
    }
    unknownWords = odd;
  }

  @Override
  public SensorSample sample() {
    return trigger;
  }

  @Override
  public void breakOff() {
    decoder.save(state, 0);
    state[LAST_TIME] = StreamNotification.NO_TIME_US;
    decoder.restore(state, 0);
  }

  @Override
  public void breakOffUnknown() {
    decoder.save(state, 0);
    state[ROW_AND_RUN] = NO_ROW;
    decoder.restore(state, 0);
    awaitsTime = true;
  }

  @Override
  public long unknownWords() {
    return unknownWords;
  }

  @Override
  public DroppedWords droppedWords() {
    return new Evt3DroppedWords();
  }
}
