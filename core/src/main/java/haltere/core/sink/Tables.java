package haltere.core.sink;

import haltere.core.extension.Extensions;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Opens tables in the format of their name: CSV, and each {@link TableFormat} service.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class Tables {
  /** Ending of comma separated text. */
  public static final String CSV = "csv";

  /** Formats that come in a module of their own, by extension. */
  private static final Map<String, String> MODULES = Map.of("parquet", "haltere-columnar");

  private Tables() {}

  private static Map<String, TableFormat> found() {
    Map<String, TableFormat> found = new TreeMap<>();
    for (TableFormat format : Extensions.find(TableFormat.class)) {
      found.putIfAbsent(format.extension(), format);
    }
    return found;
  }

  /**
   * The available extensions.
   *
   * @return CSV first
   */
  public static List<String> extensions() {
    List<String> extensions = new java.util.ArrayList<>(found().keySet());
    extensions.add(0, CSV);
    return extensions;
  }

  /**
   * Why a table cannot be written under a name.
   *
   * @param file its path
   * @return one line for users; empty if its format is available; unknown extensions mean CSV
   */
  public static Optional<String> problem(Path file) {
    String extension = extension(file);
    return MODULES.containsKey(extension) && !found().containsKey(extension)
        ? Optional.of(
            "tables of the format "
                + extension
                + " need the module "
                + MODULES.get(extension)
                + ", which is not installed; name a .csv")
        : Optional.empty();
  }

  /**
   * Starts a table, whose file appears when it is finished.
   *
   * @param <R> type of the rows
   * @param file its path
   * @param type class of the rows
   * @param overwrite whether an existing file may be replaced
   * @param metadata stored in the file if its format can
   * @return an open table
   * @throws IOException if its format is missing, the file exists and may not be replaced, or it
   *     cannot be written
   * @throws IllegalArgumentException if the type is not {@link CsvSink#isFlat flat}
   */
  public static <R extends Record> TableSink<R> create(
      Path file, Class<R> type, boolean overwrite, TableMetadata metadata) throws IOException {
    Optional<String> problem = problem(file);
    if (problem.isPresent()) {
      throw new RecordingProblem(file, problem.get());
    }
    return of(AtomicFile.create(file, overwrite), type, metadata);
  }

  /**
   * Starts a table in a new file.
   *
   * @param <R> type of the rows
   * @param file empty; owned by the table from now on
   * @param type class of the rows
   * @param metadata stored in the file if its format can
   * @return an open table
   * @throws IOException if its format is missing, or the file cannot be written
   * @throws IllegalArgumentException if the type is not flat
   */
  public static <R extends Record> TableSink<R> of(
      AtomicFile file, Class<R> type, TableMetadata metadata) throws IOException {
    Optional<String> problem = problem(file.path());
    if (problem.isPresent()) {
      file.close();
      throw new RecordingProblem(file.path(), problem.get());
    }
    TableFormat format = found().get(extension(file.path()));
    return format == null ? CsvSink.of(file, type) : format.open(file, type, metadata);
  }

  private static String extension(Path file) {
    String name = String.valueOf(file.getFileName());
    return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
  }
}
