package haltere.core.sink;

import haltere.core.format.AtomicFile;
import java.io.IOException;

/**
 * A format of tables beside CSV, found as a service ({@code
 * META-INF/services/haltere.core.sink.TableFormat}), so that a format with a library can have a jar
 * of its own.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface TableFormat {
  /**
   * Extension of the names of its files.
   *
   * @return lower case, without the dot, such as {@code parquet}
   */
  String extension();

  /**
   * Starts a table.
   *
   * @param <R> type of the rows
   * @param file empty; owned by the table from now on
   * @param type class of the rows
   * @param metadata kept in the file beside the rows
   * @return an open table
   * @throws IOException if the file cannot be written; it is then closed
   * @throws IllegalArgumentException if the type is not {@link CsvSink#isFlat flat}
   */
  <R extends Record> TableSink<R> open(AtomicFile file, Class<R> type, TableMetadata metadata)
      throws IOException;
}
