package haltere.testing;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * Replaces the contents of files, ten thousands of times. On ext4, emptying an old file and
 * rewriting it blocks its writer until the disk has the old content, and a new file takes five
 * times as long as new bytes in an old one.
 */
public final class ReplacedFile {
  private ReplacedFile() {}

  /**
   * Writes a file, over another if there is one.
   *
   * @param path where; no reader has it open
   * @param bytes all of them
   * @return the path
   * @throws IOException if that fails
   */
  public static Path write(Path path, byte[] bytes) throws IOException {
    try (FileChannel file =
        FileChannel.open(path, StandardOpenOption.CREATE, StandardOpenOption.WRITE)) {
      ByteBuffer remaining = ByteBuffer.wrap(bytes);
      while (remaining.hasRemaining()) {
        file.write(remaining);
      }
      file.truncate(bytes.length);
    }
    return path;
  }
}
