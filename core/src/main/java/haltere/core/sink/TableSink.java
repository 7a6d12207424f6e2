package haltere.core.sink;

import java.io.Closeable;
import java.io.IOException;
import java.util.function.Consumer;

/**
 * A table that is being written, one row per record. Its file appears when it is {@link #finish()
 * finished}; closed before that, it leaves nothing.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @param <R> type of the rows, a {@link CsvSink#isFlat flat} record
 * @since 0.1
 */
public interface TableSink<R extends Record> extends Consumer<R>, Closeable {
  /**
   * Writes a row.
   *
   * @param row the row
   * @throws java.io.UncheckedIOException if it cannot be written
   */
  @Override
  void accept(R row);

  /**
   * Rows written.
   *
   * @return a count, without a header
   */
  long rows();

  /**
   * Completes the file, which then appears.
   *
   * @throws IOException if that fails; an existing file is then unchanged
   */
  void finish() throws IOException;

  @Override
  void close() throws IOException;
}
