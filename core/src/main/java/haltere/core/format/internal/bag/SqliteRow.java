package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.Payload;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * A row of an SQLite table: its column values, and the bytes of a column, which may continue on
 * overflow pages.
 */
final class SqliteRow extends Payload {
  private static final int MAX_COLUMNS = 64;
  private static final int MAX_HEAD = 512;
  private static final int MAX_TEXT = 64 * 1024;
  private static final int FIRST_BLOB = 12;

  private final SqliteFile file;
  private final ByteBuffer page;
  private final long[] types = new long[MAX_COLUMNS];
  private int columns;
  private int column;
  private long left;
  private long chain;

  SqliteRow(SqliteFile file) {
    this.file = file;
    page = file.page();
  }

  /**
   * Opens a row.
   *
   * @param leaf holds its first bytes
   * @param at index of the first
   * @param bytes of the whole row
   */
  void open(ByteBuffer leaf, int at, long bytes) throws IOException, DamagedPacketException {
    int usable = file.usableBytes();
    if (bytes < 0 || bytes > file.bytes()) {
      throw new DamagedPacketException("a row of impossible length");
    }
    int local = (int) Math.min(bytes, usable);
    chain = 0;
    if (bytes > usable - 35) {
      int minLocal = (usable - 12) * 32 / 255 - 23;
      int maxLocal = minLocal + (int) ((bytes - minLocal) % (usable - 4));
      local = maxLocal <= usable - 35 ? maxLocal : minLocal;
    }
    if (at + local > usable || bytes > local && at + local + 4 > usable) {
      throw new DamagedPacketException("a row outside of its page");
    }
    if (bytes > local) {
      chain = leaf.getInt(at + local) & 0xffff_ffffL;
    }
    data = data.length < local ? new byte[file.pageBytes()] : data;
    System.arraycopy(leaf.array(), at, data, 0, local);
    from = 0;
    to = local;
    left = bytes - local;
    readTypes();
  }

  private void readTypes() throws IOException, DamagedPacketException {
    gather(MAX_HEAD);
    int start = from;
    long head = SqliteVarint.take(this::takeByte);
    if (head > MAX_HEAD || head > to - start) {
      throw new DamagedPacketException("a row with too many columns");
    }
    columns = 0;
    column = 0;
    while (from - start < head) {
      if (columns == MAX_COLUMNS) {
        throw new DamagedPacketException("a row with too many columns");
      }
      types[columns++] = SqliteVarint.take(this::takeByte);
    }
  }

  private byte takeByte() throws DamagedPacketException {
    if (from == to) {
      throw new DamagedPacketException("a number that ends too early");
    }
    return data[from++];
  }

  @Override
  public void open(long offset, long size) {
    throw new UnsupportedOperationException("rows are opened in their page");
  }

  @Override
  public boolean more() throws IOException, DamagedPacketException {
    if (left == 0) {
      return false;
    }
    file.read(page, chain);
    int count = (int) Math.min(left, file.usableBytes() - 4);
    int unused = to - from;
    if (data.length < unused + count) {
      data = Arrays.copyOfRange(data, from, from + Math.max(2 * unused, unused + 16 * count));
    } else {
      System.arraycopy(data, from, data, 0, unused);
    }
    from = 0;
    System.arraycopy(page.array(), 4, data, unused, count);
    to = unused + count;
    left -= count;
    chain = page.getInt(0) & 0xffff_ffffL;
    return true;
  }

  private long nextType() throws DamagedPacketException {
    if (column == columns) {
      throw new DamagedPacketException("a row with too few columns");
    }
    long type = types[column++];
    if (type < 0 || type == 10 || type == 11) {
      throw new DamagedPacketException("a value of an unknown type");
    }
    return type;
  }

  /** Bytes of a value. */
  private static long bytes(long type) {
    if (type >= FIRST_BLOB) {
      return (type - FIRST_BLOB) / 2;
    }
    return switch ((int) type) {
      case 1, 2, 3, 4 -> type;
      case 5 -> 6;
      case 6, 7 -> 8;
      default -> 0;
    };
  }

  /** Reads the next column as an integer; 0 if it is not one. */
  long takeNumber() throws IOException, DamagedPacketException {
    long type = nextType();
    int count = (int) Math.min(9, bytes(type));
    if (type >= FIRST_BLOB || type == 7 || count == 0) {
      skip(bytes(type));
      return type == 9 ? 1 : 0;
    }
    if (!gather(count)) {
      throw new DamagedPacketException("a row that ends too early");
    }
    long value = data[from];
    for (int i = 1; i < count; i++) {
      value = value << 8 | data[from + i] & 0xff;
    }
    use(count);
    return value;
  }

  /** Reads the next column, a text. */
  String takeText() throws IOException, DamagedPacketException {
    long type = nextType();
    long count = bytes(type);
    if (type < FIRST_BLOB || count > MAX_TEXT) {
      skip(count);
      return "";
    }
    if (!gather((int) count)) {
      throw new DamagedPacketException("a row that ends too early");
    }
    String text = new String(data, from, (int) count, StandardCharsets.UTF_8);
    use((int) count);
    return text;
  }

  /** Size of the next column in bytes; its bytes follow. */
  long takeBlob() throws DamagedPacketException {
    return bytes(nextType());
  }
}
