package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import java.io.IOException;

/**
 * Header of a message with events. Both types begin with the standard header (in ROS 1 with a
 * number), height and width; then {@code EventArray} has the count of its events, {@code
 * EventPacket} a number, a base of time, the name of the encoding, the order of bytes, and the
 * count of bytes. ROS 2 begins with four bytes that name the serialisation and aligns each number
 * to its size.
 *
 * @param stampNs the header's time, nanoseconds since 1970
 * @param width stated columns
 * @param height stated rows
 * @param number counts up by one; -1 where the type has none
 * @param timeBaseNs offset of times in the encoding
 * @param encoding of the events
 * @param bigEndian whether numbers of encodings in the machine's order begin with the highest byte
 * @param events count of events or bytes, as it says
 * @param lying whether that count is more than the message holds
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
    boolean lying) {
  /** What an {@code EventArray} counts as. */
  static final String ARRAY = "array";

  private static final long NS_PER_S = 1_000_000_000;
  private static final int CDR_LITTLE_ENDIAN = 0x0100;
  private static final long NO_NUMBER = -1;

  /** Reads up to the first event; the body's end is then that of the events. */
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
    if (topic.kind() == BagTopic.Kind.ARRAY) {
      long count = body.takeUnsignedInt();
      long whole = EventArrayDecoder.bytes(count, cdr);
      boolean lying = whole > body.left();
      body.shorten(whole);
      return new EventMessage(stampNs, width, height, NO_NUMBER, 0, ARRAY, false, count, lying);
    }
    body.align(cdr ? 8 : 1, start);
    long number = body.takeLong();
    long timeBaseNs = body.takeLong();
    String encoding = body.takeText();
    boolean bigEndian = body.takeByte() != 0;
    body.align(cdr ? 4 : 1, start);
    long bytes = body.takeUnsignedInt();
    boolean lying = bytes > body.left();
    body.shorten(bytes);
    return new EventMessage(
        stampNs, width, height, number, timeBaseNs, encoding, bigEndian, bytes, lying);
  }
}
