package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Support;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamGrammar;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;

/** Properties of a format under test, and its test files. */
abstract class TestedFormat {
  /** Files that the tests make. */
  @TempDir protected Path folder;

  /**
   * The format.
   *
   * @return the one that is tested
   */
  protected abstract RecordingFormat format();

  /**
   * Sensors of which the format can hold events.
   *
   * @return the smallest, the largest and the usual ones
   */
  protected abstract List<SensorGeometry> sensors();

  /**
   * The earliest time that the format can hold.
   *
   * @return microseconds
   */
  protected abstract long earliestUs();

  /**
   * A time that lies behind {@link #earliestUs()} and up to which the format can hold any time.
   *
   * @return microseconds
   */
  protected abstract long latestUs();

  /**
   * Creates a file of the format with its writer; read-only formats override this. Times may go
   * back from one packet to the next.
   *
   * @param file to create
   * @param sensor of the events
   * @param packets of the file
   * @throws IOException if that fails
   */
  protected void write(Path file, SensorGeometry sensor, EventPacket... packets)
      throws IOException {
    try (RecordingWriter writer = format().create(file, WriteOptions.of(sensor)).orElseThrow()) {
      for (EventPacket packet : packets) {
        writer.write(packet);
      }
      assertEquals(List.of(), writer.losses());
      writer.finish();
    }
  }

  /**
   * Whether each byte of a file belongs to an event or stands before one.
   *
   * @return false if something else, such as a table, follows the last event
   */
  protected boolean endsInEvents() {
    return true;
  }

  /**
   * Whether the format can store a clock that goes back.
   *
   * @return false for formats that store time differences only
   */
  protected boolean clockCanGoBack() {
    return true;
  }

  /**
   * How sure the format is of a file of its own.
   *
   * @return less than certain for formats without any mark
   */
  protected Support certainty() {
    return Support.CERTAIN;
  }

  /**
   * Options of the reader for a file of the format.
   *
   * @param sensor of its events
   * @return the options to read it with
   */
  protected ReadOptions options(SensorGeometry sensor) {
    return ReadOptions.DEFAULT;
  }

  /**
   * Files whose lengths, counts or sizes cannot be true, made from a true one.
   *
   * @param file bytes of a file with events of the first of {@link #sensors()}
   * @return damaged copies
   */
  protected abstract List<byte[]> lyingFiles(byte[] file);

  final SensorGeometry usualSensor() {
    return sensors().get(0);
  }

  static StreamRecorder read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(new StreamGrammar(recorder));
    return recorder;
  }

  final StreamRecorder read(Path file, ReadOptions options) throws IOException {
    try (RecordingReader reader = format().open(file, options)) {
      return read(reader);
    }
  }

  final EventPacket randomEvents(SensorGeometry sensor, long seed, int count) {
    return EventPackets.uniform(sensor, seed, count, 1_000_000 + 977 * seed, 37);
  }

  final Path file(String name) {
    return folder.resolve(name + "." + format().extensions().iterator().next());
  }
}
