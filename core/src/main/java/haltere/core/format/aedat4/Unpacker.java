package haltere.core.format.aedat4;

import haltere.core.format.RecordingFile;
import java.io.IOException;

/**
 * Unpacks the payload of a packet piece by piece, so that memory is bounded whatever its size. The
 * bytes that are there and not yet used lie in {@link #data} from {@link #from} to {@link #to}; who
 * uses some moves {@link #from}.
 *
 * <p>Thread rule: one thread.
 */
final class Unpacker {
  /** One way to unpack. */
  abstract static class Method {
    byte[] data = new byte[0];
    int from;
    int to;

    /** Starts with a payload. */
    abstract void open(long offset, long size) throws IOException, DamagedPacketException;

    /**
     * Puts more bytes behind those that are not yet used; all of them may move.
     *
     * @return false at the end of the payload
     */
    abstract boolean more() throws IOException, DamagedPacketException;

    /** Drops bytes that are not there yet. */
    void skip(long count) throws IOException, DamagedPacketException {
      long left = count;
      while (left > 0) {
        if (from == to && !more()) {
          throw new DamagedPacketException("a packet that ends too early");
        }
        int step = (int) Math.min(left, to - from);
        from += step;
        left -= step;
      }
    }

    /** Releases what is outside of the heap. */
    void close() {}
  }

  /** A payload that is unpacked already. */
  private static final class ReadyPayload extends Method {
    @Override
    void open(long offset, long size) {
      throw new UnsupportedOperationException();
    }

    @Override
    boolean more() {
      return false;
    }
  }

  private final FileWindow window;
  private final ReadyPayload ready = new ReadyPayload();
  private final StoredPayload stored;
  private Lz4Payload lz4;
  private ZstdPayload zstd;
  private Method method;

  Unpacker(RecordingFile file) {
    window = new FileWindow(file);
    stored = new StoredPayload(window);
    method = stored;
  }

  FileWindow window() {
    return window;
  }

  /** How a payload is packed, by its first bytes; empty for nothing that could be one. */
  static Aedat4Compression packing(byte[] bytes, int at, long size) {
    int first = LittleEndian.getInt(bytes, at);
    if (first == Aedat4Compression.LZ4_MAGIC) {
      return Aedat4Compression.LZ4;
    }
    if (first == Aedat4Compression.ZSTD_MAGIC) {
      return Aedat4Compression.ZSTD;
    }
    return first == size - 4 ? Aedat4Compression.NONE : null;
  }

  /** Starts with a payload of any packing. */
  void open(long offset, long size) throws IOException, DamagedPacketException {
    int at = size < 4 ? -1 : window.require(offset, 4);
    Aedat4Compression packing = at < 0 ? null : packing(window.bytes(), at, size);
    if (packing == null) {
      throw new DamagedPacketException("a packet of no known packing");
    }
    if (packing.isLz4()) {
      lz4 = lz4 == null ? new Lz4Payload(window) : lz4;
      method = lz4;
    } else if (packing.isZstd()) {
      zstd = zstd == null ? new ZstdPayload(window) : zstd;
      method = zstd;
    } else {
      method = stored;
    }
    method.open(offset, size);
  }

  /** Takes a payload that is unpacked already. */
  void present(byte[] payload, int length) {
    ready.data = payload;
    ready.from = 0;
    ready.to = length;
    method = ready;
  }

  byte[] data() {
    return method.data;
  }

  int from() {
    return method.from;
  }

  int to() {
    return method.to;
  }

  void use(int bytes) {
    method.from += bytes;
  }

  boolean more() throws IOException, DamagedPacketException {
    return method.more();
  }

  void skip(long bytes) throws IOException, DamagedPacketException {
    method.skip(bytes);
  }

  /** Gets at least so many bytes together, or all that there are. */
  void gather(int bytes) throws IOException, DamagedPacketException {
    while (method.to - method.from < bytes && method.more()) {
      // A piece may be smaller than what is needed.
    }
  }

  void close() {
    if (zstd != null) {
      zstd.close();
    }
  }
}
