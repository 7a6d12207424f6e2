package haltere.core.format.internal.csv;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.AtomicFile;
import haltere.core.format.RecordingWriter;
import haltere.core.format.WriteOptions;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;

/** Writes rows of text without an allocation per event. */
final class CsvWriter implements RecordingWriter {
  private static final int BUFFER_BYTES = 64 * 1024;
  private static final int MAX_ROW = 64;

  private static final String ROWS_UP =
      "rows count from the bottom, as in the source; most programs, including this "
          + "one, read text from the top: use --origin top for these";

  private final AtomicFile file;
  private final SensorGeometry geometry;
  private final boolean fromTop;

  /** Whether the origin of rows was not requested. */
  private final boolean isDefaultOrigin;

  private final byte[] bytes = new byte[BUFFER_BYTES];
  private final NumberText text = new NumberText();
  private int length;
  private boolean any;

  private CsvWriter(AtomicFile file, WriteOptions options) {
    this.file = file;
    geometry = options.geometry();
    fromTop = options.origin().orElse(geometry.origin()) == Origin.TOP;
    isDefaultOrigin = options.origin().isEmpty();
    byte[] head = "t_us,x,y,on\n".getBytes(StandardCharsets.US_ASCII);
    System.arraycopy(head, 0, bytes, 0, head.length);
    length = head.length;
  }

  static CsvWriter create(Path path, WriteOptions options) throws IOException {
    return new CsvWriter(options.create(path), options);
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    file.requireUncommitted();
    int top = geometry.height() - 1;
    int size = packet.size();
    any |= size > 0;
    for (int i = 0; i < size; i++) {
      if (length > BUFFER_BYTES - MAX_ROW) {
        flush();
      }
      int y = packet.y(i);
      int at = text.time(bytes, length, packet.timeUs(i));
      at = text.coordinate(bytes, at, packet.x(i));
      at = text.coordinate(bytes, at, fromTop ? top - y : y);
      bytes[at] = (byte) (packet.isOn(i) ? '1' : '0');
      bytes[at + 1] = '\n';
      length = at + 2;
    }
  }

  private void flush() throws IOException {
    file.write(ByteBuffer.wrap(bytes, 0, length));
    length = 0;
  }

  @Override
  public List<String> losses() {
    return any && isDefaultOrigin && !fromTop && geometry.height() > 1
        ? List.of(ROWS_UP)
        : List.of();
  }

  @Override
  public void finish() throws IOException {
    flush();
    file.commit();
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
