package haltere.core.format.internal.aedat4;

import haltere.core.format.internal.compression.LittleEndian;
import java.nio.charset.StandardCharsets;

/** Parts of a FlatBuffer that starts with its size. Places count from that size. */
final class FlatPayload {
  private FlatPayload() {}

  /** A buffer of which only size and four letters are there. */
  static byte[] start(String identifier, int length) {
    byte[] bytes = new byte[(length + 3) & -4];
    LittleEndian.putInt(bytes, 0, bytes.length - 4);
    System.arraycopy(identifier.getBytes(StandardCharsets.ISO_8859_1), 0, bytes, 8, 4);
    return bytes;
  }

  /** The layout of tables of a size: where in a table each field is, 0 for one that is not. */
  static void putLayout(byte[] bytes, int at, int tableBytes, int... offsets) {
    LittleEndian.putShort(bytes, at, 4 + 2 * offsets.length);
    LittleEndian.putShort(bytes, at + 2, tableBytes);
    for (int i = 0; i < offsets.length; i++) {
      LittleEndian.putShort(bytes, at + 4 + 2 * i, offsets[i]);
    }
  }
}
