package haltere.core.format.internal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Whether two paths lead to one file, so that writing one would destroy the other. */
public final class SameFile {
  private SameFile() {}

  /**
   * Whether two paths lead to one file; those that do not exist are compared by name.
   *
   * @param read a path
   * @param written another one
   * @return whether they are the same
   * @throws IOException if a file cannot be examined
   */
  public static boolean is(Path read, Path written) throws IOException {
    return Files.exists(read) && Files.exists(written)
        ? Files.isSameFile(read, written)
        : read.toAbsolutePath().normalize().equals(written.toAbsolutePath().normalize());
  }
}
