package haltere.spark;

import java.io.Closeable;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Comparator;
import java.util.UUID;
import java.util.stream.Stream;

/**
 * Temporary folder of one task on the local disk. A lock on a file beside it marks a running task;
 * the next task on the same disk removes the folders of killed processes.
 *
 * <p>Thread rule: one thread at a time.
 */
final class Scratch implements Closeable {
  private static final String PREFIX = "haltere-";
  private static final String LOCK = ".lock";

  /**
   * Prefix of the names of this process, which does not open its own lock files: closing a second
   * channel on a lock file would release the lock.
   */
  private static final String OWN = PREFIX + UUID.randomUUID() + "-";

  private final Path folder;
  private final Path lock;
  private final FileChannel locked;

  private Scratch(Path folder, Path lock, FileChannel locked) {
    this.folder = folder;
    this.lock = lock;
    this.locked = locked;
  }

  /**
   * Creates a folder, and removes the folders of processes that have ended.
   *
   * @param parent an existing folder on the local disk
   * @return an empty folder
   * @throws IOException if it cannot be created
   */
  static Scratch in(Path parent) throws IOException {
    removeAbandoned(parent);
    while (true) {
      Path folder = parent.resolve(OWN + UUID.randomUUID());
      Path lock = lock(folder);
      FileChannel channel =
          FileChannel.open(lock, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
      try {
        // Another process may have seen the file before it was locked, and removed it.
        if (channel.tryLock() != null && Files.exists(lock)) {
          return new Scratch(Files.createDirectory(folder), lock, channel);
        }
      } catch (IOException | RuntimeException thrown) {
        channel.close();
        throw thrown;
      }
      channel.close();
    }
  }

  private static Path lock(Path folder) {
    return folder.resolveSibling(folder.getFileName() + LOCK);
  }

  private static void removeAbandoned(Path parent) throws IOException {
    try (DirectoryStream<Path> locks = Files.newDirectoryStream(parent, PREFIX + "*" + LOCK)) {
      for (Path lock : locks) {
        String name = lock.getFileName().toString();
        if (!name.startsWith(OWN)) {
          removeIfAbandoned(
              lock.resolveSibling(name.substring(0, name.length() - LOCK.length())), lock);
        }
      }
    }
  }

  private static void removeIfAbandoned(Path folder, Path lock) throws IOException {
    try (FileChannel channel = FileChannel.open(lock, StandardOpenOption.WRITE)) {
      if (channel.tryLock() != null) {
        remove(folder);
        Files.deleteIfExists(lock);
      }
    } catch (NoSuchFileException removed) {
      // removed by its own task or by another process
    }
  }

  private static void remove(Path folder) throws IOException {
    if (Files.exists(folder)) {
      try (Stream<Path> all = Files.walk(folder)) {
        for (Path path : all.sorted(Comparator.reverseOrder()).toList()) {
          Files.deleteIfExists(path);
        }
      }
    }
  }

  /** The folder. */
  Path folder() {
    return folder;
  }

  /** Removes the folder and its contents. */
  @Override
  public void close() throws IOException {
    try (locked) {
      remove(folder);
      Files.deleteIfExists(lock);
    }
  }
}
