package haltere.core.format;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * A folder as a recording: a ROS 2 bag, which is split into files as it grows, or any folder with
 * exactly one recording.
 */
final class RecordingFolder {
  private static final int NAMED_FILES = 3;

  /** Metadata of a ROS 2 bag, with its files in order. */
  private static final String BAG_LIST = "metadata.yaml";

  private static final String BAG_PARTS = "relative_file_paths:";
  private static final int MAX_LIST_BYTES = 1 << 20;

  private RecordingFolder() {}

  /**
   * The parts of the recording in a folder.
   *
   * @return at least one
   * @throws RecordingProblem if there is none, or several that are not a bag; the message names
   *     some
   */
  static List<Path> parts(Path folder) throws RecordingProblem {
    List<Path> parts = partsOfBag(folder);
    return parts.isEmpty() ? List.of(onlyRecording(folder)) : parts;
  }

  /** Whether a folder is a ROS 2 bag. */
  static boolean isBag(Path folder) throws RecordingProblem {
    return !partsOfBag(folder).isEmpty();
  }

  private static List<Path> partsOfBag(Path folder) throws RecordingProblem {
    Path list = folder.resolve(BAG_LIST);
    List<Path> parts = new ArrayList<>();
    try {
      if (!Files.isRegularFile(list) || Files.size(list) > MAX_LIST_BYTES) {
        return parts;
      }
      boolean listed = false;
      for (String line :
          new String(Files.readAllBytes(list), StandardCharsets.UTF_8).split("\\R")) {
        String words = line.strip();
        if (listed && !words.startsWith("- ")) {
          break;
        }
        if (listed) {
          parts.add(part(folder, words.substring(2).strip().replaceAll("^[\"']|[\"']$", "")));
        }
        listed |= words.equals(BAG_PARTS);
      }
      return parts;
    } catch (IOException unreadable) {
      if (unreadable instanceof RecordingProblem problem) {
        throw problem;
      }
      throw new RecordingProblem(list, "it cannot be read; name a recording beside it");
    }
  }

  private static Path part(Path folder, String name) throws RecordingProblem {
    try {
      Path part = folder.resolve(name).normalize();
      if (part.startsWith(folder.normalize()) && Files.isRegularFile(part)) {
        return part;
      }
    } catch (java.nio.file.InvalidPathException ignored) {
      // reported below
    }
    throw new RecordingProblem(
        folder, "its " + BAG_LIST + " names " + name + ", which is not in this folder");
  }

  private static Path onlyRecording(Path folder) throws RecordingProblem {
    List<Path> recordings = recordings(folder);
    if (recordings.size() == 1) {
      return recordings.get(0);
    }
    String names =
        recordings.stream()
            .limit(NAMED_FILES)
            .map(file -> file.getFileName().toString())
            .collect(Collectors.joining(", "));
    throw new RecordingProblem(
        folder,
        recordings.isEmpty()
            ? "this is a folder without any recording; name a file"
            : "this is a folder with " + recordings.size() + " recordings; name one: " + names);
  }

  private static List<Path> recordings(Path folder) throws RecordingProblem {
    Set<String> endings =
        Recordings.formats().values().stream()
            .flatMap(format -> format.extensions().stream())
            .collect(Collectors.toSet());
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> endings.contains(FileHead.extension(file)))
          .filter(file -> Files.isRegularFile(file) && Recordings.isRecording(file))
          .sorted()
          .toList();
    } catch (UncheckedIOException e) {
      throw unreadable(folder, e.getCause());
    } catch (IOException e) {
      throw unreadable(folder, e);
    }
  }

  private static RecordingProblem unreadable(Path folder, IOException cause) {
    return RecordingProblem.of(folder, "this folder cannot be read; name a recording in it", cause);
  }
}
