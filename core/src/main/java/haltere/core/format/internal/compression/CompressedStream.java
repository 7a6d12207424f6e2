package haltere.core.format.internal.compression;

import java.io.IOException;
import java.io.InputStream;

/**
 * Compressed bytes as a stream, for libraries that need one. It ends with its source.
 *
 * <p>Thread rule: one thread.
 */
public final class CompressedStream extends InputStream {
  private static final int MAX_STEP_BYTES = 64 * 1024;

  private final ByteSource source;
  private final long end;
  private long next;
  private IOException failure;

  /**
   * A stream over a range.
   *
   * @param source holds the bytes; it is not closed with the stream
   * @param offset start of the range
   * @param size its bytes
   */
  public CompressedStream(ByteSource source, long offset, long size) {
    this.source = source;
    next = offset;
    end = offset + size;
  }

  /**
   * The position of the next byte.
   *
   * @return offset in the source
   */
  public long position() {
    return next;
  }

  /**
   * Rethrows an exception of the source, which is not damage of the bytes.
   *
   * @throws IOException if the source could not be read
   */
  public void rethrow() throws IOException {
    if (failure != null) {
      throw failure;
    }
  }

  @Override
  public int read() throws IOException {
    int at = require(1);
    return at < 0 ? -1 : source.bytes()[at] & 0xff;
  }

  @Override
  public int read(byte[] target, int offset, int length) throws IOException {
    int count = (int) Math.min(Math.min(length, MAX_STEP_BYTES), end - next);
    int at = require(count);
    if (at < 0) {
      return -1;
    }
    System.arraycopy(source.bytes(), at, target, offset, count);
    return count;
  }

  private int require(int count) throws IOException {
    try {
      int at = count < 1 || next >= end ? -1 : source.require(next, count);
      next += at < 0 ? 0 : count;
      return at;
    } catch (DamagedPacketException e) {
      return -1;
    } catch (IOException e) {
      failure = e;
      throw e;
    }
  }
}
