package haltere.core.format.internal.packed;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdCompressCtx;
import java.io.Closeable;

/**
 * Packs bytes as one Zstandard frame each.
 *
 * <p>Thread rule: one thread.
 */
public final class ZstdPacker implements Closeable {
  private final ZstdCompressCtx context = new ZstdCompressCtx();

  /**
   * A packer.
   *
   * @param level 1 (fast) to 22 (small)
   */
  public ZstdPacker(int level) {
    context.setLevel(level);
  }

  /**
   * Bytes that packed bytes need at the worst.
   *
   * @param bytes how many are packed
   * @return bytes
   */
  public static int bound(int bytes) {
    return (int) Zstd.compressBound(bytes);
  }

  /**
   * Packs bytes.
   *
   * @param bytes what to pack, from index 0
   * @param count how many
   * @param target receives the frame, with room for {@link #bound}
   * @param at where
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
