package haltere.core.format.internal.compression;

import com.github.luben.zstd.ZstdDecompressCtx;
import com.github.luben.zstd.ZstdException;
import java.io.Closeable;

/**
 * Decompresses Zstandard frames from one array to another.
 *
 * <p>Thread rule: one thread.
 */
public final class ZstdBlock implements Closeable {
  private final ZstdDecompressCtx context = ZstdLibrary.decompressor();

  /** Allocates memory outside the heap until it is closed. */
  public ZstdBlock() {}

  /**
   * Decompresses a frame.
   *
   * @param in holds it
   * @param from its start
   * @param to its end
   * @param out receives the bytes
   * @param outFrom index of the first
   * @param outTo end of the available space
   * @return end of the bytes
   * @throws DamagedPacketException if it is invalid or exceeds the space
   */
  public int unpack(byte[] in, int from, int to, byte[] out, int outFrom, int outTo)
      throws DamagedPacketException {
    try {
      return outFrom
          + context.decompressByteArray(out, outFrom, outTo - outFrom, in, from, to - from);
    } catch (ZstdException e) {
      throw new DamagedPacketException(e.getMessage());
    }
  }

  @Override
  public void close() {
    context.close();
  }
}
