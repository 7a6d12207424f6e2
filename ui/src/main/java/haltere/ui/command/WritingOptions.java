package haltere.ui.command;

import haltere.core.event.Origin;
import haltere.core.event.ReadingKind;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadingCounts;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** Options of every command that writes files, and the checks that come before the work. */
final class WritingOptions {
  @Spec(Spec.Target.MIXEE)
  CommandSpec command;

  @Option(names = "--overwrite", description = "Replace output files that exist.")
  boolean overwrite;

  @Option(
      names = "--origin",
      paramLabel = "top|bottom",
      description = "Where plain exports (CSV) count rows from; if not given, as their source.")
  Origin origin;

  /**
   * Refuses an output that cannot be written, before any work is done.
   *
   * @param output where a file will be
   * @throws CommandProblem if it exists, is a folder or has no folder to be in
   */
  void check(Path output) {
    Path folder = output.toAbsolutePath().getParent();
    if (Files.isDirectory(output)) {
      throw new CommandProblem(output + ": this is a folder; name a file in it");
    }
    if (folder == null || !Files.isDirectory(folder)) {
      throw new CommandProblem(
          output + ": there is no folder " + folder + "; make it, or choose another place");
    }
    if (Files.exists(output, LinkOption.NOFOLLOW_LINKS) && !overwrite) {
      throw new CommandProblem(output + ": exists already; give --overwrite to replace it");
    }
    if (!Files.isWritable(folder)) {
      throw new CommandProblem(
          output + ": no permission to write in its folder; choose another place");
    }
  }

  /**
   * Refuses a recording that cannot be written, before any work is done.
   *
   * @param output where it will be
   * @throws ParameterException if nothing writes files whose names end so
   * @throws CommandProblem as {@link #check}
   */
  void checkRecording(Path output) {
    try {
      Recordings.forWriting(output);
    } catch (RecordingProblem unknownEnding) {
      throw new ParameterException(command.commandLine(), unknownEnding.getMessage());
    }
    check(output);
  }

  /**
   * Starts a recording in the format that its name ends in.
   *
   * @param output where it will be
   * @param geometry the sensor of its events
   * @return an open writer
   * @throws IOException if it cannot be written
   */
  RecordingWriter create(Path output, SensorGeometry geometry) throws IOException {
    return create(output, geometry, Set.of());
  }

  /**
   * Starts a recording in the format that its name ends in, for all that another one holds, as far
   * as the format can.
   *
   * @param output where it will be
   * @param reader the other recording
   * @return an open writer
   * @throws IOException if it cannot be written, or the other one not be read
   */
  RecordingWriter create(Path output, RecordingReader reader) throws IOException {
    Set<ReadingKind> readings = EnumSet.noneOf(ReadingKind.class);
    readings.addAll(Recordings.forWriting(output).writableReadings());
    if (!readings.isEmpty()) {
      ReadingCounts there = reader.countReadings();
      readings.removeIf(kind -> there.of(kind) == 0);
    }
    return create(output, reader.geometry(), readings);
  }

  private RecordingWriter create(Path output, SensorGeometry geometry, Set<ReadingKind> readings)
      throws IOException {
    WriteOptions options =
        new WriteOptions(geometry, overwrite, Optional.ofNullable(origin), Map.of(), readings);
    RecordingFormat format = Recordings.forWriting(output);
    return format
        .create(output, options)
        .orElseThrow(
            () ->
                new CommandProblem(
                    output + ": " + format.name() + " is only read; choose another ending"));
  }

  /**
   * Refuses an output that would replace what is being read.
   *
   * @param input a file that is read
   * @param output where a file will be
   * @throws CommandProblem if they are the same
   * @throws IOException if the file system cannot tell
   */
  static void checkDifferent(Path input, Path output) throws IOException {
    boolean same =
        Files.exists(input) && Files.exists(output)
            ? Files.isSameFile(input, output)
            : input.toAbsolutePath().normalize().equals(output.toAbsolutePath().normalize());
    if (same) {
      throw new CommandProblem(
          output + ": input and output are the same file; choose another output");
    }
  }
}
