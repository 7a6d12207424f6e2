package haltere.core.batch;

import haltere.core.format.RecordingProblem;
import haltere.core.format.Recordings;
import haltere.core.pipeline.internal.Checksums;
import java.io.IOException;
import java.nio.charset.CharacterCodingException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Finds the recordings of a batch: files, and recordings in folders, recursively. Hidden files and
 * folders, files of unknown formats and the batch's own results are left out.
 *
 * <p>Thread rule: one thread.
 *
 * @since 0.1
 */
public final class BatchInputs {
  private final Path results;
  private final Optional<Path> root;
  private final TreeMap<String, BatchItem> items = new TreeMap<>();
  private long leftOut;

  /**
   * No input yet.
   *
   * @param results the folder of the results
   * @param root names are relative to this folder; if empty, to each folder that is given, and a
   *     file that is given has its own name
   */
  public BatchInputs(Path results, Optional<Path> root) {
    this.results = results.toAbsolutePath().normalize();
    this.root = root.map(folder -> folder.toAbsolutePath().normalize());
  }

  /**
   * Adds a recording or all recordings in a folder. A folder in it that cannot be read is an item
   * too, so that it fails in the batch beside the recordings. Links in it to folders are not
   * followed.
   *
   * @param input a file or folder
   * @throws RecordingProblem if the input does not exist, or two recordings would have one name
   * @throws IOException if a folder cannot be read
   */
  public void add(Path input) throws IOException {
    if (!Files.exists(input)) {
      throw new RecordingProblem(input, "there is no such file or folder");
    }
    if (Files.isDirectory(input) && !Recordings.isRecording(input)) {
      walk(input);
    } else {
      add(input, input.toAbsolutePath().getParent());
    }
  }

  /**
   * Adds the inputs that a text file names, one in each line.
   *
   * @param list a file in UTF-8
   * @throws RecordingProblem as {@link #add}, with the line, or if the file is not UTF-8
   * @throws IOException if the list or a folder cannot be read
   */
  public void addList(Path list) throws IOException {
    int number = 0;
    for (String line : lines(list)) {
      number++;
      try {
        if (!line.isBlank()) {
          add(Path.of(line.strip()));
        }
      } catch (RecordingProblem | InvalidPathException problem) {
        throw new RecordingProblem(list, "line " + number + ": " + problem.getMessage());
      }
    }
  }

  private static List<String> lines(Path list) throws IOException {
    try {
      // programs of Windows begin UTF-8 with a byte order mark
      return Files.readString(list).replaceFirst("^\\ufeff", "").lines().toList();
    } catch (CharacterCodingException notText) {
      throw new RecordingProblem(list, "this is not UTF-8 text");
    }
  }

  private void walk(Path folder) throws IOException {
    Path start = folder.toRealPath();
    Path own = Files.exists(results) ? results.toRealPath() : results;
    Files.walkFileTree(
        start,
        new SimpleFileVisitor<>() {
          @Override
          public FileVisitResult preVisitDirectory(Path real, BasicFileAttributes attributes)
              throws IOException {
            boolean isInner = !real.equals(start);
            if (real.equals(own) || isInner && isHidden(real)) {
              return FileVisitResult.SKIP_SUBTREE;
            }
            if (isInner && Recordings.isRecording(real)) {
              add(named(real), folder);
              return FileVisitResult.SKIP_SUBTREE;
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFile(Path real, BasicFileAttributes attributes)
              throws IOException {
            Path file = named(real);
            if (isHidden(file) || !Recordings.isRecording(file)) {
              leftOut++;
            } else {
              add(file, folder);
            }
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult visitFileFailed(Path unreadable, IOException problem)
              throws IOException {
            if (unreadable.equals(start)) {
              throw problem;
            }
            put(named(unreadable), folder, 0);
            return FileVisitResult.CONTINUE;
          }

          @Override
          public FileVisitResult postVisitDirectory(Path listed, IOException problem)
              throws IOException {
            return problem == null ? FileVisitResult.CONTINUE : visitFileFailed(listed, problem);
          }

          private Path named(Path real) {
            return folder.resolve(start.relativize(real));
          }
        });
  }

  private static boolean isHidden(Path path) {
    return path.getFileName() != null && path.getFileName().toString().startsWith(".");
  }

  private void add(Path recording, Path folder) throws IOException {
    put(recording, folder, bytes(recording));
  }

  private void put(Path recording, Path folder, long bytes) throws IOException {
    Path from = root.orElse(folder.toAbsolutePath().normalize());
    Path absolute = recording.toAbsolutePath().normalize();
    if (!absolute.startsWith(from)) {
      throw new RecordingProblem(recording, "this is not in the folder " + from);
    }
    String name = from.relativize(absolute).toString().replace('\\', '/');
    BatchItem before = items.put(name, new BatchItem(recording, name, bytes));
    if (before != null && !Files.isSameFile(before.recording(), recording)) {
      throw new RecordingProblem(
          recording,
          "its result would have the same name as that of "
              + before.recording()
              + "; name a folder that both are in with --root, or rename one");
    }
  }

  /** The size of a recording; 0 if it cannot be read, so that it fails in the batch by itself. */
  private static long bytes(Path recording) {
    try {
      long bytes = 0;
      for (Path file : Checksums.files(recording)) {
        bytes += Files.size(file);
      }
      return bytes;
    } catch (IOException unreadable) {
      return 0;
    }
  }

  /**
   * The recordings.
   *
   * @return in the order of their names
   */
  public Collection<BatchItem> items() {
    return List.copyOf(items.values());
  }

  /**
   * Files in folders that are no recordings.
   *
   * @return a count
   */
  public long leftOut() {
    return leftOut;
  }
}
