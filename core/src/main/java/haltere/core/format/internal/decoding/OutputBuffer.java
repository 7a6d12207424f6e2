package haltere.core.format.internal.decoding;

import haltere.core.format.AtomicFile;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * Buffers the words of a writer.
 *
 * <p>Thread rule: one thread.
 */
public final class OutputBuffer implements Closeable {
  private static final int BYTES = 256 * 1024;

  private final AtomicFile file;
  private final ByteBuffer bytes;

  /**
   * An empty buffer.
   *
   * @param file the output; closed with the buffer
   * @param order of the bytes of numbers
   */
  public OutputBuffer(AtomicFile file, ByteOrder order) {
    this.file = file;
    bytes = ByteBuffer.allocateDirect(BYTES).order(order);
  }

  /**
   * The buffered bytes.
   *
   * @return always the same buffer
   */
  public ByteBuffer bytes() {
    return bytes;
  }

  /**
   * Rejects data for a complete file.
   *
   * @throws IllegalStateException after {@link #finish}
   */
  public void requireUnfinished() {
    file.requireUncommitted();
  }

  /**
   * Reserves space for a word.
   *
   * @param count its bytes, few
   * @throws IOException if the file cannot be written
   */
  public void room(int count) throws IOException {
    if (bytes.remaining() < count) {
      flush();
    }
  }

  /**
   * Writes a header before the first word.
   *
   * @param header its bytes
   * @throws IOException if the file cannot be written
   */
  public void header(ByteBuffer header) throws IOException {
    flush();
    file.write(header);
  }

  /**
   * Writes the buffered bytes.
   *
   * @throws IOException if the file cannot be written
   */
  public void flush() throws IOException {
    bytes.flip();
    file.write(bytes);
    bytes.clear();
  }

  /**
   * Writes the buffer and commits the file.
   *
   * @throws IOException if that fails
   */
  public void finish() throws IOException {
    flush();
    file.commit();
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
