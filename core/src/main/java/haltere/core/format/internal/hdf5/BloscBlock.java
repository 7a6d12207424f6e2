package haltere.core.format.internal.hdf5;

import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Lz4Codec;

/**
 * Decompresses chunks of the Blosc filter (version 1): blocks with shuffled bytes, compressed with
 * one of several methods.
 *
 * <p>Thread rule: one thread.
 */
final class BloscBlock {
  private static final int HEADER = 16;
  private static final int MAX_SPLITS = 16;
  private static final int MIN_SPLIT = 128;

  private final ChunkDecompressor decompressor;
  private byte[] sorted = {};

  /** A decompressor that uses zlib and Zstandard of another one. */
  BloscBlock(ChunkDecompressor decompressor) {
    this.decompressor = decompressor;
  }

  /**
   * Decompresses a chunk from the start of an array to the start of another; returns its length.
   */
  int unpack(byte[] in, int length, byte[] out, int maxBytes) throws DamagedPacketException {
    check(length >= HEADER);
    int flags = in[2] & 0xff;
    int size = in[3] & 0xff;
    int bytes = LittleEndian.getInt(in, 4);
    int blockBytes = LittleEndian.getInt(in, 8);
    check(bytes >= 0 && bytes <= maxBytes && (blockBytes > 0 || bytes == 0));
    if ((flags & 2) != 0) {
      check(bytes <= length - HEADER);
      System.arraycopy(in, HEADER, out, 0, bytes);
      return bytes;
    }
    int blocks = bytes == 0 ? 0 : (bytes - 1) / blockBytes + 1;
    check(blocks <= (length - HEADER) / 4);
    boolean byBytes = (flags & 1) != 0 && size > 1;
    boolean byBits = (flags & 4) != 0 && blockBytes >= size;
    int room = Math.min(bytes, blockBytes);
    if ((byBytes || byBits) && sorted.length < room) {
      sorted = new byte[room];
    }
    for (int block = 0; block < blocks; block++) {
      int from = LittleEndian.getInt(in, HEADER + 4 * block);
      int outFrom = block * blockBytes;
      int count = Math.min(blockBytes, bytes - outFrom);
      boolean leftOver = count < blockBytes;
      boolean split =
          (flags & 0x10) == 0
              && size <= MAX_SPLITS
              && size > 0
              && blockBytes / size >= MIN_SPLIT
              && !leftOver;
      check(from >= HEADER && from <= length);
      if (byBytes || byBits) {
        block(in, from, length, sorted, 0, count, flags >> 5, split ? size : 1);
        if (byBytes) {
          ByteShuffle.undo(sorted, 0, out, outFrom, count, size);
        } else {
          ByteShuffle.undoBits(sorted, 0, out, outFrom, count, size);
        }
      } else {
        block(in, from, length, out, outFrom, count, flags >> 5, split ? size : 1);
      }
    }
    return bytes;
  }

  private void block(
      byte[] in, int from, int to, byte[] out, int outFrom, int count, int method, int splits)
      throws DamagedPacketException {
    int part = count / splits;
    int at = from;
    for (int i = 0; i < splits; i++) {
      check(to - at >= 4);
      int compressed = LittleEndian.getInt(in, at);
      at += 4;
      check(compressed >= 0 && compressed <= to - at);
      int start = outFrom + i * part;
      if (compressed == part) {
        System.arraycopy(in, at, out, start, part);
      } else {
        check(unpack(method, in, at, at + compressed, out, start, start + part) == start + part);
      }
      at += compressed;
    }
    check(part * splits == count);
  }

  private int unpack(int method, byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    return switch (method) {
      case 0 -> LzfBlock.unpackBlosc(in, from, to, out, outFrom, outTo);
      case 1 -> Lz4Codec.decompress(in, from, to, out, outFrom, outTo);
      case 3 -> decompressor.inflate(in, from, to, out, outFrom, outTo);
      case 4 -> decompressor.zstd(in, from, to, out, outFrom, outTo);
      default -> throw new DamagedPacketException("Blosc with an unsupported method");
    };
  }

  private static void check(boolean possible) throws DamagedPacketException {
    if (!possible) {
      throw new DamagedPacketException("a chunk that contradicts its compression");
    }
  }
}
