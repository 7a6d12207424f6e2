package haltere.core.format.internal.hdf5;

import haltere.core.event.EventAddress;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.format.internal.decoding.WriterLosses;
import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Writes HDF5 of the DSEC kind: {@code events/t} (microseconds since {@code t_offset}), {@code
 * events/x}, {@code events/y}, {@code events/p}, and {@code ms_to_idx}, the index of the first
 * event at or after each millisecond since {@code t_offset}; its last number is the number of
 * events. The root group states {@code width}, {@code height} and {@code rows_up}.
 *
 * <p>Memory is bounded: a chunk of each column, and 16 bytes for each chunk of 65,536 events.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class Hdf5Writer implements RecordingWriter {
  /** Compression level of {@link Hdf5Format}. */
  public static final int DEFAULT_LEVEL = 1;

  /** Longer recordings have no index of milliseconds: 18 hours. */
  private static final long MAX_MILLISECONDS = 1 << 26;

  private static final int MAX_LEVEL = 9;

  private final AtomicFile file;
  private final SensorGeometry geometry;
  private final boolean fromTop;
  private final ChunkedColumn times;
  private final ChunkedColumn x;
  private final ChunkedColumn y;
  private final ChunkedColumn on;
  private final ChunkedColumn index =
      new ChunkedColumn("ms_to_idx", ElementType.whole(8, false), DEFAULT_LEVEL);

  private boolean started;
  private long offsetUs;
  private long lastUs;

  /** Whether the index of milliseconds is still possible. */
  private boolean indexed = true;

  /** Time since the offset of the next millisecond without a known first event. */
  private long nextMillisecondUs;

  private long outside;

  private Hdf5Writer(AtomicFile file, WriteOptions options, int level) throws IOException {
    this.file = file;
    geometry = options.geometry();
    fromTop = options.origin().orElse(geometry.origin()) == Origin.TOP;
    times = new ChunkedColumn("t", ElementType.whole(8, true), level);
    x = new ChunkedColumn("x", ElementType.whole(2, false), level);
    y = new ChunkedColumn("y", ElementType.whole(2, false), level);
    on = new ChunkedColumn("p", ElementType.whole(1, false), level);
    file.channel().position(Hdf5Structure.BYTES);
  }

  /**
   * Starts a file.
   *
   * @param path path of the file
   * @param options the writer's options
   * @param level level of deflate (which every HDF5 program supports): 0 uncompressed, 1 fast to 9
   *     slow
   * @return a writer without events
   * @throws IOException if the file cannot be created
   */
  public static Hdf5Writer create(Path path, WriteOptions options, int level) throws IOException {
    if (level < 0 || level > MAX_LEVEL) {
      throw new IllegalArgumentException("levels are 0 to " + MAX_LEVEL + ", not " + level);
    }
    AtomicFile file = AtomicFile.create(path, options.overwrite());
    try {
      return new Hdf5Writer(file, options, level);
    } catch (IOException e) {
      file.close();
      throw e;
    }
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    file.requireUncommitted();
    int size = packet.size();
    int done = 0;
    while (done < size) {
      if (!started) {
        started = true;
        offsetUs = Math.floorDiv(packet.timeUs(0), 1000L) * 1000;
        lastUs = packet.timeUs(0);
      }
      int filled = times.filled();
      int count = Math.min(size - done, ChunkedColumn.CHUNK_ROWS - filled);
      int taken = take(packet, done, count, filled);
      done += count;
      times.setFilled(filled + taken, file);
      x.setFilled(filled + taken, file);
      y.setFilled(filled + taken, file);
      on.setFilled(filled + taken, file);
    }
  }

  private int take(EventPacket packet, int from, int count, int filled) throws IOException {
    int top = geometry.height() - 1;
    int at = filled;
    long before = times.rows() - filled;
    byte[] timeBytes = times.chunk();
    byte[] xBytes = x.chunk();
    byte[] yBytes = y.chunk();
    byte[] onBytes = on.chunk();
    long[] timesUs = packet.timesUs();
    int[] addresses = packet.addresses();
    for (int i = from; i < from + count; i++) {
      long timeUs = timesUs[i];
      int address = addresses[i];
      int column = EventAddress.x(address);
      int row = EventAddress.y(address);
      if (!geometry.contains(column, row)) {
        outside++;
        continue;
      }
      long sinceUs = timeUs - offsetUs;
      if (timeUs < lastUs || sinceUs < 0) {
        indexed = false;
      } else if (sinceUs >= nextMillisecondUs && indexed) {
        index(sinceUs, before + at);
      }
      lastUs = timeUs;
      LittleEndian.putLong(timeBytes, 8 * at, sinceUs);
      LittleEndian.putShort(xBytes, 2 * at, column);
      LittleEndian.putShort(yBytes, 2 * at, fromTop ? top - row : row);
      onBytes[at] = (byte) (address & EventAddress.ON_BIT);
      at++;
    }
    return at - filled;
  }

  /** Sets the first event of the milliseconds up to a time to a row. */
  private void index(long sinceUs, long row) throws IOException {
    if (sinceUs / 1000 >= MAX_MILLISECONDS) {
      indexed = false;
      return;
    }
    while (nextMillisecondUs <= sinceUs) {
      index.append(row, file);
      nextMillisecondUs += 1000;
    }
  }

  @Override
  public List<String> losses() {
    return WriterLosses.outside(outside, geometry);
  }

  @Override
  public void finish() throws IOException {
    file.requireUncommitted();
    Map<ChunkedColumn, Long> events = new LinkedHashMap<>();
    Map<ChunkedColumn, Long> beside = new LinkedHashMap<>();
    if (indexed) {
      index.append(times.rows(), file);
      index.end(file);
      beside.put(index, index.writeTree(file));
    }
    List<ChunkedColumn> columns = List.of(on, times, x, y);
    for (ChunkedColumn column : columns) {
      column.end(file);
    }
    for (ChunkedColumn column : columns) {
      events.put(column, column.writeTree(file));
    }
    long end = file.channel().position();
    Map<String, Long> attributes = new LinkedHashMap<>();
    attributes.put(EventTable.WIDTH, (long) geometry.width());
    attributes.put(EventTable.HEIGHT, (long) geometry.height());
    attributes.put(EventTable.ROWS_UP, fromTop ? 0L : 1L);
    file.channel().position(0);
    file.write(Hdf5Structure.of(end, attributes, offsetUs, events, beside));
    file.commit();
  }

  @Override
  public void close() throws IOException {
    for (ChunkedColumn column : List.of(times, x, y, on, index)) {
      column.close();
    }
    file.close();
  }
}
