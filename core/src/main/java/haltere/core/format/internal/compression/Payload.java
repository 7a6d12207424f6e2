package haltere.core.format.internal.compression;

import java.io.Closeable;
import java.io.IOException;

/**
 * A stretch of a file that may be compressed, decompressed piece by piece, so that memory is
 * bounded for any size. The available unused bytes are in {@link #data} from {@link #from} to
 * {@link #to}.
 *
 * <p>Thread rule: one thread.
 */
public abstract class Payload implements Closeable {
  /** The bytes; another array after each call of {@link #more}. */
  protected byte[] data = new byte[0];

  /** Index of the first byte that is not yet used. */
  protected int from;

  /** Index behind the last byte that is there. */
  protected int to;

  /** For the ways of compression. */
  protected Payload() {}

  /**
   * Starts with another stretch.
   *
   * @param offset where it starts in the file
   * @param size bytes that it takes there
   * @throws IOException if the file cannot be read
   * @throws DamagedPacketException if it is not compressed as it should be
   */
  public abstract void open(long offset, long size) throws IOException, DamagedPacketException;

  /**
   * Puts more bytes behind those that are not yet used; all of them may move.
   *
   * @return false at the end
   * @throws IOException if the file cannot be read
   * @throws DamagedPacketException if the bytes contradict their compression
   */
  public abstract boolean more() throws IOException, DamagedPacketException;

  /**
   * The bytes.
   *
   * @return borrowed array, another one after each call of {@link #more}
   */
  public final byte[] data() {
    return data;
  }

  /**
   * Where the bytes start that are not yet used.
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
   * Passes over bytes that are there.
   *
   * @param bytes at most those between {@link #from()} and {@link #to()}
   */
  public final void use(int bytes) {
    from += bytes;
  }

  /**
   * Makes a number of bytes available, or all that remain.
   *
   * @param bytes how many, few enough for memory
   * @return true if there are as many
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
   * Passes over bytes whether they are there already or not.
   *
   * @param count how many
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

  /** Releases memory outside of the heap. */
  @Override
  public void close() {}
}
