package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.DamagedPacketException;

/** SQLite's variable-length integers of 1 to 9 bytes: 7 bits a byte, the ninth has 8. */
final class SqliteVarint {
  private static final int MAX_BYTES = 9;

  /** Source of single bytes. */
  @FunctionalInterface
  interface Bytes {
    /** Reads the next byte. */
    byte take() throws DamagedPacketException;
  }

  private SqliteVarint() {}

  static long take(Bytes bytes) throws DamagedPacketException {
    long value = 0;
    for (int i = 1; i < MAX_BYTES; i++) {
      int next = bytes.take();
      value = value << 7 | next & 0x7f;
      if (next >= 0) {
        return value;
      }
    }
    return value << 8 | bytes.take() & 0xff;
  }
}
