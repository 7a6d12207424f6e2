package haltere.core.pipeline;

import haltere.core.chain.Outlet;
import haltere.core.chain.ResultOrder;
import haltere.core.format.AtomicFile;
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
import java.util.function.LongSupplier;

/**
 * Tables and other files, finished in the order in which they were added. All appear at the end, or
 * none.
 *
 * <p>Thread rule: as {@link JobResults}.
 *
 * @since 0.1
 */
public final class ResultFiles implements JobResults {
  /** Creates a file. */
  public interface FileFactory {
    /**
     * Creates a file.
     *
     * @param file its path
     * @return an empty file that appears there when it is committed
     * @throws IOException if it cannot be written
     */
    AtomicFile create(Path file) throws IOException;
  }

  /** Puts a file in its place. */
  public interface Finish {
    /**
     * Puts it there.
     *
     * @throws IOException if that fails
     */
    void run() throws IOException;
  }

  /** Adds files. */
  public interface Filling {
    /**
     * Adds them.
     *
     * @param files receives them
     * @throws IOException if one cannot be written
     */
    void fill(ResultFiles files) throws IOException;
  }

  private final FileFactory factory;
  private final TableMetadata metadata;
  private final Map<Path, LongSupplier> rowCounts = new LinkedHashMap<>();
  private final List<ResultOrder.Sorter<?>> sorters = new ArrayList<>();
  private final List<Finish> steps = new ArrayList<>();
  private final List<Closeable> open = new ArrayList<>();
  private final List<StreamHandler> sinks = new ArrayList<>();
  private final ResultFailure failure = new ResultFailure();

  private ResultFiles(FileFactory factory, TableMetadata metadata) {
    this.factory = factory;
    this.metadata = metadata;
    sinks.add(failure);
  }

  /**
   * Opens files.
   *
   * @param factory begins each table's file
   * @param metadata kept in tables whose format, which follows from the name, can hold it
   * @param filling adds each; what it has added is closed if it throws
   * @return open files
   * @throws IOException if one cannot be written
   */
  public static ResultFiles open(FileFactory factory, TableMetadata metadata, Filling filling)
      throws IOException {
    ResultFiles files = new ResultFiles(factory, metadata);
    try {
      filling.fill(files);
      return files;
    } catch (IOException | RuntimeException | Error problem) {
      files.close();
      throw problem;
    }
  }

  /**
   * Starts a table.
   *
   * @param file where it will be
   * @param type class of the rows
   * @param <R> type of the rows
   * @return takes the rows
   * @throws IOException if it cannot be written
   */
  public <R extends Record> TableSink<R> table(Path file, Class<R> type) throws IOException {
    TableSink<R> table = Tables.of(factory.create(file), type, metadata);
    add(file, table::rows, table, table::finish);
    return table;
  }

  /**
   * Listens to what an outlet publishes, in the {@link Outlet#order() order} that it states. What
   * cannot be written ends the job.
   *
   * @param outlet the outlet
   * @param rows takes its results
   * @param <T> type of the results
   */
  public <T> void subscribe(Outlet<T> outlet, Consumer<? super T> rows) {
    Consumer<? super T> consumer = rows;
    if (outlet.order().isPresent()) {
      ResultOrder.Sorter<T> sorter = outlet.order().get().to(rows);
      sorters.add(sorter);
      consumer = sorter;
    }
    open.add(outlet.subscribe(consumer, failure)::close);
  }

  /**
   * Writes what an outlet publishes to a table.
   *
   * @param outlet the outlet
   * @param file where the table will be
   * @param <R> type of the rows
   * @throws IOException if it cannot be written
   */
  public <R extends Record> void write(Outlet<R> outlet, Path file) throws IOException {
    subscribe(outlet, table(file, outlet.type()));
  }

  /**
   * Adds a file that is no table, and is not one of {@link #files()}.
   *
   * @param part closed in any case
   * @param finish puts it in its place
   */
  public void add(Closeable part, Finish finish) {
    open.add(part);
    steps.add(finish);
  }

  /**
   * Adds a file that is written elsewhere.
   *
   * @param file where it will be
   * @param written its rows so far
   * @param part closed in any case
   * @param finish puts it in its place
   */
  public void add(Path file, LongSupplier written, Closeable part, Finish finish) {
    add(part, finish);
    rowCounts.put(file, written);
  }

  /**
   * Adds what takes the stream behind the chain.
   *
   * @param sink receives it
   * @param finish a step of finishing
   */
  public void add(StreamHandler sink, Finish finish) {
    sinks.add(sink);
    steps.add(finish);
  }

  @Override
  public List<StreamHandler> sinks() {
    return List.copyOf(sinks);
  }

  @Override
  public List<ResultFile> files() {
    List<ResultFile> files = new ArrayList<>();
    rowCounts.forEach((file, written) -> files.add(new ResultFile(file, written.getAsLong())));
    return files;
  }

  @Override
  public void finish() throws IOException {
    failure.rethrow();
    sorters.forEach(ResultOrder.Sorter::finish);
    for (Finish step : steps) {
      step.run();
    }
  }

  @Override
  public void close() throws IOException {
    IOException problem = null;
    for (Closeable part : open) {
      try {
        part.close();
      } catch (IOException thrown) {
        problem = thrown;
      }
    }
    if (problem != null) {
      throw problem;
    }
  }
}
