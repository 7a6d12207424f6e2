package haltere.ui.command;

import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.ViolationCounts;
import haltere.core.pipeline.RecordingJob;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Options of every command that reads a recording. */
final class ReadingOptions extends SourceOptions {
  /** What the id of a camera looks like, such as dvs128:0012; a drive of Windows has one letter. */
  private static final Pattern CAMERA = Pattern.compile("\\w{2,}:[^/\\\\]+");

  @Option(
      names = "--format",
      paramLabel = "NAME",
      description = "Read the recording as this format, whatever its content.")
  String format;

  @Option(
      names = "--index",
      description =
          "Store the time index for seeking beside the recording (FILE.haltere-index), "
              + "for later commands.")
  boolean index;

  @Spec CommandSpec own;

  /** Rejects these options, and others of the command, where no recording is read. */
  void checkNeeded(Path file, String... others) {
    Stream<String> all = Stream.concat(own.optionsMap().keySet().stream(), Stream.of(others));
    subcommand().checkNeeded(file != null, "a FILE", all.toArray(String[]::new));
  }

  /** Read options of the user; rejects an unknown format. */
  ReadOptions readOptions() {
    if (format != null && !Recordings.formats().containsKey(format)) {
      String known = String.join(", ", Recordings.formats().keySet());
      throw wrong("there is no format named " + format + "; there are " + known);
    }
    ReadOptions options = apply(ReadOptions.DEFAULT).withKeptIndex(index);
    return format == null ? options : options.withFormat(format);
  }

  RecordingReader open(Path file) throws IOException {
    return open(file, readOptions());
  }

  /** A reader that also gives frames, inertial samples and triggers. */
  RecordingReader openWithReadings(Path file) throws IOException {
    return open(file, readOptions().withSamples(true));
  }

  /** A reader of a file or of standard input. */
  RecordingReader open(Path file, ReadOptions options) throws IOException {
    if (index && isStandard(file)) {
      throw wrong("--index needs a file");
    }
    if (isStandard(file) && !subcommand().surroundings().in().isOpen()) {
      throw new CommandProblem("standard input is read only once: name a file instead of -");
    }
    if (CAMERA.matcher(file.toString()).matches() && !Files.exists(file)) {
      throw new CommandProblem(
          file + ": there is no such file; a camera is opened in the window, or with --device");
    }
    RecordingReader reader =
        isStandard(file)
            ? Recordings.openStream(file, subcommand().surroundings().in(), options)
            : Recordings.open(file, options);
    noteUnused(file, reader);
    return indexed(reader);
  }

  /** Names the options without effect, because the recording or its format states the property. */
  private void noteUnused(Path file, RecordingReader reader) {
    SensorGeometry stated = reader.geometry();
    if (sensor != null && !sensor.toString().equals(stated.toString())) {
      subcommand().warning(file + ": it states " + stated + " pixels; --sensor has no effect");
    }
    if (rows != null && rows != stated.origin()) {
      subcommand().warning(file + ": it states where rows count from; --rows has no effect");
    }
    if (topic != null && !reader.formatName().matches("rosbag.*|mcap.*|hdf5|npz|aedat4")) {
      subcommand().warning(file + ": it has no topics; --topic has no effect");
    }
  }

  /** Whether a path is standard input or output. */
  static boolean isStandard(Path path) {
    return path.toString().equals("-");
  }

  /** Builds the index on request, even if nothing seeks. */
  private RecordingReader indexed(RecordingReader reader) throws IOException {
    if (index) {
      try {
        reader.segments();
      } catch (IOException | RuntimeException e) {
        reader.close();
        throw e;
      }
    }
    return reader;
  }

  /** The violation that {@code --strict} rejects in a completely read recording. */
  Optional<RecordingProblem> objection(Path file, ViolationCounts violations) {
    return strict ? RecordingJob.damage(file, violations) : Optional.empty();
  }

  void requireComplete(RecordingReader reader) throws RecordingProblem {
    RecordingJob.requireComplete(reader, strict);
  }
}
