package haltere.core.format.internal.npz;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.decoding.WriterLosses;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.LocalDateTime;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.CRC32;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;

/**
 * Writes a {@code .npz} as {@code numpy.savez} does, uncompressed: arrays {@code t} (microseconds,
 * 64 bits), {@code x}, {@code y} (16 bits) and {@code p} (1 for ON, 0 for OFF), and the single
 * values {@code width}, {@code height} and {@code rows_up}. A column is collected in a temporary
 * file, since an array starts with its length; memory is bounded.
 */
final class NpzWriter implements RecordingWriter {
  private static final int PIECE_EVENTS = 8192;
  private static final int COPY_BYTES = 256 * 1024;

  /** Constant, so that equal events result in equal bytes. */
  private static final LocalDateTime NO_DATE = LocalDateTime.of(1980, 1, 1, 0, 0);

  private final AtomicFile file;
  private final SensorGeometry geometry;
  private final boolean fromTop;
  private final List<ColumnFile> columns = new ArrayList<>();
  private final ColumnFile times;
  private final ColumnFile x;
  private final ColumnFile y;
  private final ColumnFile on;
  private long rows;
  private long outside;

  /** A column during writing. */
  private static final class ColumnFile {
    final String name;
    final String type;
    final Path path;
    final FileChannel channel;
    final ByteBuffer piece;

    ColumnFile(String name, String type, int bytes) throws IOException {
      this.name = name;
      this.type = type;
      path = Files.createTempFile("haltere-column", ".part");
      channel =
          FileChannel.open(
              path,
              StandardOpenOption.READ,
              StandardOpenOption.WRITE,
              StandardOpenOption.DELETE_ON_CLOSE);
      piece = ByteBuffer.allocateDirect(PIECE_EVENTS * bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    void flush() throws IOException {
      piece.flip();
      try {
        while (piece.hasRemaining()) {
          channel.write(piece);
        }
      } catch (IOException e) {
        throw RecordingProblem.writing(path, e);
      }
      piece.clear();
    }
  }

  NpzWriter(Path path, WriteOptions options) throws IOException {
    geometry = options.geometry();
    fromTop = options.origin().orElse(geometry.origin()) == Origin.TOP;
    file = AtomicFile.create(path, options.overwrite());
    try {
      times = column("t", "<i8", 8);
      x = column("x", "<u2", 2);
      y = column("y", "<u2", 2);
      on = column("p", "|u1", 1);
    } catch (IOException e) {
      close();
      throw e;
    }
  }

  private ColumnFile column(String name, String type, int bytes) throws IOException {
    ColumnFile column = new ColumnFile(name, type, bytes);
    columns.add(column);
    return column;
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    file.requireUncommitted();
    int top = geometry.height() - 1;
    int size = packet.size();
    for (int i = 0; i < size; i++) {
      int column = packet.x(i);
      int row = packet.y(i);
      if (!geometry.contains(column, row)) {
        outside++;
        continue;
      }
      times.piece.putLong(packet.timeUs(i));
      x.piece.putShort((short) column);
      y.piece.putShort((short) (fromTop ? top - row : row));
      on.piece.put((byte) (packet.isOn(i) ? 1 : 0));
      rows++;
      if (!on.piece.hasRemaining()) {
        flush();
      }
    }
  }

  private void flush() throws IOException {
    for (ColumnFile column : columns) {
      column.flush();
    }
  }

  @Override
  public List<String> losses() {
    return WriterLosses.outside(outside, geometry);
  }

  @Override
  public void finish() throws IOException {
    file.requireUncommitted();
    flush();
    ZipOutputStream zip = new ZipOutputStream(file.stream());
    zip.setMethod(ZipOutputStream.STORED);
    single(zip, NpzLayout.WIDTH, geometry.width());
    single(zip, NpzLayout.HEIGHT, geometry.height());
    single(zip, NpzLayout.ROWS_UP, fromTop ? 0 : 1);
    for (ColumnFile column : columns) {
      byte[] header = NpyHeader.of(column.type, rows + ",");
      CRC32 crc = new CRC32();
      crc.update(header);
      copy(column.channel, null, crc);
      entry(zip, column.name, header.length + column.channel.size(), crc);
      zip.write(header);
      copy(column.channel, zip, null);
      zip.closeEntry();
    }
    zip.finish();
    file.commit();
  }

  private static void single(ZipOutputStream zip, String name, long value) throws IOException {
    byte[] header = NpyHeader.of("<i8", "");
    byte[] bytes =
        ByteBuffer.allocate(header.length + 8)
            .order(ByteOrder.LITTLE_ENDIAN)
            .put(header)
            .putLong(value)
            .array();
    CRC32 crc = new CRC32();
    crc.update(bytes);
    entry(zip, name, bytes.length, crc);
    zip.write(bytes);
    zip.closeEntry();
  }

  private static void entry(ZipOutputStream zip, String name, long size, CRC32 crc)
      throws IOException {
    ZipEntry entry = new ZipEntry(name + ".npy");
    entry.setTimeLocal(NO_DATE);
    entry.setSize(size);
    entry.setCompressedSize(size);
    entry.setCrc(crc.getValue());
    zip.putNextEntry(entry);
  }

  private static void copy(FileChannel from, OutputStream to, CRC32 crc) throws IOException {
    byte[] piece = new byte[COPY_BYTES];
    from.position(0);
    java.io.InputStream in = Channels.newInputStream(from);
    for (int count = in.read(piece); count >= 0; count = in.read(piece)) {
      if (crc != null) {
        crc.update(piece, 0, count);
      } else {
        to.write(piece, 0, count);
      }
    }
  }

  @Override
  public void close() throws IOException {
    for (ColumnFile column : columns) {
      column.channel.close();
    }
    file.close();
  }
}
