package haltere.core.format.internal.aedat4;

import haltere.core.format.internal.packed.LittleEndian;
import java.lang.invoke.VarHandle;

/**
 * Packs runs of 16-byte events into LZ4 blocks. It knows what it packs, and so is faster than a
 * packer of any bytes: the upper bytes of a time are those of the time before, and the pixel with
 * its polarity is that of the event before or of one that a small table remembers.
 *
 * <p>Thread rule: one thread.
 */
final class Lz4Packer {
  private static final int EVENT = Aedat4Cursor.EVENT_BYTES;
  private static final int HASH_BITS = 13;
  private static final int MAX_OFFSET = 65_535;
  private static final int MIN_MATCH = 4;
  private static final int LAST_LITERALS = 32;
  private static final long PRIME = 0x9E3779B97F4A7C15L;

  private final int[] places = new int[1 << HASH_BITS];
  private byte[] in;
  private byte[] out;
  private int literalsFrom;
  private int at;

  /** Bytes that a block needs at the worst. */
  static int bound(int bytes) {
    return bytes + bytes / 255 + 64;
  }

  /**
   * Packs a block that refers to nothing outside of it.
   *
   * @param bytes what to pack
   * @param from its start
   * @param firstEvent where the first event starts
   * @param to its end
   * @param target receives the block; holds at least {@link #bound} bytes from there
   * @param targetFrom where
   * @return end of the block
   */
  int pack(byte[] bytes, int from, int firstEvent, int to, byte[] target, int targetFrom) {
    VarHandle longs = LittleEndian.LONG;
    in = bytes;
    out = target;
    at = targetFrom;
    literalsFrom = from;
    java.util.Arrays.fill(places, -1);
    int[] table = places;
    int end = to - LAST_LITERALS;
    if (firstEvent < end) {
      remember(table, (long) longs.get(bytes, firstEvent + 8), firstEvent + 8);
    }
    for (int event = firstEvent + EVENT; event <= end; event += EVENT) {
      long time = (long) longs.get(bytes, event) ^ (long) longs.get(bytes, event - EVENT);
      long word = (long) longs.get(bytes, event + 8);
      // The bytes of the time that differ are at its lower end.
      int same = Long.numberOfLeadingZeros(time) >>> 3;
      int slot = (int) (word * PRIME >>> 64 - HASH_BITS);
      int place = table[slot];
      table[slot] = event + 8;
      boolean known = place >= 0 && (long) longs.get(bytes, place) == word;
      int distance = event + 8 - place;
      if (known && distance == EVENT) {
        match(event + 8 - same, same + 8, EVENT);
      } else if (known && distance <= MAX_OFFSET) {
        if (same >= MIN_MATCH) {
          match(event + 8 - same, same, EVENT);
        }
        match(event + 8, 8, distance);
      } else {
        long wordBefore = (long) longs.get(bytes, event + 8 - EVENT);
        int alike = Long.numberOfTrailingZeros(word ^ wordBefore) >>> 3;
        if (same + alike >= MIN_MATCH) {
          match(event + 8 - same, same + alike, EVENT);
        }
        int tail = Long.numberOfLeadingZeros(word ^ wordBefore) >>> 3;
        if (tail >= MIN_MATCH) {
          match(event + 16 - tail, tail, EVENT);
        }
      }
    }
    last(to);
    return at;
  }

  private static void remember(int[] table, long word, int place) {
    table[(int) (word * PRIME >>> 64 - HASH_BITS)] = place;
  }

  /** Writes the bytes that nothing matched so far, then a reference. */
  private void match(int place, int length, int offset) {
    int literals = place - literalsFrom;
    int rest = length - MIN_MATCH;
    int token = at++;
    if (literals < 15) {
      out[token] = (byte) (literals << 4 | Math.min(15, rest));
      LittleEndian.LONG.set(out, at, (long) LittleEndian.LONG.get(in, literalsFrom));
      LittleEndian.LONG.set(out, at + 8, (long) LittleEndian.LONG.get(in, literalsFrom + 8));
    } else {
      out[token] = (byte) (15 << 4 | Math.min(15, rest));
      length(literals - 15);
      System.arraycopy(in, literalsFrom, out, at, literals);
    }
    at += literals;
    LittleEndian.SHORT.set(out, at, (short) offset);
    at += 2;
    if (rest >= 15) {
      length(rest - 15);
    }
    literalsFrom = place + length;
  }

  private void length(int beyond) {
    int left = beyond;
    for (; left >= 255; left -= 255) {
      out[at++] = (byte) 255;
    }
    out[at++] = (byte) left;
  }

  private void last(int to) {
    int literals = to - literalsFrom;
    out[at++] = (byte) (Math.min(15, literals) << 4);
    if (literals >= 15) {
      length(literals - 15);
    }
    System.arraycopy(in, literalsFrom, out, at, literals);
    at += literals;
  }
}
