package haltere.core.pipeline;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.sink.CsvSink;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Writes all that the filters of a chain publish as {@link CsvSink#isFlat flat} records: one table
 * per outlet, named after a path, the stage and the outlet, such as {@code
 * out-cluster-tracker-clusters.csv}. Outlets of other types are left out.
 *
 * <p>Thread rule: opened, finished and closed while the chain does not run; writes on the
 * processing thread.
 */
public final class ResultLog implements Closeable {
  private record Table(
      Path file, String outlet, CsvSink<?> sink, Outlet.Subscription subscription) {}

  private final List<Table> tables = new ArrayList<>();

  private ResultLog() {}

  /**
   * Starts a table for each outlet of the stages that the chain has now.
   *
   * @param chain the chain
   * @param beside a path in the folder for the tables, of which they bear the name without its
   *     ending
   * @param overwrite whether files that are there may be replaced
   * @return a log that listens
   * @throws IOException if a table cannot be started; none is then left
   */
  public static ResultLog open(FilterChain chain, Path beside, boolean overwrite)
      throws IOException {
    ResultLog log = new ResultLog();
    try {
      Set<Path> taken = new HashSet<>();
      for (ChainStage stage : chain.stages()) {
        for (Outlet<?> outlet : stage.filter().outlets()) {
          if (CsvSink.isFlat(outlet.type())) {
            Path file = file(beside, stage, outlet, taken);
            log.listen(file, stage, outlet, outlet.type().asSubclass(Record.class), overwrite);
          }
        }
      }
      return log;
    } catch (IOException | RuntimeException thrown) {
      log.close();
      throw thrown;
    }
  }

  private static Path file(Path beside, ChainStage stage, Outlet<?> outlet, Set<Path> taken) {
    String name = String.valueOf(beside.getFileName());
    int dot = name.lastIndexOf('.');
    String stem =
        (dot > 0 ? name.substring(0, dot) : name) + "-" + stage.name() + "-" + outlet.name();
    Path file = beside.resolveSibling(stem + ".csv");
    // Filters of a nested chain share its stage and may have outlets of the same name.
    for (int number = 2; !taken.add(file); number++) {
      file = beside.resolveSibling(stem + "-" + number + ".csv");
    }
    return file;
  }

  private <R extends Record> void listen(
      Path file, ChainStage stage, Outlet<?> outlet, Class<R> type, boolean overwrite)
      throws IOException {
    CsvSink<R> sink = CsvSink.create(file, type, overwrite);
    Outlet.Subscription subscription = outlet.subscribe(result -> sink.accept(type.cast(result)));
    tables.add(new Table(file, stage.name() + "/" + outlet.name(), sink, subscription));
  }

  /**
   * The tables.
   *
   * @return their paths, in the order of the chain
   */
  public List<Path> files() {
    return tables.stream().map(Table::file).toList();
  }

  /**
   * What was written.
   *
   * @return a line per table, with its outlet, rows and path
   */
  public List<String> summary() {
    return tables.stream()
        .map(table -> table.outlet() + ": " + table.sink().rows() + " rows, " + table.file())
        .toList();
  }

  /**
   * Ends listening and puts all tables in their places.
   *
   * @throws IOException if one cannot be completed; those before it are in their places
   */
  public void finish() throws IOException {
    for (Table table : tables) {
      table.subscription().close();
    }
    for (Table table : tables) {
      table.sink().finish();
    }
  }

  /**
   * Ends listening; tables that were not finished leave nothing.
   *
   * @throws IOException if one cannot be removed
   */
  @Override
  public void close() throws IOException {
    IOException first = null;
    for (Table table : tables) {
      table.subscription().close();
      try {
        table.sink().close();
      } catch (IOException thrown) {
        first = first == null ? thrown : first;
      }
    }
    if (first != null) {
      throw first;
    }
  }
}
