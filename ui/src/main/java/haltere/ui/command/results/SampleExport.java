package haltere.ui.command.results;

import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.RecordingReader;
import haltere.core.sink.CsvSink;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import haltere.core.stream.StreamHandler;
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
import java.util.List;
import java.util.stream.Stream;

/**
 * Writes one of the streams beside the events: samples or triggers as a table, frames as pictures
 * in a new folder with a table of their times. Each appears whole or not at all.
 */
public final class SampleExport {
  private final SampleStream stream;
  private final Path out;
  private final boolean overwrite;
  private final long fromUs;
  private final long toUs;
  private final TableMetadata metadata;

  /**
   * An export that has not begun, from the first time to before the last, microseconds, into a
   * table or a folder of pictures.
   */
  public SampleExport(
      SampleStream stream,
      Path out,
      boolean overwrite,
      long fromUs,
      long toUs,
      TableMetadata metadata) {
    this.stream = stream;
    this.out = out;
    this.overwrite = overwrite;
    this.fromUs = fromUs;
    this.toUs = toUs;
    this.metadata = metadata;
  }

  /**
   * Reads a recording from its start to its end, with samples, and returns how many were written;
   * the check is asked before anything is put in its place.
   */
  public long run(RecordingReader reader, ProgressBar progress, Check check) throws IOException {
    return switch (stream) {
      case IMU -> {
        try (TableSink<SampleTables.SampleRow> table =
            Tables.create(out, SampleTables.SampleRow.class, overwrite, metadata)) {
          pass(
              reader,
              progress,
              InertialSample.class,
              sample -> table.accept(SampleTables.SampleRow.of(sample)));
          check.run();
          table.finish();
          yield table.rows();
        }
      }
      case TRIGGERS -> {
        try (TableSink<SampleTables.TriggerRow> table =
            Tables.create(out, SampleTables.TriggerRow.class, overwrite, metadata)) {
          pass(
              reader,
              progress,
              Trigger.class,
              trigger -> table.accept(SampleTables.TriggerRow.of(trigger)));
          check.run();
          table.finish();
          yield table.rows();
        }
      }
      case FRAMES -> writeFrames(reader, progress, check);
    };
  }

  /** Something that may object. */
  @FunctionalInterface
  public interface Check {
    void run() throws IOException;
  }

  @FunctionalInterface
  private interface Target<T> {
    void take(T sample) throws IOException;
  }

  private long writeFrames(RecordingReader reader, ProgressBar progress, Check check)
      throws IOException {
    Path whole = out.toAbsolutePath();
    Path folder = Files.createTempDirectory(whole.getParent(), "." + whole.getFileName() + "-");
    try {
      long rows;
      try (CsvSink<SampleTables.FrameRow> table =
          CsvSink.create(folder.resolve("frames.csv"), SampleTables.FrameRow.class, false)) {
        pass(
            reader,
            progress,
            Frame.class,
            frame -> {
              String name = Quantities.text("frame-%06d.png", table.rows());
              Pictures.write(folder.resolve(name), FramePictures.draw(frame));
              table.accept(SampleTables.FrameRow.of(frame, name));
            });
        check.run();
        table.finish();
        rows = table.rows();
      }
      Files.move(folder, whole);
      return rows;
    } catch (IOException | RuntimeException e) {
      delete(folder);
      throw e;
    }
  }

  private static void delete(Path folder) throws IOException {
    List<Path> files;
    try (Stream<Path> found = Files.walk(folder)) {
      files = found.sorted(Comparator.reverseOrder()).toList();
    }
    for (Path file : files) {
      Files.deleteIfExists(file);
    }
  }

  private <T extends SensorSample> void pass(
      RecordingReader reader, ProgressBar progress, Class<T> kind, Target<T> target)
      throws IOException {
    StreamHandler handler =
        StreamHandler.ofSamples(
            sample -> {
              if (kind.isInstance(sample) && sample.timeUs() >= fromUs && sample.timeUs() < toUs) {
                try {
                  target.take(kind.cast(sample));
                } catch (IOException e) {
                  throw new UncheckedIOException(e);
                }
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
