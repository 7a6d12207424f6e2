package haltere.core.pipeline;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.chain.ResultOrder;
import haltere.core.format.AtomicFile;
import haltere.core.sink.CsvSink;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import haltere.core.stream.StreamHandler;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes what the filters of a chain publish, a table for each outlet whose results are rows, in
 * the {@link Outlet#order() order} that the outlet states. All tables appear together at the end,
 * or none.
 *
 * <p>Thread rule: the processing thread.
 *
 * @since 0.1
 */
public final class OutletTables implements JobResults {
  /** Says where the table of an outlet goes. */
  public interface Naming {
    /**
     * A table's place.
     *
     * @param stage the stage of the filter
     * @param outlet an outlet of it
     * @return a file
     */
    Path file(ChainStage stage, Outlet<?> outlet);
  }

  /** Begins a file. */
  public interface FileMaker {
    /**
     * Begins a file.
     *
     * @param file its place
     * @return an empty file that appears there when it is committed
     * @throws IOException if it cannot be written
     */
    AtomicFile create(Path file) throws IOException;
  }

  private final Map<Path, TableSink<?>> tables = new LinkedHashMap<>();
  private final List<ResultOrder.Sorter<?>> sorters = new ArrayList<>();
  private final List<Outlet.Subscription> subscriptions = new ArrayList<>();

  private final ResultFailure failure = new ResultFailure();

  private final TableMetadata metadata;

  private OutletTables(TableMetadata metadata) {
    this.metadata = metadata;
  }

  /**
   * The files that {@link #open} would write.
   *
   * @param chain the chain, of which nested chains are part
   * @param naming where each table goes
   * @return in the order of the chain
   */
  public static List<Path> files(FilterChain chain, Naming naming) {
    List<Path> files = new ArrayList<>();
    for (ChainStage stage : stages(chain)) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        if (CsvSink.isFlat(outlet.type())) {
          files.add(naming.file(stage, outlet));
        }
      }
    }
    return files;
  }

  /**
   * Starts the tables and listens from now on.
   *
   * @param chain the chain
   * @param naming where each table goes
   * @param maker begins each file
   * @param metadata kept in tables whose format, which follows from the name, can hold it
   * @return open tables
   * @throws IOException if one cannot be written
   */
  public static OutletTables open(
      FilterChain chain, Naming naming, FileMaker maker, TableMetadata metadata)
      throws IOException {
    OutletTables tables = new OutletTables(metadata);
    try {
      for (ChainStage stage : stages(chain)) {
        for (Outlet<?> outlet : stage.filter().outlets()) {
          if (CsvSink.isFlat(outlet.type())) {
            tables.open(outlet, naming.file(stage, outlet), maker);
          }
        }
      }
      return tables;
    } catch (IOException | RuntimeException problem) {
      tables.close();
      throw problem;
    }
  }

  private static List<ChainStage> stages(FilterChain chain) {
    List<ChainStage> stages = new ArrayList<>();
    for (ChainStage stage : chain.stages()) {
      if (stage.filter() instanceof FilterChain nested) {
        stages.addAll(stages(nested));
      } else {
        stages.add(stage);
      }
    }
    return stages;
  }

  @SuppressWarnings("unchecked")
  private void open(Outlet<?> outlet, Path file, FileMaker maker) throws IOException {
    openRows((Outlet<? extends Record>) outlet, file, maker);
  }

  private <R extends Record> void openRows(Outlet<R> outlet, Path file, FileMaker maker)
      throws IOException {
    TableSink<R> table = Tables.of(maker.create(file), outlet.type(), metadata);
    tables.put(file, table);
    if (outlet.order().isPresent()) {
      ResultOrder.Sorter<R> sorter = outlet.order().get().to(table);
      sorters.add(sorter);
      subscriptions.add(outlet.subscribe(sorter, failure));
    } else {
      subscriptions.add(outlet.subscribe(table, failure));
    }
  }

  @Override
  public List<StreamHandler> sinks() {
    return List.of(failure);
  }

  @Override
  public List<ResultFile> files() {
    List<ResultFile> files = new ArrayList<>();
    tables.forEach((file, table) -> files.add(new ResultFile(file, table.rows())));
    return files;
  }

  @Override
  public void finish() throws IOException {
    failure.rethrow();
    sorters.forEach(ResultOrder.Sorter::finish);
    for (TableSink<?> table : tables.values()) {
      table.finish();
    }
  }

  @Override
  public void close() throws IOException {
    subscriptions.forEach(Outlet.Subscription::close);
    IOException problem = null;
    for (TableSink<?> table : tables.values()) {
      try {
        table.close();
      } catch (IOException thrown) {
        problem = thrown;
      }
    }
    if (problem != null) {
      throw problem;
    }
  }
}
