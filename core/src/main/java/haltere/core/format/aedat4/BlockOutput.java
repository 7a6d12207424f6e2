package haltere.core.format.aedat4;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;

/**
 * The end of a file that is written, in whole blocks where nobody needs the bytes sooner: the
 * system takes those that begin and end with its pages a third faster than packets as they come.
 *
 * <p>Thread rule: one thread.
 */
final class BlockOutput {
  private static final int BLOCK = 256 * 1024;

  private final FileChannel channel;
  private final ByteBuffer block = ByteBuffer.allocateDirect(BLOCK);
  private long blockStart;

  /** Goes on at the end of a file. */
  BlockOutput(FileChannel channel) throws IOException {
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
    while (block.hasRemaining()) {
      channel.write(block, blockStart + block.position());
    }
    blockStart += block.limit();
    toNextBlock();
  }
}
