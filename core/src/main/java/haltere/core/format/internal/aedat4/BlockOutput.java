package haltere.core.format.internal.aedat4;

import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;

/**
 * Writes in whole blocks unless the bytes are needed sooner: page-aligned blocks are written a
 * third faster than single packets.
 *
 * <p>Thread rule: one thread.
 */
final class BlockOutput {
  private static final int BLOCK = 256 * 1024;

  private final Path path;
  private final FileChannel channel;
  private final ByteBuffer block = ByteBuffer.allocateDirect(BLOCK);
  private long blockStart;

  /** Continues at the end of a file. */
  BlockOutput(Path path, FileChannel channel) throws IOException {
    this.path = path;
    this.channel = channel;
    blockStart = channel.size();
    toNextBlock();
  }

  private void toNextBlock() {
    block.clear().limit(BLOCK - (int) (blockStart % BLOCK));
  }

  /** File offset of the next byte. */
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

  /** Writes the remaining bytes. */
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
