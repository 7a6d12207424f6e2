package haltere.core.sink;

import haltere.core.format.AtomicFile;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;

/**
 * Writes records as rows of a table: comma separated, UTF-8, a header line, lines that end in a
 * line feed, a decimal point in every locale. Names of components become names of columns in
 * snake_case unless {@link Column} renames them. Not-a-number, null and an empty optional are empty
 * fields; infinity is {@code inf}; enum constants are as their {@code toString}.
 *
 * <p>Thread rule: one thread at a time.
 *
 * @param <R> type of the rows, a {@link #isFlat flat} record
 * @since 0.1
 */
public final class CsvSink<R extends Record> implements TableSink<R> {
  private final AtomicFile file;
  private final CsvText text;
  private final RowFields fields;
  private long rows;

  private CsvSink(AtomicFile file, OutputStream out, Class<R> type) {
    this.file = file;
    fields = new RowFields(type);
    text = new CsvText(out);
    List<String> names = fields.names();
    for (int i = 0; i < names.size(); i++) {
      if (i > 0) {
        text.raw(',');
      }
      text.text(names.get(i));
    }
    text.raw('\n');
  }

  /**
   * Starts a table, whose file appears when it is {@link #finish() finished}.
   *
   * @param <R> type of the rows
   * @param file its path
   * @param type class of the rows
   * @param overwrite whether an existing file may be replaced
   * @return an open table
   * @throws IOException if the file exists and may not be replaced, or cannot be written
   * @throws IllegalArgumentException if the type is not flat
   */
  public static <R extends Record> CsvSink<R> create(Path file, Class<R> type, boolean overwrite)
      throws IOException {
    return of(AtomicFile.create(file, overwrite), type);
  }

  /**
   * Starts a table in a new file.
   *
   * @param <R> type of the rows
   * @param file empty; owned by the table from now on
   * @param type class of the rows
   * @return an open table
   * @throws IOException if the file cannot be closed after a failure
   * @throws IllegalArgumentException if the type is not flat
   */
  public static <R extends Record> CsvSink<R> of(AtomicFile file, Class<R> type)
      throws IOException {
    try {
      return new CsvSink<>(file, file.stream(), type);
    } catch (RuntimeException thrown) {
      file.close();
      throw thrown;
    }
  }

  /**
   * Starts a table on a stream, such as standard output.
   *
   * @param <R> type of the rows
   * @param out flushed by {@link #finish()}, never closed
   * @param type class of the rows
   * @return an open table
   * @throws IllegalArgumentException if the type is not flat
   */
  public static <R extends Record> CsvSink<R> on(OutputStream out, Class<R> type) {
    return new CsvSink<>(null, Objects.requireNonNull(out, "out"), type);
  }

  /**
   * Whether records of a type are rows: each component a number, a truth value, a character, a
   * text, an enum constant or an optional number.
   *
   * @param type any class
   * @return true if a table can be made of them
   */
  public static boolean isFlat(Class<?> type) {
    return RowFields.isFlat(type);
  }

  /**
   * Names of the columns.
   *
   * @param type a record
   * @return in order
   */
  public static List<String> columns(Class<? extends Record> type) {
    return RowFields.names(type);
  }

  @Override
  public void accept(R row) {
    Objects.requireNonNull(row, "row");
    try {
      int columns = fields.names().size();
      for (int i = 0; i < columns; i++) {
        if (i > 0) {
          text.raw(',');
        }
        fields.write(i, row, text);
      }
      text.endLine();
      rows++;
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    }
  }

  /**
   * Writes a comment line: # and words for users. Readers of tables can skip such lines.
   *
   * @param words one line
   * @throws UncheckedIOException if it cannot be written
   */
  public void comment(String words) {
    try {
      text.comment(words);
    } catch (IOException thrown) {
      throw new UncheckedIOException(thrown);
    }
  }

  @Override
  public long rows() {
    return rows;
  }

  @Override
  public void finish() throws IOException {
    text.flush();
    if (file != null) {
      file.commit();
    }
  }

  @Override
  public void close() throws IOException {
    if (file != null) {
      file.close();
    }
  }
}
