package haltere.core.format.internal.bag;

import haltere.core.format.internal.packed.DamagedPacketException;
import java.io.IOException;
import java.util.Arrays;

/**
 * A block of a bzip2 stream: reads its codes and undoes its sorting. The bytes that come out are
 * linked in a list: each entry has a byte and, above it, the index of the next entry.
 */
final class Bzip2Block {
  private static final int MAX_TABLES = 6;
  private static final int MAX_LENGTH = 20;
  private static final int GROUP = 50;
  private static final int MAX_SELECTORS = 18_002;
  private static final int MAX_SYMBOLS = 258;

  private final int[][] limits = new int[MAX_TABLES][MAX_LENGTH + 2];
  private final int[][] bases = new int[MAX_TABLES][MAX_LENGTH + 2];
  private final int[][] symbols = new int[MAX_TABLES][MAX_SYMBOLS];
  private final int[] shortest = new int[MAX_TABLES];
  private final byte[] selectors = new byte[MAX_SELECTORS];
  private final byte[] used = new byte[256];
  private final byte[] recent = new byte[256];
  private final int[] counts = new int[257];
  private int[] links = new int[0];
  private int size;
  private int first;

  /** Entries of the block. */
  int size() {
    return size;
  }

  /** Index of the first byte's entry. */
  int first() {
    return first;
  }

  int[] links() {
    return links;
  }

  /** Reads a block, behind its checksum. */
  void read(Bzip2Bits bits, int largest) throws IOException, DamagedPacketException {
    if (bits.take(1) != 0) {
      throw new DamagedPacketException("a bzip2 block of a kind that nobody writes");
    }
    int origin = bits.take(24);
    if (links.length < largest) {
      links = new int[largest];
    }
    int usedCount = readUsed(bits);
    int tables = bits.take(3);
    int selectorCount = bits.take(15);
    if (usedCount == 0 || tables < 2 || tables > MAX_TABLES || selectorCount == 0) {
      throw new DamagedPacketException("a bzip2 block without codes");
    }
    readSelectors(bits, tables, selectorCount);
    for (int table = 0; table < tables; table++) {
      readTable(bits, table, usedCount + 2);
    }
    readSymbols(bits, usedCount, Math.min(selectorCount, MAX_SELECTORS), largest);
    if (origin >= size) {
      throw new DamagedPacketException("a bzip2 block that starts outside of itself");
    }
    link();
    first = links[origin] >>> 8;
  }

  private int readUsed(Bzip2Bits bits) throws IOException, DamagedPacketException {
    int groups = bits.take(16);
    int count = 0;
    for (int group = 0; group < 16; group++) {
      if ((groups >>> 15 - group & 1) == 0) {
        continue;
      }
      int members = bits.take(16);
      for (int i = 0; i < 16; i++) {
        if ((members >>> 15 - i & 1) != 0) {
          used[count++] = (byte) (group << 4 | i);
        }
      }
    }
    return count;
  }

  private void readSelectors(Bzip2Bits bits, int tables, int count)
      throws IOException, DamagedPacketException {
    byte[] order = {0, 1, 2, 3, 4, 5};
    for (int i = 0; i < count; i++) {
      int place = 0;
      while (bits.take(1) != 0) {
        if (++place >= tables) {
          throw new DamagedPacketException("a bzip2 block with a table too many");
        }
      }
      byte table = order[place];
      System.arraycopy(order, 0, order, 1, place);
      order[0] = table;
      if (i < MAX_SELECTORS) {
        selectors[i] = table;
      }
    }
  }

  private void readTable(Bzip2Bits bits, int table, int symbolCount)
      throws IOException, DamagedPacketException {
    int[] lengths = new int[symbolCount];
    int length = bits.take(5);
    for (int i = 0; i < symbolCount; i++) {
      while (true) {
        if (length < 1 || length > MAX_LENGTH) {
          throw new DamagedPacketException("a bzip2 code of impossible length");
        }
        if (bits.take(1) == 0) {
          break;
        }
        length += bits.take(1) == 0 ? 1 : -1;
      }
      lengths[i] = length;
    }
    int[] limit = limits[table];
    int[] base = bases[table];
    int code = 0;
    int index = 0;
    shortest[table] = Arrays.stream(lengths).min().orElseThrow();
    for (int bitCount = 1; bitCount <= MAX_LENGTH; bitCount++) {
      base[bitCount] = index - code;
      for (int i = 0; i < symbolCount; i++) {
        if (lengths[i] == bitCount) {
          symbols[table][index++] = i;
          code++;
        }
      }
      // Codes of this length are below the limit; longer ones continue from there.
      limit[bitCount] = code;
      code <<= 1;
    }
  }

  private int symbol(Bzip2Bits bits, int table) throws IOException, DamagedPacketException {
    int word = bits.peek(MAX_LENGTH);
    int[] limit = limits[table];
    for (int length = shortest[table]; length <= MAX_LENGTH; length++) {
      int code = word >>> MAX_LENGTH - length;
      if (code < limit[length]) {
        bits.drop(length);
        int index = code + bases[table][length];
        if (index < 0 || index >= MAX_SYMBOLS) {
          break;
        }
        return symbols[table][index];
      }
    }
    throw new DamagedPacketException("a bzip2 code without a meaning");
  }

  /** Reads the codes: places in a list of recent bytes, with runs of the first place. */
  private void readSymbols(Bzip2Bits bits, int usedCount, int selectorCount, int largest)
      throws IOException, DamagedPacketException {
    Arrays.fill(counts, 0);
    System.arraycopy(used, 0, recent, 0, usedCount);
    int end = usedCount + 1;
    int written = 0;
    int run = 0;
    int runBit = 1;
    int group = 0;
    int inGroup = 0;
    while (true) {
      if (inGroup == 0) {
        if (group == selectorCount) {
          throw new DamagedPacketException("a bzip2 block without an end");
        }
        inGroup = GROUP;
        group++;
      }
      inGroup--;
      int symbol = symbol(bits, selectors[group - 1]);
      if (symbol < 2) {
        run += runBit << symbol;
        runBit <<= 1;
        if (run > largest) {
          throw new DamagedPacketException("a bzip2 block that is too large");
        }
        continue;
      }
      if (run > 0) {
        if (run > largest - written) {
          throw new DamagedPacketException("a bzip2 block that is too large");
        }
        int value = recent[0] & 0xff;
        counts[value + 1] += run;
        Arrays.fill(links, written, written + run, value);
        written += run;
        run = 0;
        runBit = 1;
      }
      if (symbol == end) {
        break;
      }
      if (symbol > end || written == largest) {
        throw new DamagedPacketException("a bzip2 block that is too large");
      }
      int place = symbol - 1;
      byte value = recent[place];
      System.arraycopy(recent, 0, recent, 1, place);
      recent[0] = value;
      counts[(value & 0xff) + 1]++;
      links[written++] = value & 0xff;
    }
    size = written;
  }

  /** Undoes the sorting. */
  private void link() {
    for (int i = 1; i < counts.length; i++) {
      counts[i] += counts[i - 1];
    }
    for (int i = 0; i < size; i++) {
      links[counts[links[i] & 0xff]++] |= i << 8;
    }
  }
}
