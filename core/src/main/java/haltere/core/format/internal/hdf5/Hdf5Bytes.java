package haltere.core.format.internal.hdf5;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/** Composes the structure of a file: little-endian, with positions of eight bytes. */
final class Hdf5Bytes {
  private final ByteBuffer bytes;

  /** A buffer of zeros. */
  Hdf5Bytes(int size) {
    bytes = ByteBuffer.allocate(size).order(ByteOrder.LITTLE_ENDIAN);
  }

  int position() {
    return bytes.position();
  }

  Hdf5Bytes u1(int value) {
    bytes.put((byte) value);
    return this;
  }

  Hdf5Bytes u2(int value) {
    bytes.putShort((short) value);
    return this;
  }

  Hdf5Bytes u4(long value) {
    bytes.putInt((int) value);
    return this;
  }

  Hdf5Bytes u8(long value) {
    bytes.putLong(value);
    return this;
  }

  Hdf5Bytes text(String text) {
    bytes.put(text.getBytes(StandardCharsets.US_ASCII));
    return this;
  }

  /** A zero-padded text, a multiple of eight bytes. */
  Hdf5Bytes padded(String text) {
    text(text);
    return skip(8 - text.length() % 8);
  }

  /** Zeros up to a multiple of eight, at least a number. */
  Hdf5Bytes pad(int atLeast) {
    bytes.position((bytes.position() + atLeast + 7) / 8 * 8);
    return this;
  }

  Hdf5Bytes skip(int count) {
    bytes.position(bytes.position() + count);
    return this;
  }

  void u4At(int index, long value) {
    bytes.putInt(index, (int) value);
  }

  void u2At(int index, int value) {
    bytes.putShort(index, (short) value);
  }

  void u1At(int index, int value) {
    bytes.put(index, (byte) value);
  }

  ByteBuffer whole() {
    return bytes.clear();
  }
}
