package haltere.core.format.aedat2;

import haltere.core.format.RecordingProblem;
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
import java.util.Optional;

/**
 * The bytes of an AEDAT file: reads at any offset. It reads instead of mapping, so a file that is
 * cut while it is open ends early and does no worse.
 *
 * <p>Thread rule: one thread.
 */
final class RecordFile implements Closeable {
  private static final int FIRST_LOOK = 256 * 1024;
  private static final int MAX_HEADER = 16 * 1024 * 1024;

  private final Path path;
  private FileChannel channel;
  private boolean closed;
  private final long size;

  RecordFile(Path path) throws IOException {
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

  Path path() {
    return path;
  }

  long size() {
    return size;
  }

  /** Fills the buffer from an offset as far as the file goes, and flips it; empty if that fails. */
  void read(ByteBuffer buffer, long offset) throws IOException {
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

  AedatHeader header() throws IOException {
    for (int look = FIRST_LOOK; look <= MAX_HEADER; look *= 4) {
      ByteBuffer bytes = ByteBuffer.allocate((int) Math.min(look, Math.max(1, size)));
      read(bytes, 0);
      Optional<AedatHeader> header =
          AedatHeader.parse(bytes.array(), bytes.limit(), bytes.limit() >= size);
      if (header.isPresent()) {
        return header.get();
      }
    }
    throw new RecordingProblem(
        path, MAX_HEADER, "the text header goes on and on; this is no AEDAT recording");
  }

  @Override
  public void close() throws IOException {
    closed = true;
    channel.close();
  }
}
