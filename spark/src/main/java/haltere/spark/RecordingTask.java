package haltere.spark;

import haltere.core.batch.BatchFailure;
import haltere.core.chain.ChainFile;
import haltere.core.format.AtomicFile;
import haltere.core.pipeline.OutletTables;
import haltere.core.pipeline.RecordingJob;
import haltere.core.sink.TableMetadata;
import java.io.DataInputStream;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;
import java.util.NoSuchElementException;
import org.apache.hadoop.fs.FileSystem;
import org.apache.spark.SparkEnv;
import org.apache.spark.TaskContext;
import org.apache.spark.api.java.function.FlatMapFunction;
import org.apache.spark.broadcast.Broadcast;
import org.apache.spark.sql.Row;
import org.apache.spark.sql.RowFactory;
import org.apache.spark.util.SerializableConfiguration;
import org.apache.spark.util.TaskCompletionListener;

/**
 * Task of one recording on an executor: copies it to the local disk, runs the chain and reads the
 * rows back. The copy is deleted at the end of the task, even if the task fails. Each row starts
 * with the index of its table; a failed recording has one row with {@link #FAILED}, kind and cause.
 */
final class RecordingTask implements FlatMapFunction<SparkRecording, Row> {
  static final int FAILED = -1;

  private static final String SCRATCH = "spark.haltere.scratch";

  private final String chain;
  private final List<ResultTable> tables;
  private final Broadcast<SerializableConfiguration> hadoop;

  RecordingTask(
      String chain, List<ResultTable> tables, Broadcast<SerializableConfiguration> hadoop) {
    this.chain = chain;
    this.tables = List.copyOf(tables);
    this.hadoop = hadoop;
  }

  @Override
  public Iterator<Row> call(SparkRecording recording) throws IOException {
    Path parent = Path.of(SparkEnv.get().conf().get(SCRATCH, System.getProperty("java.io.tmpdir")));
    Scratch made = Scratch.in(parent);
    TaskContext.get().addTaskCompletionListener((TaskCompletionListener) context -> remove(made));
    Path scratch = made.folder();
    try {
      run(stage(recording, scratch), scratch);
      return new RowIterator(recording.name(), scratch);
    } catch (InterruptedIOException stop) {
      throw stop;
    } catch (Exception | OutOfMemoryError | StackOverflowError thrown) {
      if (TaskContext.get().isInterrupted()) {
        throw thrown;
      }
      BatchFailure.FailureKind kind = BatchFailure.FailureKind.of(thrown);
      String cause = thrown.getMessage() == null ? thrown.toString() : thrown.getMessage();
      return List.of(RowFactory.create(FAILED, recording.name(), kind.toString(), cause))
          .iterator();
    }
  }

  private Path stage(SparkRecording recording, Path scratch) throws IOException {
    org.apache.hadoop.fs.Path source = new org.apache.hadoop.fs.Path(recording.uri());
    Path local = scratch.resolve(source.getName());
    FileSystem files = source.getFileSystem(hadoop.value().value());
    files.copyToLocalFile(false, source, new org.apache.hadoop.fs.Path(local.toUri()), true);
    return local;
  }

  private void run(Path recording, Path scratch) throws IOException {
    RecordingJob.of(
            recording,
            sensor -> ChainFile.parse(chain, "the chain", sensor),
            (reader, filters) ->
                OutletTables.open(
                    filters,
                    (stage, outlet) -> file(scratch, stage.name() + "." + outlet.name()),
                    file -> AtomicFile.create(file, false),
                    TableMetadata.NONE))
        .run();
  }

  private static Path file(Path scratch, String table) {
    return scratch.resolve(table + "." + RowsFormat.ENDING);
  }

  private static void remove(Scratch scratch) {
    try {
      scratch.close();
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    }
  }

  /** Iterator over the rows of all tables; one file is open at a time. */
  private final class RowIterator implements Iterator<Row> {
    private final String recording;
    private final Path scratch;
    private int table = -1;
    private DataInputStream in;
    private Row next;

    RowIterator(String recording, Path scratch) {
      this.recording = recording;
      this.scratch = scratch;
      advance();
    }

    private void advance() {
      try {
        next = in == null ? null : row();
        while (next == null && ++table < tables.size()) {
          if (in != null) {
            in.close();
          }
          in = RowsFormat.open(file(scratch, tables.get(table).name()));
          next = row();
        }
        if (next == null && in != null) {
          in.close();
        }
      } catch (IOException thrown) {
        throw new UncheckedIOException(thrown);
      }
    }

    private Row row() throws IOException {
      int columns = tables.get(table).columns();
      Object[] values = new Object[columns + 2];
      values[0] = table;
      values[1] = recording;
      int[] at = {2};
      return RowsFormat.read(in, columns, value -> values[at[0]++] = value)
          ? RowFactory.create(values)
          : null;
    }

    @Override
    public boolean hasNext() {
      return next != null;
    }

    @Override
    public Row next() {
      if (next == null) {
        throw new NoSuchElementException();
      }
      Row row = next;
      advance();
      return row;
    }
  }
}
