package haltere.core.format.internal.aedat4;

import haltere.core.format.RecordingFile;
import haltere.core.format.internal.compression.LittleEndian;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The table of packets at the end of a closed file: stream, offset, number of events, first and
 * last time. This class collects it during writing.
 *
 * <p>Thread rule: one thread.
 */
final class DataTable {
  static final String IDENTIFIER = "FTAB";

  private static final int ENTRY_LONGS = 6;
  private static final int ENTRY_BYTES = 48;
  private static final int MAX_ENTRIES = 1 << 25;

  private long[] entries = new long[64 * ENTRY_LONGS];
  private int count;

  /** Whether a table begins at an offset, compressed or not. */
  static boolean isThere(RecordingFile file, long offset) throws IOException {
    byte[] start = file.read(offset, 12);
    if (start.length < 8) {
      return false;
    }
    int first = LittleEndian.getInt(start, 0);
    return first == Aedat4Compression.LZ4_MAGIC
        || first == Aedat4Compression.ZSTD_MAGIC
        || FlatTable.identifier(start, 0, start.length).equals(IDENTIFIER);
  }

  /** Adds a packet, unless the table is full. */
  void add(int stream, long payloadOffset, int size, int events, long firstUs, long lastUs) {
    if (count == MAX_ENTRIES) {
      return;
    }
    int at = count++ * ENTRY_LONGS;
    if (at == entries.length) {
      entries = Arrays.copyOf(entries, 2 * at);
    }
    entries[at] = payloadOffset;
    entries[at + 1] = size;
    entries[at + 2] = events;
    entries[at + 3] = firstUs;
    entries[at + 4] = lastUs;
    entries[at + 5] = stream;
  }

  /** The table as a size-prefixed buffer, in DV's layout. */
  byte[] toBytes() {
    int tables = (44 + 4 * count + 7) / 8 * 8;
    int length = tables + ENTRY_BYTES * count;
    byte[] bytes = new byte[4 + length];
    LittleEndian.putInt(bytes, 0, length);
    LittleEndian.putInt(bytes, 4, 16);
    System.arraycopy(IDENTIFIER.getBytes(StandardCharsets.ISO_8859_1), 0, bytes, 8, 4);
    putShorts(bytes, 4 + 10, 6, 8, 4);
    LittleEndian.putInt(bytes, 4 + 16, 6);
    LittleEndian.putInt(bytes, 4 + 20, 20);
    putShorts(bytes, 4 + 24, 14, ENTRY_BYTES, 12, 4, 20, 28, 36);
    LittleEndian.putInt(bytes, 4 + 40, count);
    for (int i = 0; i < count; i++) {
      int table = tables + ENTRY_BYTES * i;
      int slot = 44 + 4 * i;
      LittleEndian.putInt(bytes, 4 + slot, table - slot);
      int at = 4 + table;
      int entry = i * ENTRY_LONGS;
      LittleEndian.putInt(bytes, at, table - 24);
      LittleEndian.putInt(bytes, at + 4, (int) entries[entry + 5]);
      LittleEndian.putInt(bytes, at + 8, (int) entries[entry + 1]);
      LittleEndian.putLong(bytes, at + 12, entries[entry]);
      LittleEndian.putLong(bytes, at + 20, entries[entry + 2]);
      LittleEndian.putLong(bytes, at + 28, entries[entry + 3]);
      LittleEndian.putLong(bytes, at + 36, entries[entry + 4]);
    }
    return bytes;
  }

  private static void putShorts(byte[] bytes, int at, int... values) {
    for (int i = 0; i < values.length; i++) {
      LittleEndian.putShort(bytes, at + 2 * i, values[i]);
    }
  }
}
