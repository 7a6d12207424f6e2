package haltere.core.format.internal.bag;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingClock;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.internal.clock.EventTimes;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.decoding.EventCursor;
import haltere.core.format.internal.decoding.StreamDecoder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;

/**
 * Decodes the events of one topic of a bag, message by message.
 *
 * <p>Thread rule: one thread.
 */
final class BagCursor implements EventCursor {
  /** Number of its own state values, before those of the walk and the decoder. */
  static final int OWN_LONGS = 2;

  private static final long UNKNOWN = -1;

  private final MessageWalk walk;
  private final Encoding encoding;
  private final Optional<String> compression;
  private final StreamDecoder decoder;
  private final ViolationCounts violations;
  private final MessageBody body = new MessageBody();

  private ByteBuffer buffer = ByteBuffer.allocate(0);
  private boolean bigEndian;
  private boolean inMessage;
  private long eventsAt;
  private long number = UNKNOWN;

  /**
   * A cursor at the first message.
   *
   * @param walk stops at the messages of the topic; closed with the cursor
   * @param geometry the sensor
   * @param encoding of the events; messages in another are counted and skipped
   * @param cdr whether messages are serialised as in ROS 2
   * @param compression of the first message; empty if there is none
   * @param violations counts violations
   */
  BagCursor(
      MessageWalk walk,
      SensorGeometry geometry,
      Encoding encoding,
      boolean cdr,
      Optional<String> compression,
      ViolationCounts violations) {
    this.walk = walk;
    this.compression = compression;
    this.encoding = encoding;
    this.violations = violations;
    decoder = encoding.decoder(geometry, cdr, violations);
  }

  @Override
  public Optional<String> compression() {
    return compression;
  }

  @Override
  public Stop read(EventPacket out, int maxEvents) throws IOException {
    while (out.size() < maxEvents) {
      if (!inMessage && !nextMessage()) {
        return Stop.END;
      }
      try {
        if (inMessage && decode(out, maxEvents)) {
          return Stop.CLOCK_WENT_BACK;
        }
      } catch (DamagedPacketException e) {
        damaged(e);
      }
    }
    return Stop.MORE;
  }

  /** Opens the next readable message; false at the end. */
  private boolean nextMessage() throws IOException {
    if (!walk.find()) {
      return false;
    }
    try {
      body.open(walk.payload(), walk.size());
      start(EventMessage.read(walk.topic(), body));
    } catch (DamagedPacketException e) {
      damaged(e);
    }
    return true;
  }

  private void start(EventMessage message) throws IOException {
    long offset = walk.offset(0);
    if (message.number() >= 0) {
      if (number >= 0 && message.number() > number + 1) {
        violations.add(Violation.MISSING_MESSAGE, offset, message.number() - number - 1);
      }
      number = message.number();
    }
    if (message.oversized()) {
      violations.add(Violation.IMPOSSIBLE_LENGTH, offset);
    }
    if (!encoding.word().equals(message.encoding())) {
      if (message.encoding().equals(Encoding.TRIGGER.word())) {
        violations.add(Violation.OTHER_DATA, offset, Encoding.triggers(message));
      } else {
        violations.add(Violation.DAMAGED_PACKET, offset);
      }
      pass();
      return;
    }
    bigEndian = message.bigEndian() && encoding == Encoding.MONO;
    eventsAt = body.used();
    inMessage = true;
    if (decoder instanceof MessageDecoder messages) {
      messages.startMessage(message);
    }
  }

  private void pass() throws IOException {
    inMessage = false;
    walk.pass(walk.size() - body.used());
    violations.reached(walk.position());
  }

  private void damaged(DamagedPacketException damage) throws IOException {
    inMessage = false;
    walk.damaged(damage);
    violations.reached(walk.position());
  }

  /** Returns true if the clock goes back with the next event. */
  private boolean decode(EventPacket out, int maxEvents)
      throws IOException, DamagedPacketException {
    while (true) {
      int from = body.from();
      ByteBuffer in = in(from, body.to());
      boolean back = decoder.decode(in, walk.offset(body.used()), out, maxEvents);
      body.use(in.position() - from);
      violations.reached(walk.offset(body.used()));
      if (back) {
        return true;
      }
      if (body.left() == 0) {
        pass();
        return false;
      }
      if (out.size() >= maxEvents) {
        return false;
      }
      if (!body.more()) {
        // less than an event remains
        violations.add(Violation.IMPOSSIBLE_LENGTH, walk.offset(body.used()));
        pass();
        return false;
      }
    }
  }

  private ByteBuffer in(int from, int to) {
    byte[] data = body.bytes();
    if (buffer.array() != data) {
      buffer = ByteBuffer.wrap(data);
    }
    buffer.order(bigEndian ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    return buffer.limit(to).position(from);
  }

  @Override
  public RecordingClock clock() {
    return decoder.clock();
  }

  @Override
  public EventTimes times() {
    return decoder.times();
  }

  @Override
  public long positionBytes() {
    return inMessage ? walk.offset(body.used()) : walk.position();
  }

  @Override
  public int stateLongs() {
    return OWN_LONGS + MessageWalk.PLACE_LONGS + decoder.stateLongs();
  }

  @Override
  public void save(long[] state, int at) {
    state[at] = inMessage ? body.used() - eventsAt : UNKNOWN;
    state[at + 1] = number;
    walk.save(state, at + OWN_LONGS);
    decoder.save(state, at + OWN_LONGS + MessageWalk.PLACE_LONGS);
  }

  @Override
  public void restore(long[] state, int at) throws IOException {
    inMessage = false;
    number = UNKNOWN;
    walk.restore(state, at + OWN_LONGS);
    long skipped = state[at];
    if (skipped >= 0 && nextMessage() && inMessage) {
      try {
        body.skip(skipped);
      } catch (DamagedPacketException e) {
        damaged(e);
      }
    }
    number = state[at + 1];
    decoder.restore(state, at + OWN_LONGS + MessageWalk.PLACE_LONGS);
  }

  @Override
  public void close() throws IOException {
    walk.close();
  }
}
