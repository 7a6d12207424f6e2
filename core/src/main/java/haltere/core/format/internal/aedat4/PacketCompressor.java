package haltere.core.format.internal.aedat4;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdCompressCtx;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Lz4Codec;
import haltere.core.format.internal.compression.ZstdLibrary;
import java.io.Closeable;
import java.util.Arrays;
import net.jpountz.lz4.LZ4Compressor;

/**
 * Compresses payloads as one frame each.
 *
 * <p>Thread rule: one thread.
 */
final class PacketCompressor implements Closeable {
  private static final int LZ4_FLAGS = 0x60;
  private static final int LZ4_BLOCK = 256 * 1024;
  private static final int LZ4_BLOCK_CODE = 0x50;
  private static final int LZ4_HEADER = 7;
  private static final int LZ4_STORED = 0x8000_0000;

  /**
   * DV uses level 3. For events level 2 is smaller (5.31 bytes each instead of 5.35) and faster.
   */
  private static final int ZSTD_LEVEL = 2;

  private final Aedat4Compression compression;
  private LZ4Compressor lz4;
  private ZstdCompressCtx zstd;

  PacketCompressor(Aedat4Compression compression) {
    this.compression = compression;
    if (compression.isLz4()) {
      lz4 = compression == Aedat4Compression.LZ4 ? Lz4Codec.fast() : Lz4Codec.high();
    }
    if (compression.isZstd()) {
      zstd =
          ZstdLibrary.compressor(
              compression == Aedat4Compression.ZSTD ? ZSTD_LEVEL : ZstdLibrary.maxLevel());
    }
  }

  /** Upper bound of the compressed size. */
  int bound(int bytes) {
    return switch (compression) {
      case NONE -> bytes;
      case LZ4, LZ4_HIGH ->
          lz4.maxCompressedLength(bytes) + LZ4_HEADER + 4 * (bytes / LZ4_BLOCK + 2);
      case ZSTD, ZSTD_HIGH -> (int) Zstd.compressBound(bytes);
    };
  }

  /**
   * Compresses a payload.
   *
   * @param payload holds it
   * @param size its bytes, from index 0
   * @param target receives it
   * @param at index of its start
   * @return index of its end
   */
  int pack(byte[] payload, int size, byte[] target, int at) {
    switch (compression) {
      case LZ4, LZ4_HIGH -> {
        return packLz4(payload, size, target, at);
      }
      case ZSTD, ZSTD_HIGH -> {
        return at + zstd.compressByteArray(target, at, target.length - at, payload, 0, size);
      }
      default -> {
        System.arraycopy(payload, 0, target, at, size);
        return at + size;
      }
    }
  }

  private int packLz4(byte[] payload, int size, byte[] target, int start) {
    LittleEndian.putInt(target, start, Aedat4Compression.LZ4_MAGIC);
    target[start + 4] = LZ4_FLAGS;
    target[start + 5] = LZ4_BLOCK_CODE;
    target[start + 6] = (byte) (Lz4Codec.checksum(target, start + 4, start + 6) >>> 8);
    int at = start + LZ4_HEADER;
    for (int from = 0; from < size; from += LZ4_BLOCK) {
      int to = Math.min(size, from + LZ4_BLOCK);
      int end = at + 4 + lz4.compress(payload, from, to - from, target, at + 4);
      if (end - at - 4 >= to - from) {
        System.arraycopy(payload, from, target, at + 4, to - from);
        end = at + 4 + to - from;
        LittleEndian.putInt(target, at, LZ4_STORED | to - from);
      } else {
        LittleEndian.putInt(target, at, end - at - 4);
      }
      at = end;
    }
    LittleEndian.putInt(target, at, 0);
    return at + 4;
  }

  /** A payload without events, in an array of its own. */
  byte[] pack(byte[] payload) {
    byte[] target = new byte[bound(payload.length)];
    return Arrays.copyOf(target, pack(payload, payload.length, target, 0));
  }

  @Override
  public void close() {
    if (zstd != null) {
      zstd.close();
    }
  }
}
