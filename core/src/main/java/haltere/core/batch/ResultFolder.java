package haltere.core.batch;

import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.json.internal.Json;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.internal.Checksums;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;

/**
 * The folder of one recording's results. While a process works in it, it holds a lock on {@code
 * done.json.part}, which names the files that are being written; {@code done.json} replaces it when
 * all of them are complete. So the next process replaces the files of a killed one.
 *
 * <p>Thread rule: one thread at a time.
 */
final class ResultFolder implements Closeable {
  private static final String DONE = "done.json";
  private static final String OUTPUTS = "outputs";
  private static final int MAX_JOURNAL_BYTES = 1 << 24;
  private static final int MAX_TRIES = 100;

  private final Path folder;
  private final Path part;
  private final FileChannel journal;

  /** Files that the journal names: a killed process's first, then this one's. */
  private List<Path> begun;

  private boolean completed;

  private ResultFolder(Path folder, FileChannel journal) throws IOException {
    this.folder = folder;
    part = part(folder);
    this.journal = journal;
    begun = journalled().map(this::outputs).orElse(List.of());
  }

  private static Path part(Path folder) {
    return folder.resolve(DONE + AtomicFile.PART);
  }

  /** Record of a complete earlier run; empty if there is none. */
  static Optional<Map<?, ?>> done(Path folder) {
    try {
      return Json.read(folder.resolve(DONE)) instanceof Map<?, ?> done
          ? Optional.of(done)
          : Optional.empty();
    } catch (IOException ignored) {
      return Optional.empty();
    }
  }

  /** Whether all files of an earlier run exist unchanged. */
  static boolean isWhole(Path folder, Map<?, ?> done) {
    if (!(done.get(OUTPUTS) instanceof List<?> outputs)) {
      return false;
    }
    try {
      for (Object output : outputs) {
        if (!(output instanceof Map<?, ?> file)
            || !(file.get("file") instanceof String name)
            || !Checksums.of(folder.resolve(name)).equals(file.get("sha256"))) {
          return false;
        }
      }
      return true;
    } catch (IOException ignored) {
      return false;
    }
  }

  /**
   * Claims a folder and creates it if necessary.
   *
   * @return empty if another batch works in it
   * @throws IOException if it cannot be created
   */
  static Optional<ResultFolder> take(Path folder) throws IOException {
    if (Files.isRegularFile(folder)) {
      throw new RecordingProblem(
          folder, "this is a file where its results would be; choose another folder for them");
    }
    Path part = part(folder);
    for (int i = 1; ; i++) {
      try {
        Files.createDirectories(folder);
        FileChannel.open(part, StandardOpenOption.CREATE, StandardOpenOption.WRITE).close();
        Object file = fileKey(part);
        FileChannel journal =
            FileChannel.open(part, StandardOpenOption.READ, StandardOpenOption.WRITE);
        if (!isLocked(journal)) {
          journal.close();
          return Optional.empty();
        }
        if (Objects.equals(file, fileKey(part))) {
          return Optional.of(new ResultFolder(folder, journal));
        }
        journal.close();
      } catch (NoSuchFileException gone) {
        // the other batch has just completed or left the folder; a lock is that of its file
        if (i == MAX_TRIES) {
          throw gone;
        }
      }
    }
  }

  private static Object fileKey(Path file) throws IOException {
    return Files.readAttributes(file, BasicFileAttributes.class).fileKey();
  }

  private static boolean isLocked(FileChannel journal) throws IOException {
    try {
      return journal.tryLock() != null;
    } catch (OverlappingFileLockException ofThisProcess) {
      return false;
    } catch (IOException | RuntimeException problem) {
      journal.close();
      throw problem;
    }
  }

  /** Releases the folder without touching its results. */
  void release() throws IOException {
    Files.deleteIfExists(part);
    journal.close();
  }

  /** Removes the files of an earlier run, complete or not; {@code done.json} first. */
  void clear() throws IOException {
    List<Path> earlier = done(folder).map(this::outputs).orElse(List.of());
    Files.deleteIfExists(folder.resolve(DONE));
    remove(earlier);
    remove(begun);
  }

