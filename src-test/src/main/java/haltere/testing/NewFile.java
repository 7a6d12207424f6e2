package haltere.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Replaces files by new ones. On ext4, truncating and rewriting an old file blocks its writer until
 * the disk has its old content.
 */
public final class NewFile {
  private NewFile() {}

  /**
   * Writes a file, in the place of another if there is one.
   *
   * @param path where
   * @param bytes all of them
   * @return the path
   * @throws IOException if that fails
   */
  public static Path write(Path path, byte[] bytes) throws IOException {
    Files.deleteIfExists(path);
    return Files.write(path, bytes);
  }
}
