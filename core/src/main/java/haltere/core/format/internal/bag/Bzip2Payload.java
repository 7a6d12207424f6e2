package haltere.core.format.internal.bag;

import haltere.core.format.internal.packed.DamagedPacketException;
import haltere.core.format.internal.packed.FileWindow;
import haltere.core.format.internal.packed.Payload;
import java.io.IOException;
import java.util.Arrays;

/**
 * A payload that is one bzip2 stream. Each block is checked before a byte of it is given out, and
 * given out piece by piece, since runs make it as large as 46 MB.
 *
 * <p>Why our own: the only library for the JVM that is kept well brings three others with it.
 */
final class Bzip2Payload extends Payload {
  private static final int PIECE = 256 * 1024;
  private static final int LEVEL_BYTES = 100_000;
  private static final int BLOCK_HIGH = 0x314159;
  private static final int BLOCK_LOW = 0x265359;
  private static final int END_HIGH = 0x177245;
  private static final int END_LOW = 0x385090;

  /** So many equal bytes, and the next tells how many more there are. */
  private static final int RUN = 4;

  private final Bzip2Bits bits;
  private final Bzip2Block block = new Bzip2Block();
  private int largest;
  private boolean ended;

  private int left;
  private int next;
  private int last;
  private int equal;
  private int repeats;

  Bzip2Payload(FileWindow window) {
    bits = new Bzip2Bits(window);
  }

  @Override
  public void open(long offset, long size) throws IOException, DamagedPacketException {
    bits.open(offset, size);
    from = 0;
    to = 0;
    ended = false;
    left = 0;
    repeats = 0;
    int magic = bits.take(24);
    int level = bits.take(8) - '0';
    if (magic != ('B' << 16 | 'Z' << 8 | 'h') || level < 1 || level > 9) {
      throw new DamagedPacketException("no bzip2 stream");
    }
    largest = level * LEVEL_BYTES;
  }

  @Override
  public boolean more() throws IOException, DamagedPacketException {
    if (ended) {
      return false;
    }
    System.arraycopy(data, from, data, 0, to - from);
    to -= from;
    from = 0;
    if (data.length - to < PIECE) {
      data = Arrays.copyOf(data, to + PIECE);
    }
    if (left == 0 && repeats == 0) {
      int high = bits.take(24);
      int low = bits.take(24);
      if (high == END_HIGH && low == END_LOW) {
        ended = true;
        return false;
      }
      if (high != BLOCK_HIGH || low != BLOCK_LOW) {
        throw new DamagedPacketException("no bzip2 block");
      }
      int checksum = bits.take(16) << 16 | bits.take(16);
      block.read(bits, largest);
      check(checksum);
      rewind();
    }
    to = fill(data, to, to + PIECE);
    return true;
  }

  private void rewind() {
    left = block.size();
    next = block.first();
    last = -1;
    equal = 0;
    repeats = 0;
  }

  /** Unpacks the block once without keeping anything. */
  private void check(int checksum) throws DamagedPacketException {
    rewind();
    byte[] piece = new byte[4096];
    int crc = -1;
    while (left > 0 || repeats > 0) {
      int end = fill(piece, 0, piece.length);
      for (int i = 0; i < end; i++) {
        crc = crc << 8 ^ Bzip2Bits.CRC[crc >>> 24 ^ piece[i] & 0xff];
      }
    }
    if (~crc != checksum) {
      throw new DamagedPacketException("a bzip2 block whose checksum is another");
    }
  }

  /** Puts the next bytes of the block into an array; returns where they end. */
  private int fill(byte[] out, int start, int end) {
    int at = start;
    int[] links = block.links();
    while (at < end) {
      if (repeats > 0) {
        int count = Math.min(repeats, end - at);
        Arrays.fill(out, at, at + count, (byte) last);
        at += count;
        repeats -= count;
        continue;
      }
      if (left == 0) {
        break;
      }
      int value = links[next] & 0xff;
      next = links[next] >>> 8;
      left--;
      if (equal == RUN) {
        repeats = value;
        equal = 0;
        continue;
      }
      equal = value == last ? equal + 1 : 1;
      last = value;
      out[at++] = (byte) value;
    }
    return at;
  }
}
