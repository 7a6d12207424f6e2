package haltere.core.pipeline;

import haltere.core.chain.ChainStage;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.sink.CsvSink;
import haltere.core.sink.TableMetadata;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Writes the results of the filters of a chain: a table for each outlet whose results are rows, in
 * the {@link Outlet#order() order} of the outlet. All tables appear together at the end, or none.
 *
 * <p>Thread rule: the processing thread.
 *
 * @since 0.1
 */
public final class OutletTables {
  /** Chooses the outlets that have a table, and its path. */
  public interface Naming {
    /**
     * The path of a table.
     *
     * @param stage the stage of the filter
     * @param outlet an outlet of it
     * @return a file
     */
    Path file(ChainStage stage, Outlet<?> outlet);

    /**
     * Whether there is a table.
     *
     * @param stage the stage of the filter
     * @param outlet an outlet of it whose results are rows
     * @return true for all of them by default
     */
    default boolean isWritten(ChainStage stage, Outlet<?> outlet) {
      return true;
    }
  }

  private OutletTables() {}

  /**
   * The files that {@link #open} would write.
   *
   * @param chain the chain, of which nested chains are part
   * @param naming the path of each table
   * @return in the order of the chain
   */
  public static List<Path> files(FilterChain chain, Naming naming) {
    List<Path> files = new ArrayList<>();
    for (ChainStage stage : chain.innermostStages()) {
      for (Outlet<?> outlet : stage.filter().outlets()) {
        if (CsvSink.isFlat(outlet.type()) && naming.isWritten(stage, outlet)) {
          files.add(naming.file(stage, outlet));
        }
      }
    }
    return files;
  }

  /**
   * Starts the tables and subscribes to the outlets.
   *
   * @param chain the chain
   * @param naming the path of each table
   * @param factory creates each file
   * @param metadata kept in tables whose format, which follows from the name, can hold it
   * @return open tables
   * @throws IOException if one cannot be written
   */
  public static ResultFiles open(
      FilterChain chain, Naming naming, ResultFiles.FileFactory factory, TableMetadata metadata)
      throws IOException {
    return ResultFiles.open(
        factory,
        metadata,
        files -> {
          for (ChainStage stage : chain.innermostStages()) {
            for (Outlet<?> outlet : stage.filter().outlets()) {
              if (CsvSink.isFlat(outlet.type()) && naming.isWritten(stage, outlet)) {
                write(outlet, naming.file(stage, outlet), files);
              }
            }
          }
        });
  }

  @SuppressWarnings("unchecked")
  private static void write(Outlet<?> outlet, Path file, ResultFiles files) throws IOException {
    files.write((Outlet<? extends Record>) outlet, file);
  }
}
