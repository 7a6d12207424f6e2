package haltere.core.format.aedat4;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.packed.LittleEndian;
import java.io.Closeable;
import java.io.IOException;
import java.lang.invoke.VarHandle;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * Writes AEDAT-4.0 as DV does: one stream of events, rows counted from the top, a table of packets
 * at the end. The header is complete from the start and packets are written whole, so the file can
 * be read up to its last whole packet whenever its writer dies.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class Aedat4Writer implements RecordingWriter {
  private static final int PACKET_EVENTS = 8192;
  private static final int PAYLOAD_HEADER = 32;
  private static final String SOURCE = "source";

  private final SensorGeometry geometry;
  private final FileChannel channel;
  private final Closeable owner;
  private final Commit commit;
  private final boolean inPlace;
  private final PacketPacker packer;
  private final DataTable table = new DataTable();
  private final byte[] payload =
      new byte[PAYLOAD_HEADER + PACKET_EVENTS * Aedat4Cursor.EVENT_BYTES];
  private final byte[] packed;
  private final ByteBuffer output;
  private long position;
  private long packetsEnd;
  private int events;
  private long lastUs;
  private long outside;
  private boolean finished;

  @FunctionalInterface
  private interface Commit {
    void run() throws IOException;
  }

  private Aedat4Writer(
      FileChannel channel,
      Closeable owner,
      Commit commit,
      WriteOptions options,
      Aedat4Compression compression,
      boolean inPlace)
      throws IOException {
    this.channel = channel;
    this.owner = owner;
    this.commit = commit;
    this.inPlace = inPlace;
    geometry = options.geometry();
    packer = new PacketPacker(compression);
    packed = new byte[PacketWalk.HEADER_BYTES + packer.bound(payload.length)];
    output = ByteBuffer.wrap(packed);
    preparePayload();
    position = channel.size();
    packetsEnd = position;
  }

  /**
   * Starts a file that appears when it is finished, or not at all.
   *
   * @param path where it will be
   * @param options about the events; of the metadata, {@code source} names the camera
   * @param compression how packets are packed
   * @return a writer
   * @throws IOException if the file cannot be written
   */
  public static Aedat4Writer create(Path path, WriteOptions options, Aedat4Compression compression)
      throws IOException {
    AtomicFile file = AtomicFile.create(path, options.overwrite());
    try {
      file.write(ByteBuffer.wrap(header(options, compression)));
      return new Aedat4Writer(file.channel(), file, file::commit, options, compression, false);
    } catch (IOException | RuntimeException e) {
      file.close();
      throw e;
    }
  }

  /**
   * Starts a file in its place, for a recording that is to survive the death of the program: from
   * the moment that the file is there it can be read, up to its last packet. Closed without being
   * finished it stays so.
   *
   * @param path where it is
   * @param options about the events; of the metadata, {@code source} names the camera
   * @param compression how packets are packed
   * @return a writer
   * @throws IOException if the file cannot be written
   */
  public static Aedat4Writer createInPlace(
      Path path, WriteOptions options, Aedat4Compression compression) throws IOException {
    try (AtomicFile head = AtomicFile.create(path, options.overwrite())) {
      head.write(ByteBuffer.wrap(header(options, compression)));
      head.commit();
    }
    FileChannel channel = FileChannel.open(path, StandardOpenOption.WRITE);
    try {
      return new Aedat4Writer(channel, channel, channel::close, options, compression, true);
    } catch (IOException | RuntimeException e) {
      channel.close();
      throw e;
    }
  }

  private static byte[] header(WriteOptions options, Aedat4Compression compression) {
    Map<String, String> rest = new TreeMap<>(options.metadata());
    String source = Objects.requireNonNullElse(rest.remove(SOURCE), "haltere");
    SensorGeometry sensor = options.geometry();
    return Aedat4Header.write(
        compression,
        InfoNode.ofEvents(compression.name(), sensor.width(), sensor.height(), source, rest));
  }

  /** All but the sizes is the same in each packet. */
  private void preparePayload() {
    LittleEndian.putInt(payload, 4, 16);
    System.arraycopy(Aedat4Stream.EVENTS.getBytes(StandardCharsets.ISO_8859_1), 0, payload, 8, 4);
    LittleEndian.putShort(payload, 14, 6);
    LittleEndian.putShort(payload, 16, 8);
    LittleEndian.putShort(payload, 18, 4);
    LittleEndian.putInt(payload, 20, 6);
    LittleEndian.putInt(payload, 24, 4);
  }

  private void write(ByteBuffer bytes) throws IOException {
    int count = bytes.remaining();
    while (bytes.hasRemaining()) {
      channel.write(bytes, position + count - bytes.remaining());
    }
    position += count;
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    int size = packet.size();
    int from = 0;
    if (size > 0 && events > 0 && packet.firstTimeUs() < lastUs) {
      writeThrough();
    }
    while (from < size) {
      int count = Math.min(size - from, PACKET_EVENTS - events);
      append(packet, from, from + count);
      from += count;
      if (events == PACKET_EVENTS) {
        writeThrough();
      }
    }
  }

  private void append(EventPacket packet, int from, int to) {
    VarHandle longs = LittleEndian.LONG;
    long[] times = packet.timesUs();
    int[] addresses = packet.addresses();
    int width = geometry.width();
    int top = geometry.height() - 1;
    byte[] bytes = payload;
    int start = PAYLOAD_HEADER + events * Aedat4Cursor.EVENT_BYTES;
    int at = start;
    for (int i = from; i < to; i++) {
      int address = addresses[i];
      int x = address >>> 1 & 0x7fff;
      int y = top - (address >>> 16);
      longs.set(bytes, at, times[i]);
      longs.set(bytes, at + 8, (long) (address & 1) << 32 | (long) y << 16 & 0xffff_0000L | x);
      // An event outside of the sensor is overwritten by the next.
      at += x < width && y >= 0 ? Aedat4Cursor.EVENT_BYTES : 0;
    }
    int kept = (at - start) / Aedat4Cursor.EVENT_BYTES;
    outside += to - from - kept;
    events += kept;
    if (kept > 0) {
      lastUs = LittleEndian.getLong(bytes, at - Aedat4Cursor.EVENT_BYTES);
    }
  }

  /**
   * Writes the events up to now as a packet, so that a reader finds them.
   *
   * @throws IOException if they cannot be written
   */
  @Override
  public void writeThrough() throws IOException {
    if (events == 0) {
      return;
    }
    int size = PAYLOAD_HEADER + events * Aedat4Cursor.EVENT_BYTES;
    LittleEndian.putInt(payload, 0, size - 4);
    LittleEndian.putInt(payload, 28, events);
    int header = PacketWalk.HEADER_BYTES;
    int end = packer.pack(payload, size, PAYLOAD_HEADER, packed, header);
    LittleEndian.putInt(packed, 0, 0);
    LittleEndian.putInt(packed, 4, end - header);
    table.add(
        position + header,
        end - header,
        events,
        LittleEndian.getLong(payload, PAYLOAD_HEADER),
        lastUs);
    events = 0;
    write(output.clear().limit(end));
    packetsEnd = position;
  }

  @Override
  public List<String> losses() {
    return outside == 0
        ? List.of()
        : List.of(outside + " events outside of " + geometry + " were left out");
  }

  @Override
  public void finish() throws IOException {
    if (finished) {
      throw new IllegalStateException("it is finished already");
    }
    writeThrough();
    long tablePosition = position;
    write(ByteBuffer.wrap(packer.pack(table.toBytes())));
    byte[] patch = new byte[8];
    LittleEndian.putLong(patch, 0, tablePosition);
    ByteBuffer bytes = ByteBuffer.wrap(patch);
    while (bytes.hasRemaining()) {
      channel.write(bytes, Aedat4Header.TABLE_POSITION_OFFSET + bytes.position());
    }
    commit.run();
    finished = true;
  }

  @Override
  public void close() throws IOException {
    packer.close();
    try (owner) {
      if (inPlace && !finished && channel.isOpen()) {
        // What failed may have left a part of a packet.
        channel.truncate(packetsEnd);
      }
    }
  }
}
