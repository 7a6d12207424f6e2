package haltere.core.sink;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.function.Consumer;

/**
 * Writes records as rows of a table: comma separated, UTF-8, a header line, lines that end in a
 * line feed, a point as decimal point whatever the locale. Names of components become names of
 * columns in snake_case unless {@link Column} says otherwise. Not-a-number, null and an empty
 * optional are empty fields.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @param <R> type of the rows, a {@link #isFlat flat} record
 */
public final class CsvSink<R extends Record> implements Consumer<R>, Closeable {
  private long rows;

  private CsvSink() {}

  /**
   * Starts a table beside its place, where it appears when it is {@link #finish() finished}.
   *
   * @param <R> type of the rows
   * @param file where it will be
   * @param type class of the rows
   * @param overwrite whether a file that is there may be replaced
   * @return an open table
   * @throws IOException if the file is there and may not be replaced, or cannot be written
   */
  public static <R extends Record> CsvSink<R> create(Path file, Class<R> type, boolean overwrite)
      throws IOException {
    throw new IOException("not written yet: " + file + type + overwrite);
  }

  /**
   * Whether records of a type are rows: each component a number, a truth value, a character, a
   * text, an enum constant or an optional number.
   *
   * @param type any class
   * @return true if a table can be made of them
   */
  public static boolean isFlat(Class<?> type) {
    return type.isRecord();
  }

  /**
   * Writes a row.
   *
   * @param row the row
   * @throws java.io.UncheckedIOException if it cannot be written
   */
  @Override
  public void accept(R row) {
    rows++;
  }

  /**
   * Rows written.
   *
   * @return a count, without the header
   */
  public long rows() {
    return rows;
  }

  /**
   * Completes the file and puts it in its place.
   *
   * @throws IOException if that fails; the target is then as it was
   */
  public void finish() throws IOException {}

  @Override
  public void close() throws IOException {}
}
