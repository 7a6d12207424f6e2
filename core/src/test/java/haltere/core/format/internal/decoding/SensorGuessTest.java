package haltere.core.format.internal.decoding;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Guess of an unstated sensor size. */
class SensorGuessTest {
  private static final int EVENTS = 1_100_000;

  @TempDir Path folder;

  @Test
  void guessedSensorContainsLateEvents() throws IOException {
    ByteBuffer records = ByteBuffer.allocate(5 * EVENTS);
    for (int i = 0; i < EVENTS; i++) {
      boolean isLast = i == EVENTS - 1;
      records.put((byte) (isLast ? 230 : i % 34)).put((byte) (isLast ? 170 : i % 30));
      records.put((byte) (i >> 16)).put((byte) (i >> 8)).put((byte) i);
    }
    Path file = Files.write(folder.resolve("events.bin"), records.array());
    try (RecordingReader reader = Recordings.open(file)) {
      StreamRecorder recorder = new StreamRecorder();
      reader.drainTo(recorder);
      assertEquals(new SensorGeometry(240, 180, Origin.TOP), reader.geometry());
      assertEquals(EVENTS, recorder.events().size());
      assertEquals(0, reader.violations().count(Violation.OUTSIDE_SENSOR));
    }
  }
}
