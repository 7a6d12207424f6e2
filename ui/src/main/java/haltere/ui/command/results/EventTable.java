package haltere.ui.command.results;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.pipeline.internal.Provenance;
import haltere.core.sink.Column;
import haltere.core.sink.TableSink;
import haltere.core.sink.Tables;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Optional;

/**
 * A table of the events of a recording, with the columns of text. In the metadata, {@code
 * haltere.sensor} is the sensor's size and {@code haltere.rows} the origin of the rows.
 *
 * <p>Thread rule: one thread at a time.
 */
public final class EventTable implements RecordingWriter {
  /**
   * An event.
   *
   * @param timeUs time on the recording's clock, microseconds
   * @param x column
   * @param y row
   * @param on 1 for ON, 0 for OFF
   */
  public record Row(@Column("t_us") long timeUs, int x, int y, int on) {}

  private final SensorGeometry geometry;
  private final boolean fromTop;
  private final TableSink<Row> table;

  /**
   * Starts a table.
   *
   * @param file where it will be
   * @param overwrite whether a file that is there may be replaced
   * @param geometry the sensor
   * @param origin where rows are to count from; empty for that of the recording
   * @param metadata gets the sensor and the origin
   * @throws IOException if the format is missing, or the file cannot be written
   */
  public EventTable(
      Path file,
      boolean overwrite,
      SensorGeometry geometry,
      Optional<Origin> origin,
      Provenance metadata)
      throws IOException {
    this.geometry = geometry;
    fromTop = origin.orElse(geometry.origin()) == Origin.TOP;
    metadata.with("haltere.sensor", geometry::toString);
    metadata.with("haltere.rows", () -> fromTop ? "top" : "bottom");
    table = Tables.create(file, Row.class, overwrite, metadata);
  }

  @Override
  public void write(EventPacket packet) throws IOException {
    int top = geometry.height() - 1;
    try {
      for (int i = 0; i < packet.size(); i++) {
        int y = fromTop ? top - packet.y(i) : packet.y(i);
        table.accept(new Row(packet.timeUs(i), packet.x(i), y, packet.isOn(i) ? 1 : 0));
      }
    } catch (UncheckedIOException problem) {
      throw problem.getCause();
    }
  }

  @Override
  public void finish() throws IOException {
    table.finish();
  }

  @Override
  public void close() throws IOException {
    table.close();
  }
}
