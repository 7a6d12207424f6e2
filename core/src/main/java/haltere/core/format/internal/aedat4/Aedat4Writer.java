package haltere.core.format.internal.aedat4;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.decoding.WriterLosses;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;

/**
 * Writes AEDAT-4.0 as DV does: a stream of events and those of samples that the options name, rows
 * counted from the top, a table of packets at the end. The header is complete from the start and
 * complete packets are written, so that a file of a killed writer can be read up to its last
 * packet.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class Aedat4Writer implements RecordingWriter {
  private static final String SOURCE = "source";

  private final SensorGeometry geometry;
  private final FileChannel channel;
  private final Path path;
  private final Closeable owner;
  private final Commit commit;
  private final boolean inPlace;
  private final Aedat4Compression compression;
  private final PacketCompressor compressor;
  private final DataTable table = new DataTable();
  private final EventPayload payload;
  private final byte[] compressed;
  private final BlockOutput output;
  private final byte[] packetHeader = new byte[PacketWalk.HEADER_BYTES];
  private long packetsEnd;
  private final SamplePackets samples;
  private boolean finished;

  @FunctionalInterface
  private interface Commit {
    void run() throws IOException;
  }

  private Aedat4Writer(
      Path path,
      FileChannel channel,
      Closeable owner,
      Commit commit,
      WriteOptions options,
      Aedat4Compression compression,
      boolean inPlace)
      throws IOException {
    this.path = path;
    this.channel = channel;
    this.owner = owner;
    this.commit = commit;
    this.inPlace = inPlace;
    this.compression = compression;
    geometry = options.geometry();
    compressor = new PacketCompressor(compression);
    payload = new EventPayload(geometry);
    compressed = new byte[compressor.bound(payload.bytes().length)];
    output = new BlockOutput(path, channel);
    packetsEnd = output.position();
    samples = new SamplePackets(geometry.height(), options.samples(), this::writeSamples);
  }

  /**
   * Starts a file that is replaced atomically when it is finished.
   *
   * @param path path of the file
   * @param options the writer's options; of the metadata, {@code source} names the camera
   * @param compression compression of packets
   * @return a writer
   * @throws IOException if the file cannot be written
   */
  public static Aedat4Writer create(Path path, WriteOptions options, Aedat4Compression compression)
      throws IOException {
    AtomicFile file = AtomicFile.create(path, options.overwrite());
    try {
      file.write(ByteBuffer.wrap(header(options, compression)));
      return new Aedat4Writer(
          path, file.channel(), file, file::commit, options, compression, false);
    } catch (IOException | RuntimeException e) {
      file.close();
      throw e;
    }
  }

  /**
   * Starts a file under its final name, for a recording that survives the death of the program: it
   * can be read at any time, up to its last packet. It remains if it is closed unfinished.
   *
   * @param path path of the file
   * @param options the writer's options; of the metadata, {@code source} names the camera
   * @param compression compression of packets
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
      return new Aedat4Writer(path, channel, channel, channel::close, options, compression, true);
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
        compression, InfoNode.of(compression.name(), sensor, source, rest, options.samples()));
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    requireUnfinished();
    int size = packet.size();
    int from = 0;
    if (size > 0 && payload.events() > 0 && packet.firstTimeUs() < payload.lastUs()) {
      writeEvents();
    }
    if (size > 0) {
      samples.reached(packet.lastTimeUs());
    }
    while (from < size) {
      from = payload.append(packet, from, size);
      if (payload.events() == EventPayload.MAX_EVENTS) {
        writeEvents();
      }
    }
  }

  /**
   * Writes a frame, an inertial sample or a trigger, if the options include its kind.
   *
   * @return false for another kind, and for samples that the format cannot represent
   */
  @Override
  public boolean write(SensorSample sample) throws IOException {
    requireUnfinished();
    return samples.add(sample);
  }

  private void requireUnfinished() {
    if (finished) {
      throw new IllegalStateException(path + " is complete; nothing can be added to it");
    }
  }

  private void writeSamples(int stream, byte[] sample, int elements, long firstUs, long lastUs)
      throws IOException {
    byte[] bytes = compressor.pack(sample);
    long start = output.position() + PacketWalk.HEADER_BYTES;
    table.add(stream, start, bytes.length, elements, firstUs, lastUs);
    writePacket(stream, bytes, bytes.length);
  }

  /**
   * Writes the events and samples so far as packets, so that a reader finds them.
   *
   * @throws IOException if they cannot be written
   */
  @Override
  public void writeThrough() throws IOException {
    writeEvents();
    samples.flush();
    output.flush();
  }

  private void writeEvents() throws IOException {
    if (payload.events() == 0) {
      return;
    }
    int size = payload.complete();
    boolean asItIs = compression == Aedat4Compression.NONE;
    if (!asItIs) {
      size = compressor.pack(payload.bytes(), size, compressed, 0);
    }
    long start = output.position() + PacketWalk.HEADER_BYTES;
    table.add(0, start, size, payload.events(), payload.firstUs(), payload.lastUs());
    payload.clear();
    writePacket(0, asItIs ? payload.bytes() : compressed, size);
  }

  private void writePacket(int stream, byte[] bytes, int size) throws IOException {
    LittleEndian.putInt(packetHeader, 0, stream);
    LittleEndian.putInt(packetHeader, 4, size);
    output.write(packetHeader, 0, packetHeader.length);
    output.write(bytes, 0, size);
    if (inPlace) {
      output.flush();
      packetsEnd = output.position();
    }
  }

  @Override
  public List<String> losses() {
    List<String> lines = new ArrayList<>(WriterLosses.outside(payload.outside(), geometry));
    if (samples.channelsLost() > 0) {
      lines.add(
          samples.channelsLost()
              + " triggers are of other inputs than the first, which the format does not store");
    }
    return lines;
  }

  @Override
  public void finish() throws IOException {
    requireUnfinished();
    writeEvents();
    samples.flush();
    long tablePosition = output.position();
    byte[] compressedTable = compressor.pack(table.toBytes());
    output.write(compressedTable, 0, compressedTable.length);
    output.flush();
    byte[] patch = new byte[8];
    LittleEndian.putLong(patch, 0, tablePosition);
    output.writeAt(ByteBuffer.wrap(patch), Aedat4Header.TABLE_POSITION_OFFSET);
    commit.run();
    finished = true;
  }

  @Override
  public void close() throws IOException {
    compressor.close();
    try (owner) {
      if (inPlace && !finished && channel.isOpen()) {
        // the failed write may have left a partial packet
        channel.truncate(packetsEnd);
      }
    }
  }
}
