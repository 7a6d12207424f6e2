package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.ByteSource;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Payload;
import java.io.IOException;
import java.nio.charset.StandardCharsets;

/**
 * The bytes of one message, read from its start; also a source of compressed bytes.
 *
 * <p>Thread rule: one thread.
 */
final class MessageBody implements ByteSource {
  private static final int MAX_TEXT = 4096;

  private Payload payload;
  private long size;
  private long used;

  /** Opens a message. */
  void open(Payload bytes, long messageBytes) {
    payload = bytes;
    size = messageBytes;
    used = 0;
  }

  /** Number of used bytes. */
  long used() {
    return used;
  }

  /** Number of unused bytes. */
  long left() {
    return size - used;
  }

  /** Sets an earlier end of the message. */
  void shorten(long bytesLeft) {
    size = used + Math.min(left(), bytesLeft);
  }

  @Override
  public byte[] bytes() {
    return payload.data();
  }

  int from() {
    return payload.from();
  }

  /** End of the available bytes of the message. */
  int to() {
    return (int) Math.min(payload.to(), payload.from() + left());
  }

  void use(int bytes) {
    payload.use(bytes);
    used += bytes;
  }

  /** Reads more bytes; false at the end of the message. */
  boolean more() throws IOException, DamagedPacketException {
    if (left() <= payload.to() - payload.from()) {
      return false;
    }
    if (!payload.more()) {
      throw new DamagedPacketException("a message that ends too early");
    }
    return true;
  }

  @Override
  public int require(long offset, int count) throws IOException, DamagedPacketException {
    long passed = offset - used;
    if (passed + count > left()) {
      return -1;
    }
    skip(passed);
    return payload.gather(count) ? from() : -1;
  }

  void skip(long bytes) throws IOException, DamagedPacketException {
    if (bytes > left()) {
      throw new DamagedPacketException("a message that ends too early");
    }
    payload.skip(bytes);
    used += bytes;
  }

  /** Skips padding up to a multiple of a number of bytes. */
  void align(int bytes, long start) throws IOException, DamagedPacketException {
    skip(-(used - start) & bytes - 1);
  }

  private int take(int bytes) throws IOException, DamagedPacketException {
    if (bytes > left() || !payload.gather(bytes)) {
      throw new DamagedPacketException("a message that ends too early");
    }
    int at = payload.from();
    use(bytes);
    return at;
  }

  int takeByte() throws IOException, DamagedPacketException {
    int at = take(1);
    return bytes()[at];
  }

  int takeInt() throws IOException, DamagedPacketException {
    int at = take(4);
    return LittleEndian.getInt(bytes(), at);
  }

  long takeUnsignedInt() throws IOException, DamagedPacketException {
    return takeInt() & 0xffff_ffffL;
  }

  long takeLong() throws IOException, DamagedPacketException {
    int at = take(8);
    return LittleEndian.getLong(bytes(), at);
  }

  /** A length-prefixed text. */
  String takeText() throws IOException, DamagedPacketException {
    long length = takeUnsignedInt();
    if (length > MAX_TEXT) {
      throw new DamagedPacketException("a text that is too long");
    }
    int at = take((int) length);
    int end = at + (int) length;
    if (end > at && bytes()[end - 1] == 0) {
      end--;
    }
    return new String(bytes(), at, end - at, StandardCharsets.UTF_8);
  }
}
