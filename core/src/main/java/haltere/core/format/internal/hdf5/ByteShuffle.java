package haltere.core.format.internal.hdf5;

import haltere.core.format.internal.compression.LittleEndian;

/**
 * Reverses the shuffle filter: bytes (or bits) that are grouped by their position in the element,
 * eight elements at a time.
 */
final class ByteShuffle {
  private static final long BYTES = 0x00ff00ff00ff00ffL;
  private static final long PAIRS = 0x0000ffff0000ffffL;
  private static final long FOURS = 0x00000000ffffffffL;

  private ByteShuffle() {}

  /** Unshuffles bytes; an incomplete element at the end is copied. */
  static void undo(byte[] in, int from, byte[] out, int outFrom, int length, int size) {
    int elements = size < 1 ? 0 : length / size;
    switch (size) {
      case 0, 1 -> System.arraycopy(in, from, out, outFrom, length);
      case 2 -> undoTwo(in, from, out, outFrom, elements);
      case 8 -> undoEight(in, from, out, outFrom, elements);
      default -> undoAny(in, from, out, outFrom, 0, elements, elements, size);
    }
    if (size > 1) {
      int done = elements * size;
      System.arraycopy(in, from + done, out, outFrom + done, length - done);
    }
  }

  private static void undoAny(
      byte[] in, int from, byte[] out, int outFrom, int first, int last, int elements, int size) {
    for (int k = 0; k < size; k++) {
      int source = from + k * elements;
      int target = outFrom + k + first * size;
      for (int i = first; i < last; i++) {
        out[target] = in[source + i];
        target += size;
      }
    }
  }

  private static void undoTwo(byte[] in, int from, byte[] out, int outFrom, int elements) {
    int whole = elements & ~3;
    for (int i = 0; i < whole; i += 4) {
      long low = spread(LittleEndian.getInt(in, from + i));
      long high = spread(LittleEndian.getInt(in, from + elements + i));
      LittleEndian.putLong(out, outFrom + 2 * i, low | high << 8);
    }
    undoAny(in, from, out, outFrom, whole, elements, elements, 2);
  }

  private static long spread(int bytes) {
    long wide = bytes & FOURS;
    wide = (wide | wide << 16) & PAIRS;
    return (wide | wide << 8) & BYTES;
  }

  private static void undoEight(byte[] in, int from, byte[] out, int outFrom, int elements) {
    int whole = elements & ~7;
    for (int i = 0; i < whole; i += 8) {
      int at = from + i;
      long a = LittleEndian.getLong(in, at);
      long b = LittleEndian.getLong(in, at + elements);
      long c = LittleEndian.getLong(in, at + 2 * elements);
      long d = LittleEndian.getLong(in, at + 3 * elements);
      long e = LittleEndian.getLong(in, at + 4 * elements);
      long f = LittleEndian.getLong(in, at + 5 * elements);
      long g = LittleEndian.getLong(in, at + 6 * elements);
      long h = LittleEndian.getLong(in, at + 7 * elements);
      long swap = (a >>> 8 ^ b) & BYTES;
      b ^= swap;
      a ^= swap << 8;
      swap = (c >>> 8 ^ d) & BYTES;
      d ^= swap;
      c ^= swap << 8;
      swap = (e >>> 8 ^ f) & BYTES;
      f ^= swap;
      e ^= swap << 8;
      swap = (g >>> 8 ^ h) & BYTES;
      h ^= swap;
      g ^= swap << 8;
      swap = (a >>> 16 ^ c) & PAIRS;
      c ^= swap;
      a ^= swap << 16;
      swap = (b >>> 16 ^ d) & PAIRS;
      d ^= swap;
      b ^= swap << 16;
      swap = (e >>> 16 ^ g) & PAIRS;
      g ^= swap;
      e ^= swap << 16;
      swap = (f >>> 16 ^ h) & PAIRS;
      h ^= swap;
      f ^= swap << 16;
      int to = outFrom + 8 * i;
      LittleEndian.putLong(out, to, a & FOURS | e << 32);
      LittleEndian.putLong(out, to + 8, b & FOURS | f << 32);
      LittleEndian.putLong(out, to + 16, c & FOURS | g << 32);
      LittleEndian.putLong(out, to + 24, d & FOURS | h << 32);
      LittleEndian.putLong(out, to + 32, a >>> 32 | e & ~FOURS);
      LittleEndian.putLong(out, to + 40, b >>> 32 | f & ~FOURS);
      LittleEndian.putLong(out, to + 48, c >>> 32 | g & ~FOURS);
      LittleEndian.putLong(out, to + 56, d >>> 32 | h & ~FOURS);
    }
    undoAny(in, from, out, outFrom, whole, elements, elements, 8);
  }

  /** Unshuffles bits; they are shuffled only if the number of elements is a multiple of eight. */
  static void undoBits(byte[] in, int from, byte[] out, int outFrom, int length, int size) {
    int groups = size < 1 || length / size % 8 != 0 ? 0 : length / size / 8;
    for (int k = 0; k < size && groups > 0; k++) {
      for (int g = 0; g < groups; g++) {
        long rows = 0;
        for (int bit = 7; bit >= 0; bit--) {
          rows = rows << 8 | in[from + (8 * k + bit) * groups + g] & 0xff;
        }
        long bytes = transposed(rows);
        for (int j = 0; j < 8; j++) {
          out[outFrom + (8 * g + j) * size + k] = (byte) (bytes >>> 8 * j);
        }
      }
    }
    int done = groups * 8 * size;
    System.arraycopy(in, from + done, out, outFrom + done, length - done);
  }

  /** Transposes eight rows of eight bits, the first row and bit lowest. */
  private static long transposed(long rows) {
    long x = rows;
    long swap = (x ^ x >>> 7) & 0x00AA00AA00AA00AAL;
    x ^= swap ^ swap << 7;
    swap = (x ^ x >>> 14) & 0x0000CCCC0000CCCCL;
    x ^= swap ^ swap << 14;
    swap = (x ^ x >>> 28) & 0x00000000F0F0F0F0L;
    return x ^ swap ^ swap << 28;
  }

  /** Shuffles bytes: groups them by their position in the element. */
  static void apply(byte[] in, byte[] out, int length, int size) {
    int elements = length / size;
    int whole = size == 2 ? elements & ~3 : 0;
    for (int i = 0; i < whole; i += 4) {
      long four = LittleEndian.getLong(in, 2 * i);
      LittleEndian.putInt(out, i, (int) gathered(four));
      LittleEndian.putInt(out, elements + i, (int) gathered(four >>> 8));
    }
    for (int k = 0; k < size; k++) {
      int target = k * elements;
      int source = k + whole * size;
      for (int i = whole; i < elements; i++) {
        out[target + i] = in[source];
        source += size;
      }
    }
  }

  /** Every other byte of eight, the first of them first. */
  private static long gathered(long eight) {
    long wide = eight & BYTES;
    wide = (wide | wide >>> 8) & PAIRS;
    return (wide | wide >>> 16) & FOURS;
  }
}
