package haltere.core.format.internal.compression;

import haltere.core.format.RecordingFile;
import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * A range of a file in memory, moved to the requested bytes.
 *
 * <p>Thread rule: one thread.
 */
public final class FileWindow implements ByteSource {
  private static final int DEFAULT_BYTES = 64 * 1024;

  /** Maximum number of bytes per request; more is an error of the caller. */
  public static final int MAX_BYTES = 8 * 1024 * 1024;

  private final RecordingFile file;
  private final int defaultBytes;
  private byte[] bytes = new byte[0];
  private ByteBuffer buffer = ByteBuffer.wrap(bytes);
  private long start;
  private int length;

  /**
   * An empty window.
   *
   * @param file the file; it is not closed with the window
   */
  public FileWindow(RecordingFile file) {
    this(file, DEFAULT_BYTES);
  }

  /**
   * An empty window.
   *
   * @param file the file; it is not closed with the window
   * @param defaultBytes least number of bytes per read, at least 1
   */
  public FileWindow(RecordingFile file, int defaultBytes) {
    this.file = file;
    this.defaultBytes = defaultBytes;
  }

  /**
   * Makes a range of the file available in {@link #bytes()}.
   *
   * @param offset byte offset in the file
   * @param count number of bytes, at most {@link #MAX_BYTES}
   * @return index of the first, or -1 if the file ends before the last
   * @throws IOException if the file cannot be read
   */
  @Override
  public int require(long offset, int count) throws IOException {
    if (offset >= start && offset + count <= start + length) {
      return (int) (offset - start);
    }
    if (count > MAX_BYTES) {
      throw new IllegalArgumentException(count + " bytes at once");
    }
    if (offset < 0 || offset + count > file.size()) {
      return -1;
    }
    int wanted = (int) Math.min(Math.max(defaultBytes, count), file.size());
    if (bytes.length < wanted) {
      bytes = new byte[Math.max(wanted, bytes.length)];
      buffer = ByteBuffer.wrap(bytes);
    }
    length = 0;
    file.read(buffer, offset);
    start = offset;
    length = buffer.limit();
    return length >= count ? 0 : -1;
  }

  /**
   * The bytes.
   *
   * @return borrowed array, replaced by each {@link #require}
   */
  @Override
  public byte[] bytes() {
    return bytes;
  }

  /**
   * End of the available bytes.
   *
   * @return index in {@link #bytes()}
   */
  public int end() {
    return length;
  }
}
