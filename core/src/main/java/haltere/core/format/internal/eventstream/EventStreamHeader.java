package haltere.core.format.internal.eventstream;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;

/**
 * The header of an Event Stream file.
 *
 * @param version major number of the version
 * @param kind of the events
 * @param width columns, 0 for generic events
 * @param height rows, 0 for generic events
 * @param dataOffset offset of the first event
 */
record EventStreamHeader(int version, int kind, int width, int height, int dataOffset) {
  static final byte[] MAGIC = "Event Stream".getBytes(StandardCharsets.US_ASCII);
  static final int GENERIC = 0;
  static final int DVS = 1;
  static final int ATIS = 2;
  static final int COLOUR = 4;
  static final int MAX_BYTES = 20;

  /** Reads a header; empty if it is invalid or incomplete. */
  static Optional<EventStreamHeader> parse(byte[] bytes) {
    int magic = MAGIC.length;
    if (bytes.length < magic + 4 || !Arrays.equals(bytes, 0, magic, MAGIC, 0, magic)) {
      return Optional.empty();
    }
    int version = bytes[magic] & 0xff;
    int kind = bytes[magic + 3] & 0xff;
    if (kind == GENERIC) {
      return Optional.of(new EventStreamHeader(version, kind, 0, 0, magic + 4));
    }
    if (bytes.length < MAX_BYTES) {
      return Optional.empty();
    }
    return Optional.of(
        new EventStreamHeader(
            version,
            kind,
            bytes[magic + 4] & 0xff | (bytes[magic + 5] & 0xff) << 8,
            bytes[magic + 6] & 0xff | (bytes[magic + 7] & 0xff) << 8,
            MAX_BYTES));
  }
}
