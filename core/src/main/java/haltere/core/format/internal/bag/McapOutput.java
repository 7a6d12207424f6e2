package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.LittleEndian;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Composes records of an MCAP file: little-endian numbers, length-prefixed texts. */
final class McapOutput {
  private byte[] bytes = new byte[4096];
  private int size;

  byte[] bytes() {
    return bytes;
  }

  int size() {
    return size;
  }

  void clear() {
    size = 0;
  }

  /** Reserves space for bytes; returns its index. */
  int grow(int count) {
    if (count > bytes.length - size) {
      bytes = Arrays.copyOf(bytes, Math.max(size + count, 2 * bytes.length));
    }
    int at = size;
    size += count;
    return at;
  }

  McapOutput u8(int value) {
    int at = grow(1);
    bytes[at] = (byte) value;
    return this;
  }

  McapOutput u16(int value) {
    int at = grow(2);
    LittleEndian.putShort(bytes, at, value);
    return this;
  }

  McapOutput u32(long value) {
    int at = grow(4);
    LittleEndian.putInt(bytes, at, (int) value);
    return this;
  }

  McapOutput u64(long value) {
    int at = grow(8);
    LittleEndian.putLong(bytes, at, value);
    return this;
  }

  McapOutput text(String text) {
    byte[] utf = text.getBytes(StandardCharsets.UTF_8);
    return u32(utf.length).raw(utf, utf.length);
  }

  McapOutput raw(byte[] data, int count) {
    int at = grow(count);
    System.arraycopy(data, 0, bytes, at, count);
    return this;
  }

  /** Starts a record; returns the index of its length. */
  int start(int kind) {
    u8(kind);
    return grow(8);
  }

  /** Ends the record with its length at an index. */
  McapOutput end(int lengthAt) {
    LittleEndian.putLong(bytes, lengthAt, size - lengthAt - 8L);
    return this;
  }
}
