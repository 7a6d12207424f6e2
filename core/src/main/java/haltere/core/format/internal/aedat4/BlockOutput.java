package haltere.core.format.internal.aedat4;

import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;

/**
 * The end of a file that is written, in whole blocks where nobody needs the bytes sooner: the
 * system takes those that begin and end with its pages a third faster than packets as they come.
 *
 * <p>Thread rule: one thread.
 */
final class BlockOutput {
  private static final int BLOCK = 256 * 1024;

  private final Path path;
  private final FileChannel channel;
  private final ByteBuffer block = ByteBuffer.allocateDirect(BLOCK);
  private long blockStart;

  /** Goes on at the end of a file. */
  BlockOutput(Path path, FileChannel channel) throws IOException {
    this.path = path;
    this.channel = channel;
    blockStart = channel.size();
    toNextBlock();
  }

  private void toNextBlock() {
    block.clear().limit(BLOCK - (int) (blockStart % BLOCK));
  }

  /** Where in the file the next byte goes. */
  long position() {
    return blockStart + block.position();
  }

  void write(byte[] bytes, int from, int to) throws IOException {
    int at = from;
    while (at < to) {
      int count = Math.min(to - at, block.remaining());
      block.put(bytes, at, count);
      at += count;
      if (!block.hasRemaining()) {
        flush();
      }
    }
  }

  /** Hands over to the system what is still here. */
  void flush() throws IOException {
    block.flip();
    writeAt(block, blockStart);
    blockStart += block.limit();
    toNextBlock();
  }

  /** Writes bytes at an offset of the file. */
  void writeAt(ByteBuffer bytes, long offset) throws IOException {
    try {
      while (bytes.hasRemaining()) {
        channel.write(bytes, offset + bytes.position());
      }
    } catch (IOException e) {
      throw RecordingProblem.writing(path, e);
    }
  }
}
