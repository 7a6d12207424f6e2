package haltere.core.format.internal.hdf5;

import haltere.core.format.AtomicFile;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Writes an HDF5 file with one table of numbers: a dataset of compound elements in the root group,
 * in chunks, as PyTables and h5py read it.
 *
 * <p>Thread rule: one thread at a time. Memory is bounded by a chunk.
 */
public final class Hdf5TableWriter implements Closeable {
  /** Type of a column. */
  public enum NumberType {
    /** An unsigned integer of four bytes. */
    U32(ElementType.whole(4, false)),
    /** A signed integer of eight bytes; exact up to 2⁵³, since values are doubles. */
    I64(ElementType.whole(8, true)),
    /** A floating-point number of four bytes. */
    F32(ElementType.real(4)),
    /** A floating-point number of eight bytes. */
    F64(ElementType.real(8));

    private final ElementType type;

    NumberType(ElementType type) {
      this.type = type;
    }
  }

  /**
   * A column.
   *
   * @param name ASCII
   * @param kind type of its numbers
   */
  public record Hdf5Column(String name, NumberType kind) {}

  private final AtomicFile file;
  private final List<Hdf5Column> columns;
  private final ChunkedColumn table;
  private final ByteBuffer chunk;

  private Hdf5TableWriter(AtomicFile file, String name, List<Hdf5Column> columns)
      throws IOException {
    this.file = file;
    this.columns = List.copyOf(columns);
    List<ElementType.Member> members = new ArrayList<>();
    int offset = 0;
    for (Hdf5Column column : columns) {
      members.add(new ElementType.Member(column.name(), offset, column.kind().type));
      offset += column.kind().type.bytes();
    }
    table = new ChunkedColumn(name, new ElementType('c', offset, false, members), 0);
    chunk = ByteBuffer.wrap(table.chunk()).order(ByteOrder.LITTLE_ENDIAN);
    file.channel().position(Hdf5Structure.BYTES);
  }

  /**
   * Starts a file, which appears when it is {@link #finish finished}.
   *
   * @param path path of the file
   * @param name of the table, ASCII
   * @param columns at least one, at most thirty
   * @param overwrite whether an existing file may be replaced
   * @return a table without rows
   * @throws IOException if the file exists and may not be replaced, or cannot be written
   */
  public static Hdf5TableWriter create(
      Path path, String name, List<Hdf5Column> columns, boolean overwrite) throws IOException {
    if (columns.isEmpty() || columns.size() > 30) {
      throw new IllegalArgumentException("a table has 1 to 30 columns, not " + columns.size());
    }
    AtomicFile file = AtomicFile.create(path, overwrite);
    try {
      return new Hdf5TableWriter(file, name, columns);
    } catch (IOException | RuntimeException problem) {
      file.close();
      throw problem;
    }
  }

  /**
   * Appends a row.
   *
   * @param values one for each column
   * @throws IOException if it cannot be written
   */
  public void append(double... values) throws IOException {
    if (values.length != columns.size()) {
      throw new IllegalArgumentException(
          "a row has " + columns.size() + " values, not " + values.length);
    }
    chunk.position(table.filled() * table.type().bytes());
    for (int i = 0; i < values.length; i++) {
      switch (columns.get(i).kind()) {
        case U32 -> chunk.putInt((int) (long) values[i]);
        case I64 -> chunk.putLong((long) values[i]);
        case F32 -> chunk.putFloat((float) values[i]);
        default -> chunk.putDouble(values[i]);
      }
    }
    table.setFilled(table.filled() + 1, file);
  }

  /**
   * Rows appended.
   *
   * @return at least 0
   */
  public long rows() {
    return table.rows();
  }

  /**
   * Completes the file and renames it to its target.
   *
   * @throws IOException if that fails; the target is then unchanged
   */
  public void finish() throws IOException {
    table.end(file);
    long tree = table.writeTree(file);
    long end = file.channel().position();
    file.channel().position(0);
    file.write(Hdf5Structure.of(end, table, tree));
    file.commit();
  }

  @Override
  public void close() throws IOException {
    table.close();
    file.close();
  }
}
