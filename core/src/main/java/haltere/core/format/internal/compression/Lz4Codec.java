package haltere.core.format.internal.compression;

import net.jpountz.lz4.LZ4Compressor;
import net.jpountz.lz4.LZ4Exception;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.xxhash.XXHashFactory;

/**
 * LZ4 blocks and the checksum of LZ4 frames by lz4-java: native if the library supports the
 * machine, else in Java without {@code Unsafe}.
 *
 * <p>Thread rule: any thread.
 */
public final class Lz4Codec {
  private static final boolean NATIVE = loadsNative();
  private static final LZ4Factory BLOCKS =
      NATIVE ? LZ4Factory.nativeInstance() : LZ4Factory.safeInstance();
  private static final XXHashFactory CHECKSUMS =
      NATIVE ? XXHashFactory.nativeInstance() : XXHashFactory.safeInstance();

  private Lz4Codec() {}

  private static boolean loadsNative() {
    try {
      LZ4Factory.nativeInstance();
      return true;
    } catch (LinkageError | AssertionError | RuntimeException e) {
      return false;
    }
  }

  /**
   * Decompresses an independent block.
   *
   * @param in holds the block
   * @param from its start
   * @param to its end
   * @param out receives the bytes
   * @param outFrom index of the first
   * @param outTo end of the available space
   * @return end of the bytes
   * @throws DamagedPacketException if the block is invalid or exceeds the space
   */
  public static int decompress(byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    return decompress(BLOCKS, in, from, to, out, outFrom, outTo);
  }

  static int decompress(
      LZ4Factory blocks, byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    try {
      return outFrom
          + blocks
              .safeDecompressor()
              .decompress(in, from, to - from, out, outFrom, outTo - outFrom);
    } catch (LZ4Exception | IndexOutOfBoundsException e) {
      throw new DamagedPacketException("an LZ4 block that is damaged");
    }
  }

  /**
   * The compressor for recording.
   *
   * @return fast, any thread
   */
  public static LZ4Compressor fast() {
    return BLOCKS.fastCompressor();
  }

  /**
   * The compressor for archives.
   *
   * @return slow, any thread
   */
  public static LZ4Compressor high() {
    return BLOCKS.highCompressor();
  }

  /**
   * The 32-bit checksum of LZ4 frames (xxHash, seed 0).
   *
   * @param bytes the array
   * @param from index of the first
   * @param to index after the last
   * @return the checksum
   */
  public static int checksum(byte[] bytes, int from, int to) {
    return CHECKSUMS.hash32().hash(bytes, from, to - from, 0);
  }
}
