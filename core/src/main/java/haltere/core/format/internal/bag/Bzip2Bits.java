package haltere.core.format.internal.bag;

import haltere.core.format.internal.packed.DamagedPacketException;
import haltere.core.format.internal.packed.FileWindow;
import java.io.IOException;

/**
 * The bits of a stretch of a file, the highest of each byte first.
 *
 * <p>Thread rule: one thread.
 */
final class Bzip2Bits {
  /** Checksums of single bytes, polynomial 0x04c11db7, highest bit first. */
  static final int[] CRC = new int[256];

  static {
    for (int i = 0; i < CRC.length; i++) {
      int value = i << 24;
      for (int bit = 0; bit < 8; bit++) {
        value = value << 1 ^ (value < 0 ? 0x04c11db7 : 0);
      }
      CRC[i] = value;
    }
  }

  private static final int AHEAD = 4096;

  private final FileWindow window;
  private long next;
  private long end;
  private byte[] bytes;
  private int at;
  private int to;
  private long held;
  private int count;

  Bzip2Bits(FileWindow window) {
    this.window = window;
  }

  void open(long offset, long size) {
    next = offset;
    end = offset + size;
    at = 0;
    to = 0;
    held = 0;
    count = 0;
  }

  /** The next bits, 1 to 24 of them, as a number. */
  int take(int bits) throws IOException, DamagedPacketException {
    int value = peek(bits);
    drop(bits);
    return value;
  }

  /** The next bits without passing over them; behind the end there are zeros. */
  int peek(int bits) throws IOException {
    while (count < bits) {
      if (at == to) {
        fill();
      }
      held = held << 8 | (at < to ? bytes[at] & 0xff : 0);
      at++;
      count += 8;
    }
    return (int) (held >>> count - bits) & (1 << bits) - 1;
  }

  /** Passes over bits that were looked at. */
  void drop(int bits) throws DamagedPacketException {
    count -= bits;
    if (at > to && at - to > count >>> 3) {
      throw new DamagedPacketException("a bzip2 stream that ends too early");
    }
  }

  private void fill() throws IOException {
    int wanted = (int) Math.min(AHEAD, end - next);
    int start = wanted <= 0 ? -1 : window.require(next, wanted);
    if (start < 0) {
      return;
    }
    bytes = window.bytes();
    at = start;
    to = start + wanted;
    next += wanted;
  }
}
