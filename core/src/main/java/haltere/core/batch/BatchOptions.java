package haltere.core.batch;

import haltere.core.chain.ChainStage;
import haltere.core.chain.Outlet;
import haltere.core.format.ReadOptions;
import haltere.core.pipeline.OutletTables;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Set;
import java.util.function.Function;

/**
 * Options of a batch.
 *
 * @param folder where results are written; created if missing
 * @param workers recordings processed in parallel, 1 to 1024
 * @param existing treatment of existing results
 * @param reading properties of all recordings stated by the user
 * @param strict whether a recording that is cut off or damaged is a failure
 * @param program name and version of the program, a part of what makes a result valid
 * @param tables extension of the tables, one of {@link haltere.core.sink.Tables#extensions}
 * @param outlets names of the outlets whose tables are written; all if empty
 * @since 0.1
 */
public record BatchOptions(
    Path folder,
    int workers,
    Existing existing,
    ReadOptions reading,
    boolean strict,
    String program,
    String tables,
    Set<String> outlets) {
  /** Treatment of existing results. */
  public enum Existing {
    /** The batch does not start. */
    REFUSE,
    /** Those that are complete and belong to the same chain and recording stay. */
    RESUME,
    /** All are created again. */
    OVERWRITE
  }

  /** Checks the values. */
  public BatchOptions {
    Objects.requireNonNull(folder, "folder");
    Objects.requireNonNull(existing, "existing");
    Objects.requireNonNull(reading, "reading");
    Objects.requireNonNull(program, "program");
    Objects.requireNonNull(tables, "tables");
    outlets = Set.copyOf(outlets);
    if (workers < 1 || workers > 1024) {
      throw new IllegalArgumentException("1 to 1024 workers can run, not " + workers);
    }
  }

  /** Selection and paths of the tables, by their names. */
  OutletTables.Naming naming(Function<String, Path> place) {
    return new OutletTables.Naming() {
      @Override
      public Path file(ChainStage stage, Outlet<?> outlet) {
        return place.apply(stage.name() + "." + outlet.name() + "." + tables);
      }

      @Override
      public boolean isWritten(ChainStage stage, Outlet<?> outlet) {
        return outlets.isEmpty() || outlets.contains(outlet.name());
      }
    };
  }
}
