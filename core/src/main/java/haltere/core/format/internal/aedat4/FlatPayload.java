package haltere.core.format.internal.aedat4;

import haltere.core.format.internal.compression.LittleEndian;
import java.nio.charset.StandardCharsets;

/** Parts of a size-prefixed FlatBuffer. Positions are relative to the size. */
final class FlatPayload {
  private FlatPayload() {}

  /** A buffer with only the size and the four-letter identifier. */
  static byte[] start(String identifier, int length) {
    byte[] bytes = new byte[(length + 3) & -4];
    LittleEndian.putInt(bytes, 0, bytes.length - 4);
    System.arraycopy(identifier.getBytes(StandardCharsets.ISO_8859_1), 0, bytes, 8, 4);
    return bytes;
  }

  /** Writes the layout of tables: the offset of each field in a table, 0 for a missing one. */
  static void putLayout(byte[] bytes, int at, int tableBytes, int... offsets) {
    LittleEndian.putShort(bytes, at, 4 + 2 * offsets.length);
    LittleEndian.putShort(bytes, at + 2, tableBytes);
    for (int i = 0; i < offsets.length; i++) {
      LittleEndian.putShort(bytes, at + 4 + 2 * i, offsets[i]);
    }
  }
}
