package haltere.core.format.internal.compression;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdCompressCtx;
import com.github.luben.zstd.ZstdDecompressCtx;
import com.github.luben.zstd.util.Native;
import java.io.IOException;
import java.io.UncheckedIOException;

/**
 * The native library of Zstandard, which is unpacked into the folder for temporary files.
 *
 * <p>Thread rule: any thread.
 */
public final class ZstdLibrary {
  private ZstdLibrary() {}

  /**
   * Loads it, if it is not loaded yet.
   *
   * @throws UncheckedIOException if it cannot be unpacked or loaded, with cause and advice
   */
  public static void load() {
    try {
      Native.load();
    } catch (LinkageError e) {
      throw new UncheckedIOException(
          new IOException(
              "Zstandard cannot be used from the folder for temporary files, "
                  + System.getProperty("java.io.tmpdir")
                  + " ("
                  + e.getMessage()
                  + "); choose another with JAVA_OPTS=-Djava.io.tmpdir=FOLDER",
              e));
    }
  }

  /**
   * A compressor, to be closed.
   *
   * @param level 1 (fast) to 22 (small)
   * @return it
   * @throws UncheckedIOException if the library cannot be loaded
   */
  public static ZstdCompressCtx compressor(int level) {
    load();
    ZstdCompressCtx context = new ZstdCompressCtx();
    context.setLevel(level);
    return context;
  }

  /**
   * The level of the smallest output.
   *
   * @return it
   * @throws UncheckedIOException if the library cannot be loaded
   */
  public static int maxLevel() {
    load();
    return Zstd.maxCompressionLevel();
  }

  static ZstdDecompressCtx decompressor() {
    load();
    return new ZstdDecompressCtx();
  }
}
