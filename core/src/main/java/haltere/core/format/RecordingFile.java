package haltere.core.format;

import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * The bytes of a recording: reads at any offset. It reads instead of mapping, so a file that is cut
 * while it is open ends early and does no worse.
 *
 * <p>Thread rule: one thread.
 */
public final class RecordingFile implements Closeable {
  private final Path path;
  private FileChannel channel;
  private boolean closed;
  private final long size;

  /**
   * Opens a file.
   *
   * @param path which one
   * @throws RecordingProblem if it is not there or may not be read
   * @throws IOException if it cannot be read for another reason
   */
  public RecordingFile(Path path) throws IOException {
    this.path = path;
    try {
      channel = FileChannel.open(path, StandardOpenOption.READ);
    } catch (NoSuchFileException e) {
      throw new RecordingProblem(path, "there is no such file");
    } catch (AccessDeniedException e) {
      throw new RecordingProblem(path, "no permission to read it; change its mode or owner");
    }
    try {
      size = channel.size();
    } catch (IOException e) {
      channel.close();
      throw new RecordingProblem(path, "cannot be read: " + e.getMessage());
    }
  }

  /** Makes a reader of a file, which is closed with it. */
  @FunctionalInterface
  public interface Opening {
    /**
     * Makes the reader.
     *
     * @param file the bytes
     * @return a reader at the start
     * @throws IOException if it is no recording that can be read
     */
    RecordingReader open(RecordingFile file) throws IOException;
  }

  /**
   * Opens a file for a reader; the file is closed again if there will be none.
   *
   * @param path which file
   * @param opening makes the reader
   * @return what that made
   * @throws RecordingProblem if the file is not there or may not be read
   * @throws IOException if the reader cannot be made
   */
  public static RecordingReader reading(Path path, Opening opening) throws IOException {
    RecordingFile file = new RecordingFile(path);
    try {
      return opening.open(file);
    } catch (IOException | RuntimeException e) {
      file.close();
      throw e;
    }
  }

  /**
   * Which file it is.
   *
   * @return the path that it was opened with
   */
  public Path path() {
    return path;
  }

  /**
   * Its size when it was opened.
   *
   * @return bytes
   */
  public long size() {
    return size;
  }

  /**
   * Fills a buffer as far as the file goes, and flips it; empty if that fails.
   *
   * @param buffer is cleared first
   * @param offset where in the file to start; behind its end nothing is read
   * @throws RecordingProblem if the file can no longer be read
   * @throws java.io.InterruptedIOException if the thread is interrupted; one may go on reading
   * @throws IOException if the file is closed
   */
  public void read(ByteBuffer buffer, long offset) throws IOException {
    buffer.clear();
    if (offset < size && size - offset < buffer.capacity()) {
      buffer.limit((int) (size - offset));
    } else if (offset >= size) {
      buffer.limit(0);
    }
    if (!channel.isOpen() && !closed) {
      // An interrupt closes a channel; whoever goes on reading afterwards may.
      channel = FileChannel.open(path, StandardOpenOption.READ);
    }
    try {
      while (buffer.hasRemaining() && channel.read(buffer, offset + buffer.position()) >= 0) {
        // The channel may give less than was asked for.
      }
    } catch (ClosedChannelException e) {
      buffer.limit(0);
      if (closed) {
        throw e;
      }
      throw (IOException)
          new InterruptedIOException("interrupted while reading " + path).initCause(e);
    } catch (IOException e) {
      buffer.limit(0);
      throw new RecordingProblem(path, offset, "cannot be read: " + e.getMessage());
    }
    buffer.flip();
  }

  /**
   * Reads some bytes.
   *
   * @param offset where in the file to start
   * @param bytes how many at the most
   * @return as many as there are
   * @throws IOException as {@link #read(ByteBuffer, long)}
   */
  public byte[] read(long offset, int bytes) throws IOException {
    ByteBuffer buffer = ByteBuffer.allocate((int) Math.max(0, Math.min(bytes, size - offset)));
    read(buffer, offset);
    return buffer.limit() == buffer.capacity()
        ? buffer.array()
        : java.util.Arrays.copyOf(buffer.array(), buffer.limit());
  }

  @Override
  public void close() throws IOException {
    closed = true;
    channel.close();
  }
}
