package haltere.core.format.bag;

import haltere.core.format.packed.ByteSource;
import haltere.core.format.packed.DamagedPacketException;
import haltere.core.format.packed.Payload;
import java.io.IOException;

/**
 * The bytes of one message as a source of packed ones.
 *
 * <p>Thread rule: one thread.
 */
final class MessageBytes implements ByteSource {
  private Payload payload;
  private long size;
  private long used;

  /** Starts with a message: the next bytes of a payload. */
  void open(Payload bytes, long messageBytes) {
    payload = bytes;
    size = messageBytes;
    used = 0;
  }

  /** Bytes that lie behind those that were used. */
  long left() {
    return size - used;
  }

  @Override
  public int require(long offset, int count) throws IOException, DamagedPacketException {
    if (offset + count > size) {
      return -1;
    }
    payload.skip(offset - used);
    used = offset;
    return payload.gather(count) ? payload.from() : -1;
  }

  @Override
  public byte[] bytes() {
    return payload.data();
  }
}
