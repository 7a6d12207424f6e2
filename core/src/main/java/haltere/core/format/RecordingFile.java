package haltere.core.format;

import java.io.Closeable;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.ClosedChannelException;
import java.nio.channels.FileChannel;
import java.nio.channels.ReadableByteChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Objects;

/**
 * The bytes of a recording: reads at any offset. It reads instead of mapping, so that a file
 * truncated while it is open only ends early.
 *
 * <p>The bytes of a {@link #stream} are read once, from front to back: offsets may go back by
 * {@value #BUFFERED_BYTES} bytes, and its size is unknown until its end.
 *
 * <p>Thread rule: one thread.
 *
 * @since 0.1
 */
public final class RecordingFile implements Closeable {
  private static final int BUFFERED_BYTES = 1 << 20;

  private final Path path;
  private FileChannel channel;
  private boolean closed;
  private long size;

  /** The stream, and its buffered bytes, which can be read again; null for a file. */
  private ReadableByteChannel stream;

  private byte[] buffered = {};
  private long bufferedFrom;
  private int bufferedCount;

  /**
   * Opens a file.
   *
   * @param path the file
   * @throws RecordingProblem if it does not exist or may not be read
   * @throws java.io.InterruptedIOException if the thread is interrupted
   * @throws IOException if it cannot be read for another reason
   */
  public RecordingFile(Path path) throws IOException {
    this.path = path;
    checkRegular(path);
    try {
      channel = FileChannel.open(path, StandardOpenOption.READ);
    } catch (NoSuchFileException e) {
      throw new RecordingProblem(path, "there is no such file");
    } catch (AccessDeniedException e) {
      throw noPermission(path);
    }
    try {
      size = channel.size();
    } catch (ClosedChannelException e) {
      throw interrupted(e);
    } catch (IOException e) {
      channel.close();
      throw new RecordingProblem(path, "cannot be read: " + e.getMessage());
    }
  }

  private RecordingFile(Path name, ReadableByteChannel stream) {
    path = name;
    this.stream = Objects.requireNonNull(stream, "stream");
    size = Long.MAX_VALUE;
  }

  static RecordingProblem noPermission(Path path) {
    return RecordingProblem.of(
        path,
        "no permission to read it; change its mode or owner",
        new AccessDeniedException(path.toString()));
  }

  /**
   * The bytes of a stream, such as standard input.
   *
   * @param name its name for messages
   * @param stream closed with this
   * @return an open file; nothing has been read
   */
  public static RecordingFile stream(Path name, ReadableByteChannel stream) {
    return new RecordingFile(name, stream);
  }

  /**
   * Rejects folders, and pipes and devices, which have no known end.
   *
   * @param path any path
   * @throws RecordingProblem if it exists and is no file
   */
  public static void checkRegular(Path path) throws RecordingProblem {
    if (Files.isDirectory(path)) {
      throw new RecordingProblem(path, "this is a folder; name a file");
    }
    if (Files.exists(path) && !Files.isRegularFile(path)) {
      throw new RecordingProblem(
          path, "this is a pipe or a device, not a file; give - for standard input or output");
    }
  }

  /**
   * Rejects a stream for formats that read a recording more than once.
   *
   * @param advice advice for users, such as an option
   * @throws RecordingProblem if this is a stream
   */
  public void requireFile(String advice) throws RecordingProblem {
    if (stream != null) {
      throw new RecordingProblem(path, "a stream is read only once: " + advice);
    }
  }

  /**
   * Whether this is a stream.
   *
   * @return false for a file
   */
  public boolean isStream() {
    return stream != null;
  }

  /** Creates a reader of a file; closing the reader closes the file. */
  @FunctionalInterface
  public interface ReaderFactory {
    /**
     * Creates the reader.
     *
     * @param file the bytes
     * @return a reader at the start
     * @throws IOException if it is not a readable recording
     */
    RecordingReader open(RecordingFile file) throws IOException;
  }

