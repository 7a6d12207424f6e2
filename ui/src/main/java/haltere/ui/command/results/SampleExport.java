package haltere.ui.command.results;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.RecordingReader;
import haltere.core.pipeline.ResultFiles;
import haltere.core.sink.CsvSink;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import haltere.core.sink.internal.Unchecked;
import haltere.core.stream.StreamHandler;
import haltere.ui.command.results.SampleTables.FrameRow;
import haltere.ui.command.results.SampleTables.SampleRow;
import haltere.ui.command.results.SampleTables.TriggerRow;
import haltere.ui.command.terminal.ProgressBar;
import haltere.ui.command.terminal.Quantities;
import haltere.ui.rendering.FramePictures;
import haltere.ui.rendering.Pictures;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.UUID;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * Exports samples of one kind: triggers or inertial samples as a table, frames as pictures in a new
 * folder with a table of their times. Outputs are atomic.
 *
 * @param stream which
 * @param out the table, or the folder of the pictures
 * @param overwrite whether a table that is there may be replaced
 * @param fromUs first time, microseconds
 * @param toUs first time that is not written any more, microseconds
 * @param metadata metadata of a table
 */
public record SampleExport(
    SampleStream stream,
    Path out,
    boolean overwrite,
    long fromUs,
    long toUs,
    TableMetadata metadata) {
  /**
   * Reads a recording from start to end, with samples, and returns the number written; the check
   * runs before outputs are moved to their paths.
   */
  public long run(RecordingReader reader, ProgressBar progress, ResultFiles.Finish check)
      throws IOException {
    return switch (stream) {
      case IMU ->
          writeTable(reader, progress, check, InertialSample.class, SampleRow.class, SampleRow::of);
      case TRIGGERS ->
          writeTable(reader, progress, check, Trigger.class, TriggerRow.class, TriggerRow::of);
      case FRAMES -> writeFrames(reader, progress, check);
    };
  }

  private <S extends SensorSample, R extends Record> long writeTable(
      RecordingReader reader,
      ProgressBar progress,
      ResultFiles.Finish check,
      Class<S> kind,
      Class<R> type,
      Function<S, R> row)
      throws IOException {
    try (TableSink<R> table = Tables.create(out, type, overwrite, metadata)) {
      pass(reader, progress, kind, sample -> table.accept(row.apply(sample)));
      check.run();
      table.finish();
      return table.rows();
    }
  }

  @FunctionalInterface
  private interface Target<T> {
    void take(T sample) throws IOException;
  }

  private long writeFrames(RecordingReader reader, ProgressBar progress, ResultFiles.Finish check)
      throws IOException {
    String name = "." + out.getFileName() + "." + UUID.randomUUID();
    Path folder = Files.createDirectory(out.resolveSibling(name));
    try {
      CsvSink<FrameRow> table = CsvSink.create(folder.resolve("frames.csv"), FrameRow.class, false);
      try (table) {
        pass(
            reader,
            progress,
            Frame.class,
            frame -> {
              String picture = Quantities.text("frame-%06d.png", table.rows());
              Pictures.write(folder.resolve(picture), FramePictures.draw(frame));
              table.accept(FrameRow.of(frame, picture));
            });
        check.run();
        table.finish();
      }
      Files.move(folder, out);
      return table.rows();
    } catch (IOException | RuntimeException e) {
      delete(folder);
      throw e;
    }
  }

  private static void delete(Path folder) throws IOException {
    try (Stream<Path> found = Files.walk(folder)) {
      for (Path file : found.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(file);
      }
    }
  }

  private <T extends SensorSample> void pass(
      RecordingReader reader, ProgressBar progress, Class<T> kind, Target<T> target)
      throws IOException {
    StreamHandler handler =
        StreamHandler.ofSamples(
            sample -> {
              if (kind.isInstance(sample) && sample.timeUs() >= fromUs && sample.timeUs() < toUs) {
                Unchecked.write(() -> target.take(kind.cast(sample)));
              }
            });
    try {
      while (reader.next(handler)) {
        if (Thread.currentThread().isInterrupted()) {
          throw new InterruptedIOException("interrupted while converting " + reader.path());
        }
        progress.progress(reader.positionBytes(), reader.sizeBytes());
      }
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }
}
