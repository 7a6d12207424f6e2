package haltere.core.format.aedat4;

import haltere.core.format.RecordingFile;
import java.io.IOException;
import java.nio.ByteBuffer;

/**
 * A stretch of a file in memory, moved to where bytes are asked for.
 *
 * <p>Thread rule: one thread.
 */
final class FileWindow {
  private static final int USUAL_BYTES = 256 * 1024;

  /** Asking for more than this at once is a fault of the caller. */
  static final int MAX_BYTES = 8 * 1024 * 1024;

  private final RecordingFile file;
  private byte[] bytes = new byte[0];
  private ByteBuffer buffer = ByteBuffer.wrap(bytes);
  private long start;
  private int length;

  FileWindow(RecordingFile file) {
    this.file = file;
  }

  /**
   * Makes some bytes of the file available in {@link #bytes()}.
   *
   * @return index of the first, or -1 if the file ends before the last
   */
  int require(long offset, int count) throws IOException {
    if (offset >= start && offset + count <= start + length) {
      return (int) (offset - start);
    }
    if (count > MAX_BYTES) {
      throw new IllegalArgumentException(count + " bytes at once");
    }
    if (offset < 0 || offset + count > file.size()) {
      return -1;
    }
    int wanted = (int) Math.min(Math.max(USUAL_BYTES, count), file.size());
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

  /** The bytes; the array is another one after each {@link #require}. */
  byte[] bytes() {
    return bytes;
  }

  /** Where the bytes that are there end, as an index. */
  int end() {
    return length;
  }
}
