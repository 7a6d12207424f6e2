package haltere.core.format.internal.aedat4;

import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingOutline;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.FileWindow;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.decoding.EventCursor.PieceVisitor;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;

/**
 * The table of packets of a closed file, as an index of its times. It is valid if it covers every
 * byte between the header and itself exactly once, as the packet headers do, and if its times match
 * some packets, including the first and the last.
 *
 * <p>Thread rule: one thread.
 */
final class PacketTable {
  private static final int MAX_BYTES = 32 * 1024 * 1024;
  private static final int SAMPLES = 16;
  private static final int COLUMNS = 5;
  private static final int MAX_SAMPLE_EVENTS = 1024 * 1024;

  private final FileWindow headers;
  private final Aedat4Cursor.Layout layout;
  private final int stream;
  private final Decompressor decompressor;

  // for each packet with events: offset, size, events, first and last time
  private long[] packets = new long[64 * COLUMNS];
  private int count;

  private PacketTable(
      RecordingFile file, Aedat4Cursor.Layout layout, int stream, Decompressor decompressor) {
    headers = new FileWindow(file, DecodeAhead.HEADER_WINDOW);
    this.layout = layout;
    this.stream = stream;
    this.decompressor = decompressor;
  }

  /**
   * Reads the table of a file.
   *
   * @return empty without a valid one
   */
  static Optional<PacketTable> readTable(RecordingFile file, Aedat4Cursor.Layout layout, int stream)
      throws IOException {
    if (layout.end() >= file.size()) {
      return Optional.empty();
    }
    Decompressor decompressor = new Decompressor(file);
    try {
      PacketTable table = new PacketTable(file, layout, stream, decompressor);
      return table.read(file.size()) && table.samplesAreTrue()
          ? Optional.of(table)
          : Optional.empty();
    } catch (DamagedPacketException e) {
      return Optional.empty();
    } finally {
      decompressor.close();
    }
  }

  /** Outline of the whole stream. */
  RecordingOutline outline() {
    if (count == 0) {
      return RecordingOutline.NOTHING;
    }
    long events = 0;
    for (int at = 0; at < count * COLUMNS; at += COLUMNS) {
      events += packets[at + 2];
    }
    return new RecordingOutline(events, packets[3], packets[count * COLUMNS - 1]);
  }

  private boolean read(long fileBytes) throws IOException, DamagedPacketException {
    decompressor.open(layout.end(), fileBytes - layout.end());
    byte[] bytes = new byte[0];
    int size = 0;
    do {
      int more = decompressor.to() - decompressor.from();
      if (size + more > MAX_BYTES) {
        return false;
      }
      if (size + more > bytes.length) {
        bytes = Arrays.copyOf(bytes, Math.max(size + more, 2 * bytes.length));
      }
      System.arraycopy(decompressor.data(), decompressor.from(), bytes, size, more);
      decompressor.use(more);
      size += more;
    } while (decompressor.more());
    if (!FlatTable.identifier(bytes, 0, size).equals(DataTable.IDENTIFIER)) {
      return false;
    }
    FlatTable table = FlatTable.root(bytes, 0, size);
    long entries = table.vectorLength(0);
    long next = layout.start();
    for (int i = 0; i < entries; i++) {
      next = read(bytes, table.vectorTable(0, i), next);
    }
    return next == layout.end();
  }

  /** Reads an entry; returns the end of its packet. */
  private long read(byte[] bytes, FlatTable entry, long start)
      throws IOException, DamagedPacketException {
    int packet = entry.position(1, 8);
    long size = packet < 0 ? -1 : LittleEndian.getInt(bytes, packet + 4);
    if (size < 0 || entry.getLong(0, -1) != start + PacketWalk.HEADER_BYTES) {
      throw new DamagedPacketException("a table with gaps");
    }
    int header = headers.require(start, PacketWalk.HEADER_BYTES);
    if (header < 0
        || LittleEndian.getLong(headers.bytes(), header) != LittleEndian.getLong(bytes, packet)) {
      throw new DamagedPacketException("a table that is not about these packets");
    }
    long events = entry.getLong(2, 0);
    if (LittleEndian.getInt(bytes, packet) == stream) {
      if (events <= 0) {
        throw new DamagedPacketException("a table with packets of nothing");
      }
      long firstUs = entry.getLong(3, 0);
      long lastUs = entry.getLong(4, 0);
      if (firstUs > lastUs) {
        throw new DamagedPacketException("a table whose times go back within a packet");
      }
      add(start, size, events, firstUs, lastUs);
    }
    return start + PacketWalk.HEADER_BYTES + size;
  }

  private void add(long... row) {
    int at = count++ * COLUMNS;
    if (at == packets.length) {
      packets = Arrays.copyOf(packets, 2 * at);
    }
    System.arraycopy(row, 0, packets, at, COLUMNS);
  }

  private boolean samplesAreTrue() throws IOException, DamagedPacketException {
    for (int sample = 0; sample < Math.min(SAMPLES, count); sample++) {
      long packet = count <= SAMPLES ? sample : (count - 1L) * sample / (SAMPLES - 1);
      if (!isTrue((int) packet * COLUMNS)) {
        return false;
      }
    }
    return true;
  }

  private boolean isTrue(int at) throws IOException, DamagedPacketException {
    decompressor.open(packets[at] + PacketWalk.HEADER_BYTES, packets[at + 1]);
    long events = decompressor.events();
    if (events != packets[at + 2] || events > MAX_SAMPLE_EVENTS || !decompressor.gather(8)) {
      return false;
    }
    long firstUs = LittleEndian.getLong(decompressor.data(), decompressor.from());
    decompressor.skip((events - 1) * Aedat4Cursor.EVENT_BYTES);
    return firstUs == packets[at + 3]
        && decompressor.gather(8)
        && LittleEndian.getLong(decompressor.data(), decompressor.from()) == packets[at + 4];
  }

  /**
   * Visits the packets, as {@link haltere.core.format.internal.decoding.EventCursor#visitPieces}.
   */
  void visit(PieceVisitor visitor) throws IOException {
    long[] state = new long[Aedat4Cursor.STATE_LONGS];
    long beforeUs = StreamNotification.NO_TIME_US;
    for (int at = 0; at < count * COLUMNS; at += COLUMNS) {
      boolean goesOn = packets[at + 3] >= beforeUs;
      Aedat4Cursor.save(state, packets[at], goesOn ? beforeUs : StreamNotification.NO_TIME_US);
      visitor.piece(state, packets[at], packets[at + 3], packets[at + 4]);
      beforeUs = packets[at + 4];
    }
  }
}
