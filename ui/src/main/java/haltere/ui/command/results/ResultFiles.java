package haltere.ui.command.results;

import haltere.core.chain.Outlet;
import haltere.core.pipeline.JobResults;
import haltere.core.pipeline.ResultFailure;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import haltere.core.stream.StreamHandler;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * The files of a command: tables and others, finished in the order in which they were added.
 *
 * <p>Thread rule: as {@link JobResults}.
 */
public final class ResultFiles implements JobResults {
  /** Puts a file in its place. */
  public interface Finish {
    void run() throws IOException;
  }

  /** Adds files. */
  public interface Filling {
    void fill(ResultFiles files) throws IOException;
  }

  private final boolean overwrite;
  private final List<Finish> steps = new ArrayList<>();
  private final List<Closeable> parts = new ArrayList<>();
  private final ResultFailure failure = new ResultFailure();
  private final List<StreamHandler> sinks = new ArrayList<>();
  private final Map<Path, TableSink<?>> tables = new LinkedHashMap<>();

  private final TableMetadata metadata;

  private ResultFiles(boolean overwrite, TableMetadata metadata) {
    this.overwrite = overwrite;
    this.metadata = metadata;
  }

  /** Opens files, each by the filling; what it opened is closed if it throws. */
  public static ResultFiles open(boolean overwrite, TableMetadata metadata, Filling filling)
      throws IOException {
    ResultFiles files = new ResultFiles(overwrite, metadata);
    try {
      filling.fill(files);
      return files;
    } catch (IOException | RuntimeException | Error problem) {
      files.close();
      throw problem;
    }
  }

  /** Starts a table of rows. */
  public <R extends Record> TableSink<R> table(Path file, Class<R> type) throws IOException {
    TableSink<R> table = Tables.create(file, type, overwrite, metadata);
    add(table, table::finish);
    tables.put(file, table);
    return table;
  }

  /** Writes what an outlet publishes; what cannot be written ends the job. */
  public <T> void subscribe(Outlet<T> outlet, Consumer<? super T> rows) {
    outlet.subscribe(rows, failure);
  }

  /** Adds a file that is no table. */
  public void add(Closeable part, Finish finish) {
    parts.add(part);
    steps.add(finish);
  }

  /** Adds a last step of finishing. */
  public void add(Finish finish) {
    steps.add(finish);
  }

  /** Adds a step that comes before any file is finished. */
  public void addFirst(Finish finish) {
    steps.add(0, finish);
  }

  /** Adds what takes the stream behind the chain. */
  public void add(StreamHandler sink) {
    sinks.add(sink);
  }

  @Override
  public List<StreamHandler> sinks() {
    List<StreamHandler> all = new ArrayList<>(sinks);
    all.add(failure);
    return all;
  }

  @Override
  public void finish() throws IOException {
    failure.rethrow();
    for (Finish step : steps) {
      step.run();
    }
  }

  @Override
  public List<ResultFile> files() {
    List<ResultFile> files = new ArrayList<>();
    tables.forEach((path, table) -> files.add(new ResultFile(path, table.rows())));
    return files;
  }

  @Override
  public void close() throws IOException {
    for (Closeable part : parts) {
      part.close();
    }
  }
}
