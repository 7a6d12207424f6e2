package haltere.testing;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Files that take the place of others by being new ones. An old one that is cut to nothing and
 * written anew keeps its writer waiting, on ext4, until the disk has what was in it.
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
