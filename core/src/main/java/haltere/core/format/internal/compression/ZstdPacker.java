package haltere.core.format.internal.compression;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdCompressCtx;
import java.io.Closeable;

/**
 * Compresses bytes as one Zstandard frame each.
 *
 * <p>Thread rule: one thread.
 */
public final class ZstdPacker implements Closeable {
  private final ZstdCompressCtx context;

  /**
   * A compressor.
   *
   * @param level 1 (fast) to 22 (small)
   */
  public ZstdPacker(int level) {
    context = ZstdLibrary.compressor(level);
  }

  /**
   * Upper bound of the compressed size.
   *
   * @param bytes number of uncompressed bytes
   * @return number of bytes
   */
  public static int bound(int bytes) {
    return (int) Zstd.compressBound(bytes);
  }

  /**
   * Compresses bytes.
   *
   * @param bytes the data, from index 0
   * @param count number of bytes
   * @param target receives the frame, with room for {@link #bound}
   * @param at index of its start
   * @return bytes of the frame
   */
  public int pack(byte[] bytes, int count, byte[] target, int at) {
    return context.compressByteArray(target, at, target.length - at, bytes, 0, count);
  }

  @Override
  public void close() {
    context.close();
  }
}
