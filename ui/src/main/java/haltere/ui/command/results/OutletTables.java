package haltere.ui.command.results;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.sink.CsvSink;
import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes what the filters of a chain publish, a table for each outlet whose results are rows. All
 * tables appear together at the end, or none.
 *
 * <p>Thread rule: the processing thread.
 */
public final class OutletTables implements Closeable {
  /** Says where the table of an outlet goes. */
  public interface Naming {
    Path file(ChainStage stage, Outlet<?> outlet);
  }

  private final Map<Path, CsvSink<?>> tables = new LinkedHashMap<>();
  private final List<Outlet.Subscription> subscriptions = new ArrayList<>();

  private OutletTables() {}

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
   * @param overwrite whether existing files may be replaced
   * @return open tables
   * @throws IOException if one cannot be written
   */
  public static OutletTables open(FilterChain chain, Naming naming, boolean overwrite)
      throws IOException {
    OutletTables tables = new OutletTables();
    try {
      for (ChainStage stage : stages(chain)) {
        for (Outlet<?> outlet : stage.filter().outlets()) {
          if (CsvSink.isFlat(outlet.type())) {
            tables.open(outlet, naming.file(stage, outlet), overwrite);
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
  private void open(Outlet<?> outlet, Path file, boolean overwrite) throws IOException {
    openRows((Outlet<? extends Record>) outlet, file, overwrite);
  }

  private <R extends Record> void openRows(Outlet<R> outlet, Path file, boolean overwrite)
      throws IOException {
    CsvSink<R> table = CsvSink.create(file, outlet.type(), overwrite);
    tables.put(file, table);
    subscriptions.add(outlet.subscribe(table));
  }

  /**
   * The tables and how many rows they have so far.
   *
   * @return in the order of the chain
   */
  public Map<Path, Long> rows() {
    Map<Path, Long> rows = new LinkedHashMap<>();
    tables.forEach((file, table) -> rows.put(file, table.rows()));
    return rows;
  }

  /** Puts all tables in their places. */
  public void finish() throws IOException {
    for (CsvSink<?> table : tables.values()) {
      table.finish();
    }
  }

  @Override
  public void close() throws IOException {
    for (Outlet.Subscription subscription : subscriptions) {
      subscription.close();
    }
    IOException problem = null;
    for (CsvSink<?> table : tables.values()) {
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
