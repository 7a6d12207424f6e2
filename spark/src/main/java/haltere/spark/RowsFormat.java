package haltere.spark;

import haltere.core.format.AtomicFile;
import haltere.core.sink.RowFields;
import haltere.core.sink.TableFormat;
import haltere.core.sink.TableMetadata;
import haltere.core.sink.TableSink;
import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Consumer;

/**
 * Temporary table format between a job and Spark on one machine: each value is preceded by its
 * kind.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public final class RowsFormat implements TableFormat {
  static final String ENDING = "haltere-rows";

  private static final int NOTHING = 0;
  private static final int LONG = 1;
  private static final int DOUBLE = 2;
  private static final int FLOAT = 3;
  private static final int FLAG = 4;
  private static final int TEXT = 5;
  private static final int INTEGER = 6;

  /** For the service loader. */
  public RowsFormat() {}

  @Override
  public String extension() {
    return ENDING;
  }

  @Override
  public <R extends Record> TableSink<R> open(
      AtomicFile file, Class<R> type, TableMetadata metadata) {
    return new RowsSink<>(file, new RowFields(type));
  }

  /** Reads the values of the next row; returns false at the end of the file. */
  static boolean read(DataInputStream in, int columns, Consumer<Object> values) throws IOException {
    for (int i = 0; i < columns; i++) {
      int kind = in.read();
      if (kind < 0 && i == 0) {
        return false;
      }
      values.accept(
          switch (kind) {
            case NOTHING -> null;
            case LONG -> in.readLong();
            case INTEGER -> in.readInt();
            case DOUBLE -> in.readDouble();
            case FLOAT -> in.readFloat();
            case FLAG -> in.readBoolean();
            case TEXT -> new String(in.readNBytes(in.readInt()), StandardCharsets.UTF_8);
            default -> throw new EOFException("a row is incomplete");
          });
    }
    return true;
  }

  static DataInputStream open(Path file) throws IOException {
    return new DataInputStream(new BufferedInputStream(Files.newInputStream(file), 1 << 16));
  }

  /**
   * Table in this format.
   *
   * @param <R> type of the rows
   */
  private static final class RowsSink<R extends Record> implements TableSink<R>, RowFields.Values {
    private final AtomicFile file;
    private final RowFields fields;
    private final DataOutputStream out;
    private int column;
    private long rows;

    RowsSink(AtomicFile file, RowFields fields) {
      this.file = file;
      this.fields = fields;
      out = new DataOutputStream(new BufferedOutputStream(file.stream(), 1 << 16));
    }

    /** Writes a value. */
    private interface Value {
      void write() throws IOException;
    }

    private void write(int kind, Value value) {
      try {
        out.writeByte(kind);
        value.write();
      } catch (IOException thrown) {
        throw new UncheckedIOException(thrown);
      }
    }

    @Override
    public void accept(R row) {
      for (column = 0; column < fields.kinds().size(); column++) {
        fields.write(column, row, this);
      }
      rows++;
    }

    @Override
    public void number(long value) {
      if (fields.kinds().get(column) == RowFields.FieldKind.INTEGER) {
        write(INTEGER, () -> out.writeInt((int) value));
      } else {
        write(LONG, () -> out.writeLong(value));
      }
    }

    @Override
    public void number(double value, int decimals) {
      if (Double.isNaN(value)) {
        nothing();
      } else {
        write(DOUBLE, () -> out.writeDouble(value));
      }
    }

    @Override
    public void number(float value, int decimals) {
      if (Float.isNaN(value)) {
        nothing();
      } else {
        write(FLOAT, () -> out.writeFloat(value));
      }
    }

    @Override
    public void flag(boolean value) {
      write(FLAG, () -> out.writeBoolean(value));
    }

    @Override
    public void text(CharSequence value) {
      byte[] bytes = value.toString().getBytes(StandardCharsets.UTF_8);
      write(
          TEXT,
          () -> {
            out.writeInt(bytes.length);
            out.write(bytes);
          });
    }

    @Override
    public void nothing() {
      write(NOTHING, () -> {});
    }

    @Override
    public long rows() {
      return rows;
    }

    @Override
    public void finish() throws IOException {
      out.flush();
      file.commit();
    }

    @Override
    public void close() throws IOException {
      file.close();
    }
  }
}
