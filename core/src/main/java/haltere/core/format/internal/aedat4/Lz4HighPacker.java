package haltere.core.format.internal.aedat4;

import haltere.core.format.internal.packed.LittleEndian;
import java.util.Arrays;

/**
 * Packs any bytes into LZ4 blocks, slowly and as small as it can: it looks for the longest match at
 * every byte, and from the end to the start chooses what costs least.
 *
 * <p>Thread rule: one thread.
 */
final class Lz4HighPacker {
  private static final int HASH_BITS = 16;
  private static final long PRIME = 0x9E3779B97F4A7C15L;
  private static final int MAX_OFFSET = 65_535;
  private static final int MIN_MATCH = 4;

  /** So many of the places where the same bytes were are tried. */
  private static final int TRIES = 64;

  /** Places where so many bytes are the same are tried too: a pixel with a part of the time. */
  private static final int EVENT_MATCH = 7;

  /** The format wants these at the end as they are, and the last match to start before those. */
  private static final int LAST_LITERALS = 5;

  private static final int LAST_START = 12;

  /** A token has room for these; what is longer needs further bytes. */
  private static final int SHORT_LITERALS = 15;

  private static final int SHORT_MATCH = SHORT_LITERALS + MIN_MATCH;

  /** Beyond this a match is taken whole. */
  private static final int LONG_MATCH = 512;

  /** What a token and a distance cost. */
  private static final int MATCH_COST = 3;

  private final int[] newest = new int[1 << HASH_BITS];
  private int[] older = new int[0];
  private int[] lengths = new int[0];
  private int[] offsets = new int[0];
  private int[] costs = new int[0];

  /**
   * Packs a block that refers to nothing outside of it.
   *
   * @param in what to pack
   * @param from its start
   * @param to its end
   * @param out receives the block; holds at least {@link Lz4Packer#bound} bytes from there
   * @param start where
   * @return end of the block
   */
  int pack(byte[] in, int from, int to, byte[] out, int start) {
    int size = to - from;
    if (lengths.length < size) {
      older = new int[size];
      lengths = new int[size];
      offsets = new int[size];
      costs = new int[size + 1];
    }
    Arrays.fill(lengths, 0, size, 0);
    findMatches(in, from, size, MIN_MATCH, TRIES);
    findMatches(in, from, size, EVENT_MATCH, TRIES);
    choose(size);
    return write(in, from, size, out, start);
  }

  /** Looks at the places where the same bytes were, so many of them, and keeps what is longer. */
  private void findMatches(byte[] in, int from, int size, int sameBytes, int tries) {
    Arrays.fill(newest, -1);
    int end = size - LAST_LITERALS;
    for (int i = 0; i <= size - LAST_START; i++) {
      long same = LittleEndian.getLong(in, from + i) << Long.SIZE - 8 * sameBytes;
      int hash = (int) (same * PRIME >>> Long.SIZE - HASH_BITS);
      int place = newest[hash];
      older[i] = place;
      newest[hash] = i;
      int best = Math.max(MIN_MATCH - 1, lengths[i]);
      for (int left = tries; place >= 0 && i - place <= MAX_OFFSET && left > 0; left--) {
        if (i + best < end && in[from + place + best] == in[from + i + best]) {
          int length = alike(in, from + place, from + i, from + end);
          if (length > best) {
            best = length;
            lengths[i] = length;
            offsets[i] = i - place;
          }
        }
        place = older[place];
      }
    }
  }

  private static int alike(byte[] in, int earlier, int later, int end) {
    int length = 0;
    while (later + length + Long.BYTES <= end) {
      long differ =
          LittleEndian.getLong(in, earlier + length) ^ LittleEndian.getLong(in, later + length);
      if (differ != 0) {
        return length + (Long.numberOfTrailingZeros(differ) >>> 3);
      }
      length += Long.BYTES;
    }
    while (later + length < end && in[earlier + length] == in[later + length]) {
      length++;
    }
    return length;
  }

  /** From now on the lengths are those to use: 0 for a byte as it is. */
  private void choose(int size) {
    costs[size] = 0;
    int literals = 0;
    for (int i = size - 1; i >= 0; i--) {
      int longest = lengths[i];
      int least = costs[i + 1] + 1 + (literals % 255 == SHORT_LITERALS - 1 ? 1 : 0);
      int chosen = 0;
      int shortest = longest > LONG_MATCH ? longest : MIN_MATCH;
      for (int length = longest; length >= shortest; length--) {
        int beyond = length < SHORT_MATCH ? 0 : 1 + (length - SHORT_MATCH) / 255;
        int cost = costs[i + length] + MATCH_COST + beyond;
        if (cost < least) {
          least = cost;
          chosen = length;
        }
      }
      costs[i] = least;
      lengths[i] = chosen;
      literals = chosen == 0 ? literals + 1 : 0;
    }
  }

  private int write(byte[] in, int from, int size, byte[] out, int start) {
    int at = start;
    int literalsFrom = 0;
    int i = 0;
    while (i < size) {
      int length = lengths[i];
      if (length == 0) {
        i++;
        continue;
      }
      int rest = length - MIN_MATCH;
      at = literals(in, from + literalsFrom, i - literalsFrom, Math.min(15, rest), out, at);
      LittleEndian.putShort(out, at, offsets[i]);
      at += 2;
      if (rest >= 15) {
        at = beyond(rest - 15, out, at);
      }
      i += length;
      literalsFrom = i;
    }
    return literals(in, from + literalsFrom, size - literalsFrom, 0, out, at);
  }

  private static int literals(byte[] in, int from, int count, int match, byte[] out, int token) {
    out[token] = (byte) (Math.min(SHORT_LITERALS, count) << 4 | match);
    int at = token + 1;
    if (count >= SHORT_LITERALS) {
      at = beyond(count - SHORT_LITERALS, out, at);
    }
    System.arraycopy(in, from, out, at, count);
    return at + count;
  }

  private static int beyond(int length, byte[] out, int from) {
    int at = from;
    int left = length;
    for (; left >= 255; left -= 255) {
      out[at++] = (byte) 255;
    }
    out[at++] = (byte) left;
    return at;
  }
}