  /**
   * Opens a file for a reader; the file is closed if the reader cannot be created.
   *
   * @param path the file
   * @param opening creates the reader
   * @return the reader
   * @throws RecordingProblem if the file does not exist or may not be read
   * @throws IOException if the reader cannot be created
   */
  public static RecordingReader reading(Path path, ReaderFactory opening) throws IOException {
    RecordingFile file = new RecordingFile(path);
    try {
      return opening.open(file);
    } catch (IOException | RuntimeException e) {
      file.close();
      throw e;
    }
  }

  /**
   * The file.
   *
   * @return the path as given
   */
  public Path path() {
    return path;
  }

  /**
   * Its size when it was opened.
   *
   * @return bytes; {@link Long#MAX_VALUE} for a stream whose end has not been read
   */
  public long size() {
    return size;
  }

  /**
   * Fills a buffer, up to the end of the file, and flips it; empty after a failure.
   *
   * @param buffer is cleared first
   * @param offset byte offset in the file; nothing is read after its end
   * @throws RecordingProblem if the file can no longer be read, or was closed
   * @throws java.io.InterruptedIOException if the thread is interrupted; reading may continue
   */
  public void read(ByteBuffer buffer, long offset) throws IOException {
    buffer.clear();
    if (offset < size && size - offset < buffer.capacity()) {
      buffer.limit((int) (size - offset));
    } else if (offset >= size) {
      buffer.limit(0);
    }
    if (stream != null) {
      readStream(buffer, offset);
      return;
    }
    if (!channel.isOpen() && !closed) {
      // an interrupt closes a channel; reading may continue afterwards
      channel = FileChannel.open(path, StandardOpenOption.READ);
    }
    try {
      while (buffer.hasRemaining() && channel.read(buffer, offset + buffer.position()) >= 0) {
        // the channel may return less than requested
      }
    } catch (ClosedChannelException e) {
      buffer.limit(0);
      if (closed) {
        throw new RecordingProblem(path, "it was closed before");
      }
      throw interrupted(e);
    } catch (IOException e) {
      buffer.limit(0);
      throw RecordingProblem.reading(path, offset, e);
    }
    buffer.flip();
  }

  private InterruptedIOException interrupted(ClosedChannelException cause) {
    InterruptedIOException problem =
        new InterruptedIOException("interrupted while reading " + path);
    problem.initCause(cause);
    return problem;
  }

  private void readStream(ByteBuffer buffer, long offset) throws IOException {
    int wanted = buffer.remaining();
    if (offset < bufferedFrom) {
      buffer.limit(0);
      requireFile("save it to a file for this");
    }
    try {
      while (size == Long.MAX_VALUE && bufferedFrom + bufferedCount < offset + wanted) {
        makeRoom(offset);
        int count =
            stream.read(ByteBuffer.wrap(buffered, bufferedCount, buffered.length - bufferedCount));
        if (count < 0) {
          size = bufferedFrom + bufferedCount;
        } else {
          bufferedCount += count;
        }
      }
    } catch (IOException e) {
      buffer.limit(0);
      throw RecordingProblem.reading(path, offset, e);
    }
    long available = Math.min(wanted, bufferedFrom + bufferedCount - offset);
    if (available > 0) {
      buffer.put(buffered, (int) (offset - bufferedFrom), (int) available);
    }
    buffer.flip();
  }

  /** Discards bytes far before an offset if the buffer is full. */
  private void makeRoom(long offset) {
    if (bufferedCount < buffered.length) {
      return;
    }
    int discarded =
        (int) Math.max(0, Math.min(bufferedCount, offset - BUFFERED_BYTES - bufferedFrom));
    int length = 2 * Math.max(BUFFERED_BYTES, bufferedCount - discarded);
    byte[] target = length > buffered.length ? new byte[length] : buffered;
    System.arraycopy(buffered, discarded, target, 0, bufferedCount - discarded);
    buffered = target;
    bufferedFrom += discarded;
    bufferedCount -= discarded;
  }

  /**
   * Reads some bytes.
   *
   * @param offset byte offset in the file
   * @param bytes maximum number
   * @return fewer at the end of the file
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
    if (stream != null) {
      stream.close();
    } else {
      channel.close();
    }
  }
}
