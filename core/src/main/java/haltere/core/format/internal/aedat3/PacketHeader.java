package haltere.core.format.internal.aedat3;

import java.nio.ByteBuffer;

/**
 * The header of a packet.
 *
 * @param kind of its events
 * @param source number of the camera
 * @param eventBytes bytes of an event
 * @param timeOffset byte offset of the time in an event
 * @param overflow wraps of the 31-bit clock before it
 * @param capacity maximum number of events
 * @param number number of events
 * @param valid number of valid events
 */
record PacketHeader(
    int kind,
    int source,
    long eventBytes,
    int timeOffset,
    int overflow,
    int capacity,
    int number,
    int valid) {
  static final int BYTES = 28;
  static final int SPECIAL = 0;
  static final int POLARITY = 1;
  static final int FRAME = 2;
  static final int INERTIAL_6 = 3;
  static final int INERTIAL_9 = 4;

  private static final int POLARITY_BYTES = 8;
  private static final int POLARITY_TIME_OFFSET = 4;
  private static final int MAX_KIND = 31;
  private static final int MAX_EVENT_BYTES = 64 * 1024 * 1024;

  static PacketHeader read(ByteBuffer in, int position) {
    return new PacketHeader(
        in.getShort(position),
        in.getShort(position + 2),
        in.getInt(position + 4),
        in.getInt(position + 8),
        in.getInt(position + 12),
        in.getInt(position + 16),
        in.getInt(position + 20),
        in.getInt(position + 24));
  }

  /** Whether its values are possible. */
  boolean isPossible() {
    return kind >= 0
        && kind <= MAX_KIND
        && source >= 0
        && eventBytes > 0
        && eventBytes <= MAX_EVENT_BYTES
        && (kind != POLARITY || eventBytes == POLARITY_BYTES && timeOffset == POLARITY_TIME_OFFSET)
        && timeOffset >= 0
        && timeOffset < eventBytes
        && overflow >= 0
        && valid >= 0
        && number >= valid
        && capacity >= number;
  }

  /** Whether decoding can continue with it after damage. */
  boolean canFollowDamage(long bytesLeft) {
    return isPossible()
        && kind == POLARITY
        && number > 0
        && payloadBytes() <= bytesLeft
        && source <= MAX_KIND;
  }

  /** Bytes of the packet after its header. */
  long payloadBytes() {
    return capacity * eventBytes;
  }
}
