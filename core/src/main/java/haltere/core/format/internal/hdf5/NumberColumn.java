package haltere.core.format.internal.hdf5;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.decoding.RowCursor;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * A column of numbers in the rows of a dataset.
 *
 * <p>Thread rule: one thread.
 */
final class NumberColumn {
  private final DatasetRows rows;
  private final int rowBytes;
  private final int offset;
  private final ElementType type;
  private byte[] data = {};
  private ByteBuffer buffer = ByteBuffer.wrap(data);
  private int at;

  NumberColumn(DatasetRows rows, EventTable.StoredColumn column) {
    this.rows = rows;
    rowBytes = column.dataset().rowBytes();
    offset = column.offset();
    type = column.type();
  }

  /** Loads a row, see {@link DatasetRows#load}. */
  long load(long row) throws IOException, DamagedPacketException {
    long count = rows.load(row);
    if (count > 0) {
      data = rows.data();
      at = rows.at(row) + offset;
    }
    return count;
  }

  DatasetRows rows() {
    return rows;
  }

  byte[] data() {
    return data;
  }

  /** Index in {@link #data()} of the loaded row. */
  int at() {
    return at;
  }

  /** Bytes from a row to the next. */
  int stride() {
    return rowBytes;
  }

  /** Whether its numbers are little-endian integers of a size. */
  boolean isWhole(int bytes) {
    return type.bytes() == bytes
        && (type.kind() == 'i' || type.kind() == 'u')
        && (bytes == 1 || !type.bigEndian());
  }

  boolean isUnsigned() {
    return type.kind() == 'u';
  }

  /** A value, multiplied by 10^scale; {@link RowCursor#NO_NUMBER} for one that is none. */
  long value(int fromLoaded, int scale) {
    if (buffer.array() != data) {
      buffer =
          ByteBuffer.wrap(data)
              .order(type.bigEndian() ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    }
    int index = at + fromLoaded * rowBytes;
    if (type.kind() == 'f') {
      double value = type.bytes() == 8 ? buffer.getDouble(index) : buffer.getFloat(index);
      double factor = Math.pow(10, Math.abs(scale));
      return RowCursor.rounded(scale < 0 ? value / factor : value * factor);
    }
    long value = whole(buffer, index, type);
    return switch (scale) {
      case 0 -> value;
      case 3 -> value * 1000;
      case 6 -> value * 1_000_000;
      default -> Math.floorDiv(value + 500, 1000L);
    };
  }

  /** The unscaled value. */
  double real(int fromLoaded) {
    if (type.kind() != 'f') {
      return value(fromLoaded, 0);
    }
    value(fromLoaded, 0);
    int index = at + fromLoaded * rowBytes;
    return type.bytes() == 8 ? buffer.getDouble(index) : buffer.getFloat(index);
  }

  /** An integer at an index; of 8 unsigned bytes, the raw 64 bits. */
  static long whole(ByteBuffer bytes, int index, ElementType type) {
    boolean signed = type.kind() == 'i';
    return switch (type.bytes()) {
      case 1 -> signed ? bytes.get(index) : bytes.get(index) & 0xff;
      case 2 -> signed ? bytes.getShort(index) : bytes.getShort(index) & 0xffff;
      case 4 -> signed ? bytes.getInt(index) : bytes.getInt(index) & 0xffffffffL;
      default -> bytes.getLong(index);
    };
  }

  /** A 64-bit number, if the column {@link #isWhole} of 8 bytes. */
  static long wide(byte[] data, int index) {
    return (long) LittleEndian.LONG.get(data, index);
  }
}
