package haltere.core.format.internal.compression;

import java.io.IOException;
import java.util.Arrays;

/** A payload that is an LZ4 frame, decompressed block by block. */
public final class Lz4Payload extends Payload {
  private static final int VERSION_MASK = 0xC0;
  private static final int VERSION = 0x40;
  private static final int INDEPENDENT = 0x20;
  private static final int BLOCK_CHECKSUM = 0x10;
  private static final int CONTENT_SIZE = 0x08;
  private static final int DICTIONARY = 0x01;
  private static final int STORED = 0x8000_0000;
  private static final int LONG_LITERALS = 15;

  /** Maximum distance of a reference. */
  private static final int MAX_OFFSET = 65_535;

  private static final int ROOM = 256 * 1024;

  private final FileWindow window;
  private long next;
  private long end;
  private int flags;
  private int blockBytes;
  private int frameStart;
  private boolean ended;
  private byte[] sequence = new byte[0];

  /**
   * A payload, not yet opened.
   *
   * @param window over the file
   */
  public Lz4Payload(FileWindow window) {
    this.window = window;
  }

  @Override
  public void open(long offset, long size) throws IOException, DamagedPacketException {
    next = offset;
    end = offset + size;
    from = 0;
    to = 0;
    frameStart = 0;
    ended = false;
    int at = take(7);
    byte[] bytes = window.bytes();
    flags = bytes[at + 4];
    int largest = bytes[at + 5] >>> 4 & 7;
    int descriptor = 2;
    if ((flags & VERSION_MASK) != VERSION || (flags & DICTIONARY) != 0 || largest < 4) {
      throw new DamagedPacketException("an LZ4 frame of an unknown kind");
    }
    blockBytes = 1 << (8 + 2 * largest);
    if ((flags & CONTENT_SIZE) != 0) {
      next = offset;
      at = take(15);
      bytes = window.bytes();
      descriptor = 10;
    }
    int check = Lz4Codec.checksum(bytes, at + 4, at + 4 + descriptor) >>> 8 & 0xff;
    if (check != (bytes[at + 4 + descriptor] & 0xff)) {
      throw new DamagedPacketException("an LZ4 frame whose header is damaged");
    }
  }

  private int take(int count) throws IOException, DamagedPacketException {
    int at = count > end - next ? -1 : window.require(next, count);
    if (at < 0) {
      throw new DamagedPacketException("an LZ4 frame that ends too early");
    }
    next += count;
    return at;
  }

  @Override
  public boolean more() throws IOException, DamagedPacketException {
    if (ended) {
      return false;
    }
    int at = take(4);
    int word = LittleEndian.getInt(window.bytes(), at);
    if (word == 0) {
      ended = true;
      return false;
    }
    int count = word & ~STORED;
    if (count > blockBytes) {
      throw new DamagedPacketException("an LZ4 block that is too large");
    }
    boolean checked = (flags & BLOCK_CHECKSUM) != 0;
    at = take(checked ? count + 4 : count);
    byte[] in = window.bytes();
    if (checked && Lz4Codec.checksum(in, at, at + count) != LittleEndian.getInt(in, at + count)) {
      throw new DamagedPacketException("an LZ4 block that is damaged");
    }
    makeRoom();
    if (word < 0) {
      System.arraycopy(in, at, data, to, count);
      to += count;
    } else {
      int history = (flags & INDEPENDENT) != 0 ? 0 : Math.min(MAX_OFFSET, to - frameStart);
      to =
          history == 0
              ? Lz4Codec.decompress(in, at, at + count, data, to, to + blockBytes)
              : linked(in, at, at + count, history);
    }
    return true;
  }

  /**
   * Decompresses a dependent block, which the library does not support. The first sequence of a
   * block starts with literals: the history is prepended to them.
   */
  private int linked(byte[] in, int from, int end, int history) throws DamagedPacketException {
    int at = from + 1;
    int literals = from < end ? in[from] >>> 4 & 15 : 0;
    if (literals == LONG_LITERALS) {
      int more = 255;
      while (more == 255 && at < end) {
        more = in[at++] & 0xff;
        literals += more;
      }
    }
    if (from == end || literals > end - at) {
      throw new DamagedPacketException("an LZ4 block that ends too early");
    }
    int length = history + literals;
    int room = 2 + length / 255 + history + end - at;
    if (sequence.length < room) {
      sequence = new byte[room + MAX_OFFSET];
    }
    sequence[0] = (byte) (Math.min(LONG_LITERALS, length) << 4 | in[from] & 15);
    int done = 1;
    if (length >= LONG_LITERALS) {
      int left = length - LONG_LITERALS;
      for (; left >= 255; left -= 255) {
        sequence[done++] = (byte) 255;
      }
      sequence[done++] = (byte) left;
    }
    System.arraycopy(data, to - history, sequence, done, history);
    System.arraycopy(in, at, sequence, done + history, end - at);
    done += history + end - at;
    return Lz4Codec.decompress(sequence, 0, done, data, to - history, to + blockBytes);
  }

  /** Keeps the unused bytes and the history that later blocks may refer to. */
  private void makeRoom() {
    if (data.length - to >= blockBytes) {
      return;
    }
    int keep = Math.min(from, Math.max(frameStart, to - MAX_OFFSET));
    if (keep > 0) {
      System.arraycopy(data, keep, data, 0, to - keep);
      from -= keep;
      to -= keep;
      frameStart = Math.max(0, frameStart - keep);
    }
    if (data.length - to < blockBytes) {
      data = Arrays.copyOf(data, Math.max(to + blockBytes, MAX_OFFSET + ROOM));
    }
  }
}
