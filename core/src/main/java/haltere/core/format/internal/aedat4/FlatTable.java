package haltere.core.format.internal.aedat4;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import java.nio.charset.StandardCharsets;

/**
 * A table of a FlatBuffer, read without copying. All positions are checked; invalid bytes throw a
 * {@link DamagedPacketException}.
 */
final class FlatTable {
  private final byte[] bytes;
  private final int base;
  private final int end;
  private final int table;
  private final int vtable;
  private final int vtableBytes;
  private final int tableBytes;

  private FlatTable(byte[] bytes, int base, int end, int table) throws DamagedPacketException {
    this.bytes = bytes;
    this.base = base;
    this.end = end;
    this.table = table;
    long toVtable = (long) table - LittleEndian.getInt(bytes, check(table, 4));
    if (toVtable < base || toVtable + 4 > end) {
      throw new DamagedPacketException("a table without a layout");
    }
    vtable = (int) toVtable;
    vtableBytes = LittleEndian.getUnsignedShort(bytes, vtable);
    tableBytes = LittleEndian.getUnsignedShort(bytes, vtable + 2);
    if (vtableBytes < 4 || (vtableBytes & 1) != 0 || tableBytes < 4) {
      throw new DamagedPacketException("a table of impossible size");
    }
    check(vtable, vtableBytes);
    check(table, tableBytes);
  }

  /**
   * The root of a size-prefixed buffer.
   *
   * @param bytes holds the buffer
   * @param from position of its size
   * @param to end of the available bytes, which may be fewer than the buffer has
   */
  static FlatTable root(byte[] bytes, int from, int to) throws DamagedPacketException {
    if (to - from < 12) {
      throw new DamagedPacketException("too short for a table");
    }
    int base = from + 4;
    long root = LittleEndian.getInt(bytes, base) & 0xffff_ffffL;
    if (root < 8 || root > to - base - 4) {
      throw new DamagedPacketException("a root outside of the buffer");
    }
    return new FlatTable(bytes, base, to, base + (int) root);
  }

  /** The four-letter identifier of a size-prefixed buffer. */
  static String identifier(byte[] bytes, int from, int to) {
    return to - from < 12 ? "" : new String(bytes, from + 8, 4, StandardCharsets.ISO_8859_1);
  }

  private int check(long at, long length) throws DamagedPacketException {
    if (at < base || length < 0 || at + length > end) {
      throw new DamagedPacketException("a part outside of the buffer");
    }
    return (int) at;
  }

  /** Position of a field, or -1 if the table does not have it. */
  private int field(int index, int length) throws DamagedPacketException {
    int slot = 4 + 2 * index;
    if (slot + 2 > vtableBytes) {
      return -1;
    }
    int offset = LittleEndian.getUnsignedShort(bytes, vtable + slot);
    if (offset == 0) {
      return -1;
    }
    if (offset < 4 || offset + length > tableBytes) {
      throw new DamagedPacketException("a field outside of its table");
    }
    return table + offset;
  }

  int getInt(int index, int otherwise) throws DamagedPacketException {
    int at = field(index, 4);
    return at < 0 ? otherwise : LittleEndian.getInt(bytes, at);
  }

  long getLong(int index, long otherwise) throws DamagedPacketException {
    int at = field(index, 8);
    return at < 0 ? otherwise : LittleEndian.getLong(bytes, at);
  }

  /** Index of a field in the array, or -1 if the table does not have it. */
  int position(int index, int length) throws DamagedPacketException {
    return field(index, length);
  }

  /** Index of a vector's length in the array, or -1 if the table does not have it. */
  private int vector(int index) throws DamagedPacketException {
    int at = field(index, 4);
    if (at < 0) {
      return -1;
    }
    return check(at + (LittleEndian.getInt(bytes, at) & 0xffff_ffffL), 4);
  }

  String getString(int index) throws DamagedPacketException {
    int at = vector(index);
    if (at < 0) {
      return "";
    }
    int length = LittleEndian.getInt(bytes, at);
    check(at + 4L, length);
    return new String(bytes, at + 4, length, StandardCharsets.UTF_8);
  }

  /** Stated number of elements of a vector; they may be beyond the end of the buffer. */
  long vectorLength(int index) throws DamagedPacketException {
    int at = vector(index);
    return at < 0 ? 0 : LittleEndian.getInt(bytes, at) & 0xffff_ffffL;
  }

  /** Index of a vector's first element in the array, or -1 if the table does not have it. */
  int vectorElements(int index) throws DamagedPacketException {
    int at = vector(index);
    return at < 0 ? -1 : at + 4;
  }

  /** A table in a vector of tables. */
  FlatTable vectorTable(int index, int element) throws DamagedPacketException {
    int at = check(vectorElements(index) + 4L * element, 4);
    return new FlatTable(
        bytes, base, end, check(at + (LittleEndian.getInt(bytes, at) & 0xffff_ffffL), 4));
  }
}
