package haltere.core.format.internal.bag;

import haltere.core.format.internal.compression.CompressedStream;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.Payload;
import java.io.IOException;
import java.util.Arrays;
import org.apache.commons.compress.compressors.bzip2.BZip2CompressorInputStream;

/**
 * A payload that is one bzip2 stream, decompressed by commons-compress. A block is released after
 * its checksum was verified, or before that in pieces of {@link #MAX_HELD_BYTES}: runs of equal
 * bytes can expand a block to 46 MB.
 */
final class Bzip2Payload extends Payload {
  /** More than a block (900 kB) with few repeated bytes. */
  private static final int MAX_HELD_BYTES = 2 * 1024 * 1024;

  private static final int PIECE_BYTES = 64 * 1024;

  private final FileWindow window;
  private CompressedStream compressed;
  private BZip2CompressorInputStream stream;
  private DamagedPacketException damage;

  Bzip2Payload(FileWindow window) {
    this.window = window;
  }

  @Override
  public void open(long offset, long size) throws IOException, DamagedPacketException {
    from = 0;
    to = 0;
    damage = null;
    compressed = new CompressedStream(window, offset, size);
    try {
      stream = new BZip2CompressorInputStream(compressed);
    } catch (IOException | IndexOutOfBoundsException e) {
      throw damage(e);
    }
  }

  @Override
  public boolean more() throws IOException, DamagedPacketException {
    if (damage != null) {
      throw damage;
    }
    System.arraycopy(data, from, data, 0, to - from);
    to -= from;
    from = 0;
    int end = to;
    // the library reads a whole block, after it has verified the checksum of the previous one
    long position = compressed.position();
    try {
      while (compressed.position() == position && end - to < MAX_HELD_BYTES) {
        int value = stream.read();
        if (value < 0) {
          break;
        }
        if (end == data.length) {
          data = Arrays.copyOf(data, end + Math.max(PIECE_BYTES, end / 2));
        }
        data[end++] = (byte) value;
      }
    } catch (IOException | IndexOutOfBoundsException e) {
      damage = damage(e);
      if (compressed.position() == position) {
        throw damage;
      }
    }
    boolean any = end > to;
    to = end;
    return any;
  }

  private DamagedPacketException damage(Exception e) throws IOException {
    compressed.rethrow();
    return new DamagedPacketException("a bzip2 stream that is damaged: " + e.getMessage());
  }
}
