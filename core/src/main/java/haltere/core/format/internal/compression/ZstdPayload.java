package haltere.core.format.internal.compression;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdDecompressCtx;
import com.github.luben.zstd.ZstdException;
import com.github.luben.zstd.ZstdIOException;
import com.github.luben.zstd.ZstdInputStreamNoFinalizer;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.Arrays;

/**
 * A payload that is a Zstandard frame: decompressed at once if it states a small size, else as a
 * stream.
 */
public final class ZstdPayload extends Payload {
  private static final int AT_ONCE_BYTES = 4 * 1024 * 1024;
  private static final int PIECE = 256 * 1024;
  private static final int MAX_WINDOW_LOG = 25;

  /** The longest header of a frame. */
  private static final int HEADER_BYTES = 18;

  private final ByteSource source;
  private final ZstdDecompressCtx context = ZstdLibrary.decompressor();
  private InputStream stream;
  private boolean ended;
  private long claimed;

  /**
   * A payload, not yet opened.
   *
   * @param source holds the compressed bytes; it is not closed with the payload
   */
  public ZstdPayload(ByteSource source) {
    this.source = source;
  }

  @Override
  public void open(long offset, long size) throws IOException, DamagedPacketException {
    closeStream();
    from = 0;
    to = 0;
    ended = false;
    boolean small = size <= AT_ONCE_BYTES;
    int head = (int) (small ? size : HEADER_BYTES);
    int at = source.require(offset, head);
    claimed = at < 0 ? -1 : Zstd.getFrameContentSize(source.bytes(), at, head);
    if (small && claimed >= 0 && claimed <= AT_ONCE_BYTES) {
      atOnce(at, head, (int) claimed);
      return;
    }
    stream =
        new ZstdInputStreamNoFinalizer(new CompressedStream(source, offset, size))
            .setLongMax(MAX_WINDOW_LOG);
  }

  /**
   * Stated size of the frame after decompression; it may be wrong.
   *
   * @return negative if it is not stated
   */
  public long claimedBytes() {
    return claimed;
  }

  private void atOnce(int at, int size, int whole) throws DamagedPacketException {
    if (data.length < whole) {
      data = new byte[Math.min(AT_ONCE_BYTES, Math.max(whole, 2 * data.length))];
    }
    try {
      to = context.decompressByteArray(data, 0, whole, source.bytes(), at, size);
    } catch (ZstdException e) {
      throw new DamagedPacketException(e.getMessage());
    }
    ended = true;
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
    try {
      int read = stream.read(data, to, PIECE);
      ended = read <= 0;
      to += Math.max(0, read);
    } catch (ZstdException | ZstdIOException | EOFException e) {
      throw new DamagedPacketException(e.getMessage());
    }
    return !ended;
  }

  private void closeStream() throws IOException {
    if (stream != null) {
      stream.close();
      stream = null;
    }
  }

  @Override
  public void close() {
    context.close();
    try {
      closeStream();
    } catch (IOException e) {
      throw new java.io.UncheckedIOException(e);
    }
  }
}
