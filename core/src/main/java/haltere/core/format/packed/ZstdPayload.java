package haltere.core.format.packed;

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
 * A payload that is a Zstandard frame: unpacked at once where it says that it is small, else as a
 * stream.
 */
public final class ZstdPayload extends Payload {
  private static final int AT_ONCE_BYTES = 4 * 1024 * 1024;
  private static final int PIECE = 256 * 1024;
  private static final int MAX_WINDOW_LOG = 25;

  private final FileWindow window;
  private final ZstdDecompressCtx context = new ZstdDecompressCtx();
  private long next;
  private long end;
  private InputStream stream;
  private boolean ended;

  /**
   * A payload that is not opened yet.
   *
   * @param window over the file
   */
  public ZstdPayload(FileWindow window) {
    this.window = window;
  }

  @Override
  public void open(long offset, long size) throws IOException, DamagedPacketException {
    closeStream();
    next = offset;
    end = offset + size;
    from = 0;
    to = 0;
    ended = false;
    if (size <= AT_ONCE_BYTES) {
      int at = window.require(offset, (int) size);
      long whole = at < 0 ? -1 : Zstd.getFrameContentSize(window.bytes(), at, (int) size);
      if (whole >= 0 && whole <= AT_ONCE_BYTES) {
        atOnce(at, (int) size, (int) whole);
        return;
      }
    }
    stream = new ZstdInputStreamNoFinalizer(new Packed()).setLongMax(MAX_WINDOW_LOG);
  }

  private void atOnce(int at, int size, int whole) throws DamagedPacketException {
    if (data.length < whole) {
      data = new byte[Math.min(AT_ONCE_BYTES, Math.max(whole, 2 * data.length))];
    }
    try {
      to = context.decompressByteArray(data, 0, whole, window.bytes(), at, size);
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

  /** The packed bytes. Their end is told as damage by the stream if it comes too early. */
  private final class Packed extends InputStream {
    private final byte[] one = new byte[1];

    @Override
    public int read() throws IOException {
      return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
    }

    @Override
    public int read(byte[] target, int offset, int length) throws IOException {
      int count = (int) Math.min(Math.min(length, 64 * 1024), end - next);
      int at = count <= 0 ? -1 : window.require(next, count);
      if (at < 0) {
        return -1;
      }
      System.arraycopy(window.bytes(), at, target, offset, count);
      next += count;
      return count;
    }
  }
}
