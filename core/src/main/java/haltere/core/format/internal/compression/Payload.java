package haltere.core.format.internal.compression;

import java.io.Closeable;
import java.io.IOException;

/**
 * A range of a file that may be compressed, decompressed piece by piece, so that memory is bounded
 * for any size. The available unused bytes are in {@link #data} from {@link #from} to {@link #to}.
 *
 * <p>Thread rule: one thread.
 */
public abstract class Payload implements Closeable {
  /** The bytes; another array after each call of {@link #more}. */
  protected byte[] data = new byte[0];

  /** Index of the first unused byte. */
  protected int from;

  /** Index after the last available byte. */
  protected int to;

  /** For subclasses. */
  protected Payload() {}

  /**
   * Opens another range.
   *
   * @param offset byte offset in the file
   * @param size its bytes there
   * @throws IOException if the file cannot be read
   * @throws DamagedPacketException if its compression is invalid
   */
  public abstract void open(long offset, long size) throws IOException, DamagedPacketException;

  /**
   * Appends more bytes to the unused ones; all of them may move.
   *
   * @return false at the end
   * @throws IOException if the file cannot be read
   * @throws DamagedPacketException if the bytes contradict their compression
   */
  public abstract boolean more() throws IOException, DamagedPacketException;

  /**
   * The bytes.
   *
   * @return borrowed array, replaced by each call of {@link #more}
   */
  public final byte[] data() {
    return data;
  }

  /**
   * Start of the unused bytes.
   *
   * @return index in {@link #data()}
   */
  public final int from() {
    return from;
  }

  /**
   * End of the available bytes.
   *
   * @return index in {@link #data()}
   */
  public final int to() {
    return to;
  }

  /**
   * Skips available bytes.
   *
   * @param bytes at most those between {@link #from()} and {@link #to()}
   */
  public final void use(int bytes) {
    from += bytes;
  }

  /**
   * Makes a number of bytes available, or all that remain.
   *
   * @param bytes their number, few enough for memory
   * @return true if the number is available
   * @throws IOException as {@link #more}
   * @throws DamagedPacketException as {@link #more}
   */
  public final boolean gather(int bytes) throws IOException, DamagedPacketException {
    while (to - from < bytes && more()) {
      // a piece may be smaller than required
    }
    return to - from >= bytes;
  }

  /**
   * Skips bytes, available or not.
   *
   * @param count their number
   * @throws IOException as {@link #more}
   * @throws DamagedPacketException as {@link #more}, and if there are fewer
   */
  public void skip(long count) throws IOException, DamagedPacketException {
    long left = count;
    while (left > 0) {
      if (from == to && !more()) {
        throw new DamagedPacketException("a packet that ends too early");
      }
      int step = (int) Math.min(left, to - from);
      from += step;
      left -= step;
    }
  }

  /** Releases memory outside the heap. */
  @Override
  public void close() {}
}