  private static void remove(List<Path> files) throws IOException {
    for (Path file : files) {
      Files.deleteIfExists(file);
      Files.deleteIfExists(file.resolveSibling(file.getFileName() + AtomicFile.PART));
    }
  }

  private Optional<Map<?, ?>> journalled() throws IOException {
    long size = Math.min(journal.size(), MAX_JOURNAL_BYTES);
    ByteBuffer bytes = ByteBuffer.allocate((int) size);
    while (bytes.hasRemaining() && journal.read(bytes, bytes.position()) >= 0) {
      // until complete
    }
    try {
      String text = new String(bytes.array(), 0, bytes.position(), StandardCharsets.UTF_8);
      return Json.parse(text, part.toString()) instanceof Map<?, ?> begun
          ? Optional.of(begun)
          : Optional.empty();
    } catch (IOException ignored) {
      // no file is written before its journal is complete
      return Optional.empty();
    }
  }

  private List<Path> outputs(Map<?, ?> object) {
    List<Path> files = new ArrayList<>();
    if (object.get(OUTPUTS) instanceof List<?> outputs) {
      for (Object output : outputs) {
        if (output instanceof Map<?, ?> file && file.get("file") instanceof String name) {
          Path path = folder.resolve(name).normalize();
          if (path.startsWith(folder)) {
            files.add(path);
          }
        }
      }
    }
    return files;
  }

  Path path(String name) {
    return folder.resolve(name);
  }

  /** Writes the names of the planned files to the journal. */
  void begin(List<Path> files) throws IOException {
    begun = files;
    List<Object> outputs = new ArrayList<>();
    files.forEach(file -> outputs.add(Map.of("file", folder.relativize(file).toString())));
    try {
      write(Map.of(OUTPUTS, outputs));
    } catch (IOException e) {
      throw RecordingProblem.writing(part, e);
    }
  }

  /**
   * Writes the journal. It survives a killed process without being forced to the disk; after a
   * power failure the checksums show which files are complete.
   */
  private void write(Map<String, Object> object) throws IOException {
    ByteBuffer bytes =
        ByteBuffer.wrap((Json.write(object) + "\n").getBytes(StandardCharsets.UTF_8));
    journal.truncate(0);
    while (bytes.hasRemaining()) {
      journal.write(bytes, bytes.position());
    }
  }

  /** Forces files to the disk and renames them to their final names. */
  void place(List<JobResults.ResultFile> files) throws IOException {
    for (JobResults.ResultFile file : files) {
      AtomicFile.place(file.path());
    }
  }

  /**
   * Marks the results as complete.
   *
   * @param done with the files under {@code outputs}
   */
  void complete(Map<String, Object> done) throws IOException {
    try {
      write(done);
      journal.force(true);
      Files.move(
          part,
          folder.resolve(DONE),
          StandardCopyOption.ATOMIC_MOVE,
          StandardCopyOption.REPLACE_EXISTING);
      completed = true;
      journal.close();
      forceNames();
    } catch (IOException e) {
      throw RecordingProblem.writing(folder.resolve(DONE), e);
    }
  }

  /** Names of files are on the disk once their folder is, where the system can do that. */
  private void forceNames() throws IOException {
    try (FileChannel names = FileChannel.open(folder, StandardOpenOption.READ)) {
      names.force(true);
    } catch (IOException notWithFolders) {
      if (!Files.isDirectory(folder)) {
        throw notWithFolders;
      }
    }
  }

  /**
   * Releases the folder and removes incomplete files, also in an interrupted thread, where the
   * journal cannot be read.
   */
  @Override
  public void close() throws IOException {
    if (completed) {
      return;
    }
    try {
      remove(begun);
      Files.deleteIfExists(part);
      Files.delete(folder);
    } catch (DirectoryNotEmptyException | NoSuchFileException ignored) {
      // the folder contains other files
    } finally {
      journal.close();
    }
  }
}
