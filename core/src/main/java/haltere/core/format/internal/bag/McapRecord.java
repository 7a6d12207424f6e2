package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Payload;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * Reads the records of an MCAP file: a byte for the kind, 64 bits of length, content.
 *
 * <p>Thread rule: one thread.
 */
final class McapRecord {
  static final int HEADER = 1;
  static final int FOOTER = 2;
  static final int SCHEMA = 3;
  static final int CHANNEL = 4;
  static final int MESSAGE = 5;
  static final int CHUNK = 6;
  static final int MESSAGE_INDEX = 7;
  static final int CHUNK_INDEX = 8;
  static final int STATISTICS = 11;
  static final int METADATA = 12;
  static final int METADATA_INDEX = 13;
  static final int SUMMARY_OFFSET = 14;
  static final int DATA_END = 15;

  /** First kind of private records. */
  static final int PRIVATE = 0x80;

  /** Kind and length. */
  static final int HEAD_BYTES = 9;

  private static final int MAX_TEXT = 64 * 1024;

  private final Payload payload;
  private int kind;
  private long left;
  private long bytes;

  /** Reads records from an open payload. */
  McapRecord(Payload payload) {
    this.payload = payload;
  }

  /**
   * Reads kind and length of the next record.
   *
   * @return false at the end
   */
  boolean next() throws IOException, DamagedPacketException {
    if (!payload.gather(HEAD_BYTES)) {
      if (payload.from() == payload.to()) {
        return false;
      }
      throw new DamagedPacketException("a record that ends too early");
    }
    kind = payload.data()[payload.from()] & 0xff;
    bytes = LittleEndian.getLong(payload.data(), payload.from() + 1);
    left = bytes;
    payload.use(HEAD_BYTES);
    if (kind == 0 || bytes < 0) {
      throw new DamagedPacketException("a record of an unknown type");
    }
    return true;
  }

  int kind() {
    return kind;
  }

  /** Bytes of its content. */
  long bytes() {
    return bytes;
  }

  /** Unused bytes of its content. */
  long left() {
    return left;
  }

  private int take(int count) throws IOException, DamagedPacketException {
    if (count > left || !payload.gather(count)) {
      throw new DamagedPacketException("a record that ends too early");
    }
    left -= count;
    int at = payload.from();
    payload.use(count);
    return at;
  }

  int takeUnsignedShort() throws IOException, DamagedPacketException {
    int at = take(2);
    return LittleEndian.getUnsignedShort(payload.data(), at);
  }

  long takeUnsignedInt() throws IOException, DamagedPacketException {
    int at = take(4);
    return LittleEndian.getInt(payload.data(), at) & 0xffff_ffffL;
  }

  long takeLong() throws IOException, DamagedPacketException {
    int at = take(8);
    return LittleEndian.getLong(payload.data(), at);
  }

  String takeText() throws IOException, DamagedPacketException {
    long length = takeUnsignedInt();
    if (length > MAX_TEXT) {
      throw new DamagedPacketException("a text that is too long");
    }
    int at = take((int) length);
    return new String(payload.data(), at, (int) length, StandardCharsets.UTF_8);
  }

  /** Skips the rest. */
  void pass() throws IOException, DamagedPacketException {
    payload.skip(left);
    left = 0;
  }
}
