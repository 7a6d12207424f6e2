package haltere.core.format.internal.aedat4;

import haltere.core.format.RecordingFile;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.compression.Lz4Payload;
import haltere.core.format.internal.compression.Payload;
import haltere.core.format.internal.compression.StoredPayload;
import haltere.core.format.internal.compression.ZstdPayload;
import java.io.IOException;

/**
 * Decompresses the payload of a packet piece by piece, so that memory is bounded for any size. The
 * available unused bytes are in {@link #data} from {@link #from} to {@link #to}; its user advances
 * {@link #from}.
 *
 * <p>Thread rule: one thread.
 */
final class Decompressor {
  /** A packet's table and the vector of events must start within this number of bytes. */
  private static final int TABLE_BYTES = 4096;

  private final FileWindow window;
  private final StoredPayload stored;
  private Lz4Payload lz4;
  private ZstdPayload zstd;
  private Payload method;

  Decompressor(RecordingFile file) {
    window = new FileWindow(file);
    stored = new StoredPayload(window);
    method = stored;
  }

  FileWindow window() {
    return window;
  }

  /** Compression of a payload, by its first bytes; empty if they are invalid. */
  static Aedat4Compression compression(byte[] bytes, int at, long size) {
    int first = LittleEndian.getInt(bytes, at);
    if (first == Aedat4Compression.LZ4_MAGIC) {
      return Aedat4Compression.LZ4;
    }
    if (first == Aedat4Compression.ZSTD_MAGIC) {
      return Aedat4Compression.ZSTD;
    }
    return first == size - 4 ? Aedat4Compression.NONE : null;
  }

  /** Opens a payload of any compression. */
  void open(long offset, long size) throws IOException, DamagedPacketException {
    int at = size < 4 ? -1 : window.require(offset, 4);
    Aedat4Compression compression = at < 0 ? null : compression(window.bytes(), at, size);
    if (compression == null) {
      throw new DamagedPacketException("a packet of an unknown compression");
    }
    if (compression.isLz4()) {
      lz4 = lz4 == null ? new Lz4Payload(window) : lz4;
      method = lz4;
    } else if (compression.isZstd()) {
      zstd = zstd == null ? new ZstdPayload(window) : zstd;
      method = zstd;
    } else {
      method = stored;
    }
    method.open(offset, size);
  }

  byte[] data() {
    return method.data();
  }

  int from() {
    return method.from();
  }

  int to() {
    return method.to();
  }

  void use(int bytes) {
    method.use(bytes);
  }

  /**
   * Advances to the events of an opened payload.
   *
   * @return their stated number
   */
  long events() throws IOException, DamagedPacketException {
    gather(TABLE_BYTES);
    if (!FlatTable.identifier(data(), from(), to()).equals(Aedat4Stream.EVENTS)) {
      throw new DamagedPacketException("a packet without events");
    }
    FlatTable table = FlatTable.root(data(), from(), to());
    long count = table.vectorLength(0);
    if (count > 0) {
      use(table.vectorElements(0) - from());
    }
    return count;
  }

  boolean more() throws IOException, DamagedPacketException {
    return method.more();
  }

  void skip(long bytes) throws IOException, DamagedPacketException {
    method.skip(bytes);
  }

  /** Makes a number of bytes available, or all that remain. */
  boolean gather(int bytes) throws IOException, DamagedPacketException {
    return method.gather(bytes);
  }

  void close() {
    if (zstd != null) {
      zstd.close();
    }
  }
}
