package haltere.core.format.internal.table;

import haltere.core.format.RecordingProblem;
import java.io.Closeable;
import java.io.IOException;
import java.util.List;
import java.util.Set;

/**
 * Tables of a file, by name, read row by row.
 *
 * <p>Thread rule: one thread.
 */
public interface RecordingTables extends Closeable {
  /**
   * Whether the file has a table, which may be empty.
   *
   * @param table its name; in HDF5 the path without a slash in front
   * @return true if it does
   */
  boolean has(String table);

  /**
   * Names of a table's columns.
   *
   * @param table its name
   * @return in the order of the file; empty if there is no such table
   * @throws IOException if the file cannot be read
   */
  Set<String> columns(String table) throws IOException;

  /**
   * Reads a table.
   *
   * @param table its name
   * @param names requested columns; missing ones are NaN or empty in each row
   * @param required number of leading ones that must exist
   * @param listener receives the rows in order
   * @throws RecordingProblem if the table or a required column is missing, or the file is damaged
   *     or cut off; the message names the file
   * @throws IOException if the file cannot be read, or from the listener
   */
  void read(String table, List<String> names, int required, RowListener listener)
      throws IOException;

  /** Receives rows. */
  @FunctionalInterface
  interface RowListener {
    /**
     * A row.
     *
     * @param row valid during the call
     * @throws IOException if a value cannot be read
     */
    void row(Row row) throws IOException;
  }

  /** A row of a table. */
  interface Row {
    /**
     * Number of the row.
     *
     * @return from 0
     */
    long index();

    /**
     * A number.
     *
     * @param column index in the list of requested columns
     * @return NaN if the table does not have the column
     * @throws IOException if it is not a number
     */
    double number(int column) throws IOException;

    /**
     * A text, or a number as text.
     *
     * @param column index in the list of requested columns
     * @return empty if the table does not have the column
     * @throws IOException if it is neither
     */
    String text(int column) throws IOException;

    /**
     * A list of whole numbers, of any length.
     *
     * @param column index in the list of requested columns
     * @return empty if the table does not have the column
     * @throws IOException if it is not such a list
     */
    long[] list(int column) throws IOException;
  }
}
