package haltere.core.format.internal.compression;

import java.io.IOException;

/** An uncompressed payload, used in the file's window without copying. */
public final class StoredPayload extends Payload {
  private final FileWindow window;
  private long next;
  private long end;

  /**
   * A payload, not yet opened.
   *
   * @param window over the file
   */
  public StoredPayload(FileWindow window) {
    this.window = window;
  }

  @Override
  public void open(long offset, long size) {
    next = offset;
    end = offset + size;
    from = 0;
    to = 0;
  }

  @Override
  public boolean more() throws IOException {
    int unused = to - from;
    if (next >= end) {
      return false;
    }
    int at = window.require(next - unused, unused + 1);
    if (at < 0) {
      return false;
    }
    data = window.bytes();
    from = at;
    to = (int) Math.min(window.end(), at + unused + (end - next));
    next += to - from - unused;
    return true;
  }

  @Override
  public void skip(long count) throws IOException, DamagedPacketException {
    int unused = to - from;
    if (count <= unused) {
      from += (int) count;
      return;
    }
    from = to;
    next += count - unused;
    if (next > end) {
      throw new DamagedPacketException("a packet that ends too early");
    }
  }
}
