package haltere.core.format.internal.hdf5;

import haltere.core.format.RecordingProblem;
import java.util.ArrayList;
import java.util.List;

/**
 * Type of the elements of a dataset or an attribute.
 *
 * @param kind {@code i} signed integer, {@code u} unsigned integer, {@code f} floating point,
 *     {@code s} text, {@code v} text in a global heap, {@code l} a list in a global heap, {@code c}
 *     compound, {@code -} anything else
 * @param bytes size of an element
 * @param bigEndian whether its first byte is the highest
 * @param members of a compound; of a list, its elements as the only member
 */
record ElementType(char kind, int bytes, boolean bigEndian, List<Member> members) {
  private static final int MAX_MEMBERS = 256;
  private static final int MAX_DEPTH = 8;
  private static final int MAX_BYTES = 1 << 16;

  /**
   * A member of a compound.
   *
   * @param name its name
   * @param offset in the element
   * @param type its type
   */
  record Member(String name, int offset, ElementType type) {}

  /** A little-endian integer. */
  static ElementType whole(int bytes, boolean signed) {
    return number(signed ? 'i' : 'u', bytes, false);
  }

  /** A little-endian floating-point number of 4 or 8 bytes. */
  static ElementType real(int bytes) {
    return number('f', bytes, false);
  }

  static ElementType read(Metadata body) throws RecordingProblem {
    return read(body, MAX_DEPTH);
  }

  private static ElementType read(Metadata body, int depth) throws RecordingProblem {
    int head = body.u1();
    int version = head >> 4;
    int bits = body.u1();
    int moreBits = body.u2();
    long size = body.u4();
    if (depth == 0 || size > Integer.MAX_VALUE) {
      throw body.problem("a type that cannot be");
    }
    int bytes = (int) size;
    boolean bigEndian = (bits & 1) != 0;
    switch (head & 15) {
      case 0:
        int bitOffset = body.u2();
        boolean whole = bitOffset == 0 && body.u2() == 8 * size;
        return number(whole ? (bits & 8) != 0 ? 'i' : 'u' : '-', bytes, bigEndian);
      case 1:
        body.skip(12);
        return number((bits & 0x40) == 0 ? 'f' : '-', bytes, bigEndian);
      case 3:
        return number('s', bytes, false);
      case 4:
        body.skip(4);
        return number('-', bytes, false);
      case 5:
        body.skip(bits);
        return number('-', bytes, false);
      case 6:
        return compound(body, version, bits | (moreBits & 0xff) << 8, bytes, depth);
      case 8:
        return enumeration(body, version, bits | (moreBits & 0xff) << 8, depth);
      case 9:
        ElementType base = read(body, depth - 1);
        return (bits & 15) == 1
            ? number('v', bytes, false)
            : new ElementType('l', bytes, false, List.of(new Member("", 0, base)));
      case 10:
        int dimensions = body.u1();
        body.skip(version < 3 ? 3 + 8L * dimensions : 4L * dimensions);
        read(body, depth - 1);
        return number('-', bytes, false);
      default:
        return number('-', bytes, false);
    }
  }

  private static ElementType number(char kind, int bytes, boolean bigEndian) {
    return new ElementType(kind, bytes, bigEndian, List.of());
  }

  private static ElementType compound(Metadata body, int version, int count, int bytes, int depth)
      throws RecordingProblem {
    if (count > MAX_MEMBERS || bytes > MAX_BYTES) {
      throw body.problem("a type of " + count + " members and " + bytes + " bytes");
    }
    List<Member> members = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      String name = name(body, version);
      int offsetBytes =
          version < 3 || bytes > 0xffffff ? 4 : bytes > 0xffff ? 3 : bytes > 0xff ? 2 : 1;
      long offset = body.number(offsetBytes);
      int dimensions = 0;
      if (version == 1) {
        dimensions = body.u1();
        body.skip(3 + 4 + 4 + 16);
      }
      ElementType type = read(body, depth - 1);
      if (offset + type.bytes() > bytes) {
        throw body.problem("a member outside of its type");
      }
      members.add(
          new Member(
              name, (int) offset, dimensions == 0 ? type : number('-', type.bytes(), false)));
    }
    return new ElementType('c', bytes, false, List.copyOf(members));
  }

  private static String name(Metadata body, int version) throws RecordingProblem {
    long start = body.offset();
    String name = body.textToZero();
    if (version < 3) {
      body.skip((8 - (body.offset() - start) % 8) % 8);
    }
    return name;
  }

  /** A NumPy boolean is an enumeration of two names. */
  private static ElementType enumeration(Metadata body, int version, int count, int depth)
      throws RecordingProblem {
    ElementType base = read(body, depth - 1);
    for (int i = 0; i < count; i++) {
      name(body, version);
    }
    body.skip((long) count * base.bytes());
    return base;
  }

  /** Whether it is a supported number. */
  boolean isNumber() {
    return switch (kind) {
      case 'i', 'u' -> bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
      case 'f' -> bytes == 4 || bytes == 8;
      default -> false;
    };
  }
}
