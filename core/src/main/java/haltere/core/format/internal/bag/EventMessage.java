package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.IOException;

/**
 * Header of a message with events. Both types begin with the standard header (in ROS 1 with a
 * sequence number), height and width; then {@code EventArray} has the number of events, {@code
 * EventPacket} a sequence number, a time base, the name of the encoding, the byte order, and the
 * number of bytes. ROS 2 begins with four bytes for the serialisation and aligns each number to its
 * size.
 *
 * @param stampNs the header's time, nanoseconds since 1970
 * @param width stated columns
 * @param height stated rows
 * @param number sequence number; -1 if the type has none
 * @param timeBaseNs offset of times in the encoding
 * @param encoding of the events
 * @param bigEndian byte order of encodings in the machine's order
 * @param events stated number of events or bytes
 * @param oversized whether that number exceeds the message
 */
record EventMessage(
    long stampNs,
    long width,
    long height,
    long number,
    long timeBaseNs,
    String encoding,
    boolean bigEndian,
    long events,
    boolean oversized) {
  /** Encoding name for an {@code EventArray}. */
  static final String ARRAY = "array";

  private static final long NS_PER_S = 1_000_000_000;
  private static final int CDR_LITTLE_ENDIAN = 0x0100;
  private static final long NO_NUMBER = -1;

  /** Reads up to the first event; the body then ends with the events. */
  static EventMessage read(BagTopic topic, MessageBody body)
      throws IOException, DamagedPacketException {
    boolean cdr = topic.cdr();
    int start = 0;
    long seconds;
    if (cdr) {
      if ((body.takeInt() & 0xffff) != CDR_LITTLE_ENDIAN) {
        throw new DamagedPacketException("a serialisation that is not little-endian CDR");
      }
      start = 4;
      seconds = body.takeInt();
    } else {
      body.takeInt();
      seconds = body.takeUnsignedInt();
    }
    long stampNs = seconds * NS_PER_S + body.takeUnsignedInt();
    body.takeText();
    body.align(cdr ? 4 : 1, start);
    long height = body.takeUnsignedInt();
    long width = body.takeUnsignedInt();
    if (topic.kind() == BagTopic.TopicKind.ARRAY) {
      long count = body.takeUnsignedInt();
      long whole = EventArrayDecoder.bytes(count, cdr);
      boolean oversized = whole > body.left();
      body.shorten(whole);
      return new EventMessage(stampNs, width, height, NO_NUMBER, 0, ARRAY, false, count, oversized);
    }
    body.align(cdr ? 8 : 1, start);
    long number = body.takeLong();
    long timeBaseNs = body.takeLong();
    String encoding = body.takeText();
    boolean bigEndian = body.takeByte() != 0;
    body.align(cdr ? 4 : 1, start);
    long bytes = body.takeUnsignedInt();
    boolean oversized = bytes > body.left();
    body.shorten(bytes);
    return new EventMessage(
        stampNs, width, height, number, timeBaseNs, encoding, bigEndian, bytes, oversized);
  }
}
