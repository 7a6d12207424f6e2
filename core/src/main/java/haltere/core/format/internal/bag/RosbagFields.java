package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.LittleEndian;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * The fields of a ROS 1 record's header: each has its length, its name, {@code =} and its value.
 */
final class RosbagFields {
  private final byte[] data;
  private final int from;
  private final int to;

  /** Fields in a part of an array; damaged ones are ignored. */
  RosbagFields(byte[] data, int from, int to) {
    this.data = data;
    this.from = from;
    this.to = to;
  }

  /** Index of a field's value of a length (-1 for any), or -1 if there is none. */
  private int find(String name, int bytes) {
    int at = from;
    while (to - at >= 4) {
      int length = LittleEndian.getInt(data, at);
      at += 4;
      if (length < 0 || length > to - at) {
        return -1;
      }
      int value = at + name.length() + 1;
      if (value <= at + length && data[value - 1] == '=' && isNamed(name, at)) {
        return bytes < 0 || at + length - value == bytes ? value : -1;
      }
      at += length;
    }
    return -1;
  }

  private boolean isNamed(String name, int at) {
    for (int i = 0; i < name.length(); i++) {
      if (data[at + i] != name.charAt(i)) {
        return false;
      }
    }
    return true;
  }

  /** A field of one byte, or -1. */
  int getByte(String name) {
    int at = find(name, 1);
    return at < 0 ? -1 : data[at] & 0xff;
  }

  /** A field of four bytes, or -1. */
  long getUnsignedInt(String name) {
    int at = find(name, 4);
    return at < 0 ? -1 : LittleEndian.getInt(data, at) & 0xffff_ffffL;
  }

  /** A field of eight bytes, or -1. */
  long getLong(String name) {
    int at = find(name, 8);
    return at < 0 ? -1 : LittleEndian.getLong(data, at);
  }

  /** A time in nanoseconds, or -1. */
  long getTimeNs(String name) {
    long bits = getLong(name);
    return bits == -1 ? -1 : (bits & 0xffff_ffffL) * 1_000_000_000 + (bits >>> 32);
  }

  /** A text, or an empty one. */
  String getText(String name) {
    int at = find(name, -1);
    if (at < 0) {
      return "";
    }
    int length = LittleEndian.getInt(data, at - name.length() - 1 - 4) - name.length() - 1;
    return new String(Arrays.copyOfRange(data, at, at + length), StandardCharsets.UTF_8);
  }
}
