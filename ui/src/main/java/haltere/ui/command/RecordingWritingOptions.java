package haltere.ui.command;

import haltere.core.camera.Camera;
import haltere.core.event.Origin;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.SampleCounts;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Format;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.pipeline.SessionRecorder;
import haltere.ui.command.terminal.Quantities;
import java.io.IOException;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import picocli.CommandLine.Option;

/** Options of every command that writes recordings. */
final class RecordingWritingOptions extends WritingOptions {
  @Option(
      names = "--origin",
      paramLabel = "top|bottom",
      description =
          "Origin of the rows in plain exports (CSV, NumPy, HDF5); default: as in the source.")
  Origin origin;

  /**
   * Refuses, before any work, a recording that cannot be written: for its name's ending, its
   * origin, or as {@link #check} does.
   */
  void checkRecording(Path output) {
    RecordingFormat format;
    try {
      format = Recordings.forWriting(output);
    } catch (RecordingProblem unknownFormat) {
      throw wrong(unknownFormat.getMessage());
    }
    checkOrigin(format);
    check(output);
  }

  /** Rejects an origin of rows for formats that define it. */
  void checkOrigin(RecordingFormat format) {
    if (origin != null && !format.hasEitherOrigin()) {
      throw wrong(
          "--origin is for plain exports (CSV, NumPy, HDF5); rows of "
              + format.name()
              + " files count from where the format says");
    }
  }

  /** Starts a recording in the format that its name ends in. */
  RecordingWriter create(Path output, SensorGeometry geometry) throws IOException {
    return create(output, Recordings.forWriting(output), geometry, Set.of());
  }

  /** Starts a recording with all contents of another one that the format can hold. */
  RecordingWriter create(Path output, RecordingFormat format, RecordingReader reader)
      throws IOException {
    Set<SampleKind> samples = EnumSet.noneOf(SampleKind.class);
    samples.addAll(format.writableSamples());
    if (!samples.isEmpty()) {
      SampleCounts there = reader.countSamples();
      samples.removeIf(kind -> there.of(kind) == 0);
    }
    return create(output, format, reader.geometry(), samples);
  }

  /**
   * Starts a recording of a camera, with lines for its header if it holds such. AEDAT-4 can be read
   * from its first moment on, also if the program is killed; a file of another format appears when
   * it is finished.
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
            Set.copyOf(format.writableSamples()));
    if (format instanceof Aedat4Format) {
      return Aedat4Writer.createInPlace(output, options, Aedat4Compression.LZ4);
    }
    return create(output, format, options);
  }

  /**
   * A recording of a camera in parts, with the chain as JSON in its header; without any file yet.
   * Rejects a disk with less free space than the limit.
   */
  SessionRecorder session(
      Path output, Camera camera, Supplier<Optional<String>> chain, SessionRecorder.Limits limits)
      throws IOException {
    return SessionRecorder.ofCamera(
        output,
        camera,
        chain,
        (part, metadata) -> createLive(part, camera.geometry(), metadata),
        limits);
  }

  /** The line for a recording that ended before it was to; empty for others. */
  static Optional<String> endedEarly(SessionRecorder session) {
    return session
        .endedEarly()
        .map(
            line ->
                Quantities.text(
                    "%s (%s received, %,d written)",
                    line, Quantities.events(session.received()), session.written()));
  }

  private RecordingWriter create(
      Path output, RecordingFormat format, SensorGeometry geometry, Set<SampleKind> samples)
      throws IOException {
    WriteOptions toFile =
        new WriteOptions(geometry, overwrite, Optional.ofNullable(origin), Map.of(), samples);
    return create(
        output,
        format,
        ReadingOptions.isStandard(output)
            ? toFile.withStream(subcommand().standardOutput())
            : toFile);
  }

  private static RecordingWriter create(Path output, RecordingFormat format, WriteOptions options)
      throws IOException {
    String readOnly = output + ": " + format.name() + " is only read; choose another ending";
    return format.create(output, options).orElseThrow(() -> new CommandProblem(readOnly));
  }
}
