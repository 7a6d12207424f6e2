package haltere.core.format.internal.bag;

import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.SampleCursor;
import haltere.core.format.internal.evt.TriggerWords;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Finds the external triggers among the EVT3 words of one topic of a bag, in messages that {@link
 * BagCursor} reads as well. That one counts their damage.
 *
 * <p>Thread rule: one thread.
 */
final class BagTriggerCursor implements SampleCursor {
  private final MessageWalk walk;
  private final TriggerWords words = new TriggerWords(TriggerWords.WordEncoding.EVT3, 0);
  private final MessageBody body = new MessageBody();
  private boolean inMessage;
  private Trigger trigger;

  /**
   * A cursor at the first message.
   *
   * @param walk stops at the messages of the topic; closed with the cursor
   */
  BagTriggerCursor(MessageWalk walk) {
    this.walk = walk;
  }

  @Override
  public SampleStep next(long untilOffset) throws IOException {
    trigger = null;
    while (trigger == null) {
      if (!inMessage && walk.position() >= untilOffset) {
        return SampleStep.NOTHING_YET;
      }
      try {
        if (!inMessage && !nextMessage()) {
          return SampleStep.END;
        }
        if (inMessage) {
          scan();
        }
      } catch (DamagedPacketException e) {
        inMessage = false;
        walk.damaged(e);
      }
    }
    return SampleStep.SAMPLE;
  }

  /** Opens the next message; false at the end. */
  private boolean nextMessage() throws IOException, DamagedPacketException {
    if (!walk.find()) {
      return false;
    }
    body.open(walk.payload(), walk.size());
    inMessage = EventMessage.read(walk.topic(), body).encoding().equals(Encoding.EVT3.word());
    if (!inMessage) {
      walk.pass(body.left());
    }
    return true;
  }

  /** Reads the available words of the message up to a trigger. */
  private void scan() throws IOException, DamagedPacketException {
    int from = body.from();
    ByteBuffer in = ByteBuffer.wrap(body.bytes(), from, body.to() - from);
    trigger = words.next(in.order(ByteOrder.LITTLE_ENDIAN));
    body.use(in.position() - from);
    if (trigger == null && !body.more()) {
      inMessage = false;
      walk.pass(body.left());
    }
  }

  @Override
  public SensorSample sample() {
    return trigger;
  }

  @Override
  public long offset() {
    return walk.offset(body.used());
  }

  @Override
  public void restore(long[] state, int at) throws IOException {
    inMessage = false;
    walk.restore(state, at + BagCursor.OWN_LONGS);
    words.restore(state, at + BagCursor.OWN_LONGS + MessageWalk.PLACE_LONGS);
    try {
      if (state[at] >= 0 && nextMessage() && inMessage) {
        body.skip(state[at]);
      }
    } catch (DamagedPacketException e) {
      inMessage = false;
      walk.damaged(e);
    }
  }

  @Override
  public void close() throws IOException {
    walk.close();
  }
}
