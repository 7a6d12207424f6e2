package haltere.ui.command;

import haltere.core.camera.Camera;
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
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Format;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.pipeline.CameraHeader;
import haltere.core.pipeline.SessionRecorder;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Path;
import java.time.Clock;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** Options of every command that writes recordings. */
final class RecordingWritingOptions extends WritingOptions {
  @Option(
      names = "--origin",
      paramLabel = "top|bottom",
      description =
          "Where plain exports (CSV, NumPy, HDF5) count rows from; if not given, as their source.")
  Origin origin;

  /**
   * Refuses a recording that cannot be written, before any work is done.
   *
   * @param output where it will be
   * @throws ParameterException if nothing writes files whose names end so, or the origin is not to
   *     be chosen
   * @throws CommandProblem as {@link #check}
   */
  void checkRecording(Path output) {
    RecordingFormat format;
    try {
      format = Recordings.forWriting(output);
    } catch (RecordingProblem unknownEnding) {
      throw new ParameterException(command.commandLine(), unknownEnding.getMessage());
    }
    checkOrigin(format);
    check(output);
  }

  /**
   * Refuses where rows are to count from for a format that says it itself.
   *
   * @param format of the output
   */
  void checkOrigin(RecordingFormat format) {
    if (origin != null && !format.hasEitherOrigin()) {
      throw new ParameterException(
          command.commandLine(),
          "--origin is about plain exports (CSV, NumPy, HDF5); rows of "
              + format.name()
              + " files count from where the format says");
    }
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
    return create(output, Recordings.forWriting(output), geometry, Set.of());
  }

  /**
   * Starts a recording for all that another one holds, as far as the format can.
   *
   * @param output where it will be
   * @param format of the new recording
   * @param reader the other recording
   * @return an open writer
   * @throws IOException if it cannot be written, or the other one not be read
   */
  RecordingWriter create(Path output, RecordingFormat format, RecordingReader reader)
      throws IOException {
    Set<ReadingKind> readings = EnumSet.noneOf(ReadingKind.class);
    readings.addAll(format.writableReadings());
    if (!readings.isEmpty()) {
      ReadingCounts there = reader.countReadings();
      readings.removeIf(kind -> there.of(kind) == 0);
    }
    return create(output, format, reader.geometry(), readings);
  }

  /**
   * Starts a recording of a camera. AEDAT-4 can be read from its first moment on, also if the
   * program is killed; a file of another format appears when it is finished.
   *
   * @param output where it will be
   * @param geometry the sensor of its events
   * @param metadata lines for its header, if it holds such
   * @return an open writer
   * @throws IOException if it cannot be written
   */
  RecordingWriter createLive(Path output, SensorGeometry geometry, Map<String, String> metadata)
      throws IOException {
    RecordingFormat format = Recordings.forWriting(output);
    WriteOptions options =
        new WriteOptions(
            geometry,
            overwrite,
            Optional.ofNullable(origin),
            metadata,
            Set.copyOf(format.writableReadings()));
    if (format instanceof Aedat4Format) {
      return Aedat4Writer.createInPlace(output, options, Aedat4Compression.LZ4);
    }
    return format
        .create(output, options)
        .orElseThrow(() -> new CommandProblem(output + ": " + format.name() + " is only read"));
  }

  /**
   * A recording of a camera, in parts.
   *
   * @param output the first part
   * @param camera an open camera
   * @param chain the chain for the header, as JSON, if there is one
   * @param limits sizes
   * @return without any file yet
   * @throws IOException if the disk has less free space than is to stay
   */
  SessionRecorder session(
      Path output, Camera camera, Supplier<Optional<String>> chain, SessionRecorder.Limits limits)
      throws IOException {
    SessionRecorder session =
        new SessionRecorder(
            output,
            camera.geometry(),
            (part, metadata) -> createLive(part, camera.geometry(), metadata),
            limits,
            new CameraHeader(camera, chain, System::nanoTime, Clock.systemUTC()),
            SessionRecorder.freeBytes(output));
    session.checkSpace();
    return session;
  }

  /** The line for a recording that ended before it was to; empty for others. */
  static Optional<String> endedEarly(SessionRecorder session) {
    return session
        .endedEarly()
        .map(
            line ->
                line
                    + " ("
                    + Quantities.events(session.received())
                    + " came, "
                    + Quantities.count(session.written())
                    + " were written)");
  }

  private RecordingWriter create(
      Path output, RecordingFormat format, SensorGeometry geometry, Set<ReadingKind> readings)
      throws IOException {
    WriteOptions toFile =
        new WriteOptions(geometry, overwrite, Optional.ofNullable(origin), Map.of(), readings);
    WriteOptions options =
        ReadingOptions.isStandard(output)
            ? toFile.withStream(((Subcommand) command.userObject()).standardOutput())
            : toFile;
    return format
        .create(output, options)
        .orElseThrow(
            () ->
                new CommandProblem(
                    output + ": " + format.name() + " is only read; choose another ending"));
  }
}
