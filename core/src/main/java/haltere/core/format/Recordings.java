package haltere.core.format;

import haltere.core.extension.Extensions;
import java.io.IOException;
import java.nio.channels.ReadableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;

/**
 * Opens recordings; the format is detected from the content.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class Recordings {
  private Recordings() {}

  /**
   * All formats.
   *
   * @return by name, in alphabetical order
   */
  public static Map<String, RecordingFormat> formats() {
    Map<String, RecordingFormat> found = new TreeMap<>();
    for (RecordingFormat format : Extensions.find(RecordingFormat.class)) {
      found.putIfAbsent(format.name(), format);
    }
    return Collections.unmodifiableMap(found);
  }

  /**
   * Opens a recording.
   *
   * @param file any file, a folder with one recording, or the folder of a ROS 2 bag
   * @param options the user's options
   * @return a reader at its start
   * @throws RecordingProblem if it is not a readable file or has no known format; the message has
   *     the assessment of each format
   * @throws IOException if reading fails
   */
  public static RecordingReader open(Path file, ReadOptions options) throws IOException {
    Objects.requireNonNull(file, "file");
    Objects.requireNonNull(options, "options");
    List<Path> parts = parts(file);
    if (parts.size() == 1) {
      return openPart(parts.get(0), options);
    }
    List<RecordingReader> readers = new ArrayList<>();
    try {
      for (Path part : parts) {
        readers.add(openPart(part, options));
      }
      return new PartsReader(file, readers);
    } catch (IOException | RuntimeException | Error problem) {
      for (RecordingReader reader : readers) {
        reader.close();
      }
      throw problem;
    }
  }

  /**
   * Opens a recording with the default options.
   *
   * @param file any file, a folder with one recording, or the folder of a ROS 2 bag
   * @return a reader at its start
   * @throws IOException as {@link #open(Path, ReadOptions)}
   */
  public static RecordingReader open(Path file) throws IOException {
    return open(file, ReadOptions.DEFAULT);
  }

  /**
   * Opens a recording from a stream of bytes, such as standard input. Frames, inertial samples and
   * triggers of a stream are counted, but not read.
   *
   * @param name its name for messages
   * @param stream closed with the reader, or if opening fails
   * @param options the user's options
   * @return a reader at its start, which cannot seek
   * @throws RecordingProblem if it has no known format, or one that cannot be read in one pass
   * @throws IOException if reading fails
   */
  public static RecordingReader openStream(
      Path name, ReadableByteChannel stream, ReadOptions options) throws IOException {
    RecordingFile bytes = RecordingFile.stream(name, stream);
    try {
      RecordingFormat format =
          options.format().isPresent()
              ? named(name, options.format().get())
              : formatOf(FileHead.of(bytes));
      return format.openStream(bytes, options);
    } catch (IOException | RuntimeException e) {
      bytes.close();
      throw e;
    }
  }

  /**
   * Detects the format of a file.
   *
   * @param file a readable file, a folder with one recording, or the folder of a ROS 2 bag
   * @return the format with the highest confidence
   * @throws RecordingProblem if none is confident, or several are equally so
   * @throws IOException if reading fails
   */
  public static RecordingFormat detect(Path file) throws IOException {
    return formatOf(parts(file).get(0));
  }

  /**
   * Whether a path looks like a recording: a file that a format detects by its content or, unless
   * other kinds of files {@linkplain RecordingFormat#sharesExtensions() share it}, by its
   * extension; or the folder of a ROS 2 bag.
   *
   * @param path any path
   * @return for an unreadable file, whether its extension is that of a format
   */
  public static boolean isRecording(Path path) {
    try {
      if (Files.isDirectory(path)) {
        return RecordingFolder.isBag(path);
      }
      if (!Files.isRegularFile(path)) {
        return false;
      }
      FileHead head = FileHead.read(path);
      return formats().values().stream()
          .anyMatch(
              format ->
                  !format.sharesExtensions() && format.extensions().contains(head.extension())
                      || format.probe(head).support() != Support.NONE);
    } catch (IOException ignored) {
      String extension = FileHead.extension(path);
      return formats().values().stream()
          .anyMatch(format -> format.extensions().contains(extension));
    }
  }

  private static RecordingReader openPart(Path file, ReadOptions options) throws IOException {
    checkReadable(file);
    return options.format().isPresent()
        ? named(file, options.format().get()).open(file, options)
        : formatOf(file).open(file, options);
  }

  private static RecordingFormat formatOf(Path file) throws IOException {
    checkReadable(file);
    return formatOf(FileHead.read(file));
  }

  private static RecordingFormat formatOf(FileHead head) throws RecordingProblem {
    Path file = head.path();
    if (head.size() == 0) {
      throw new RecordingProblem(file, "the file is empty; record or copy it again");
    }
    Map<RecordingFormat, ProbeResult> answers = new LinkedHashMap<>();
    Support best = Support.NONE;
    for (RecordingFormat format : formats().values()) {
      ProbeResult answer = format.probe(head);
      answers.put(format, answer);
      if (answer.support().compareTo(best) > 0) {
        best = answer.support();
      }
    }
    List<RecordingFormat> bestFormats = new ArrayList<>();
    for (Map.Entry<RecordingFormat, ProbeResult> answer : answers.entrySet()) {
      if (answer.getValue().support() == best && best != Support.NONE) {
        bestFormats.add(answer.getKey());
      }
    }
    if (bestFormats.size() == 1) {
      return bestFormats.get(0);
    }
    Optional<String> decompressing =
        bestFormats.isEmpty() ? CompressedWhole.program(head) : Optional.empty();
    if (decompressing.isPresent()) {
      throw new RecordingProblem(
          file, "it is compressed as a whole; decompress it first: " + decompressing.get());
    }
    if (bestFormats.isEmpty()
        && (head.startsWith("\u00ff\u00fe") || head.startsWith("\u00fe\u00ff"))) {
      throw new RecordingProblem(file, "it is text in UTF-16; save it as UTF-8");
    }
    String extension = FileHead.extension(file);
    boolean claimed =
        answers.keySet().stream().anyMatch(format -> format.extensions().contains(extension));
    String reasons =
        answers.entrySet().stream()
            .filter(
                answer -> bestFormats.isEmpty() ? claimed : bestFormats.contains(answer.getKey()))
            .map(answer -> answer.getKey().name() + ": " + answer.getValue().reason())
            .collect(Collectors.joining("; "));
    String formats = reasons.isEmpty() ? String.join(", ", formats().keySet()) : reasons;
    throw new RecordingProblem(
        file,
        (bestFormats.isEmpty() ? "no known format (" : "several formats fit (")
            + formats
            + ") (--format NAME reads it as one of them)");
  }

  /**
   * The format for writing a file, by its extension.
   *
   * @param file path of the recording
   * @return a writable format whose first extension it is
   * @throws RecordingProblem if there is none; the message lists the valid extensions
   */
  public static RecordingFormat forWriting(Path file) throws RecordingProblem {
    String extension = FileHead.extension(file);
    for (RecordingFormat format : formats().values()) {
      if (format.writable() && format.extensions().iterator().next().equals(extension)) {
        return format;
      }
    }
    throw new RecordingProblem(
        file,
        (extension.isEmpty()
                ? "its name has no ending that gives a format"
                : "no format is written to files ending in ." + extension)
            + "; name it with one of "
            + formats().values().stream()
                .filter(RecordingFormat::writable)
                .map(format -> "." + format.extensions().iterator().next())
                .distinct()
                .collect(Collectors.joining(", ")));
  }

  private static RecordingFormat named(Path file, String name) throws RecordingProblem {
    RecordingFormat format = formats().get(name);
    if (format == null) {
      throw new RecordingProblem(
          file,
          "there is no format named "
              + name
              + "; there are "
              + String.join(", ", formats().keySet()));
    }
    return format;
  }

  /** The files of a recording. */
  private static List<Path> parts(Path named) throws RecordingProblem {
    return Files.isDirectory(named) ? RecordingFolder.parts(named) : List.of(named);
  }

  private static void checkReadable(Path file) throws RecordingProblem {
    if (!Files.exists(file)) {
      throw new RecordingProblem(file, "there is no such file");
    }
    if (!Files.isDirectory(file)) {
      RecordingFile.checkRegular(file);
    }
    if (!Files.isReadable(file)) {
      throw RecordingFile.noPermission(file);
    }
  }
}
