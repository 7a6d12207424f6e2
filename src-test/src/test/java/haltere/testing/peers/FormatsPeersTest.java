package haltere.testing.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * faery, expelliarmus, evt3, event-stream, NumPy and Python itself read every event of what we
 * write: of each format at least two of them, of NumPy's own NumPy alone. Skipped without them, see
 * {@link PythonPrograms}.
 */
class FormatsPeersTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(640, 480, Origin.TOP);
  private static final int EVENTS = 30_000;

  /** Which programs read a file, by its ending. */
  private static final Map<String, List<String>> READERS =
      new TreeMap<>(
          Map.of(
              "evt2.raw", List.of("by_faery", "by_expelliarmus"),
              "evt3.raw", List.of("by_faery", "by_evt3"),
              "dat", List.of("by_faery", "by_expelliarmus"),
              "es", List.of("by_faery", "by_event_stream"),
              "csv", List.of("by_faery", "by_numpy", "by_python"),
              "npz", List.of("by_numpy")));

  @TempDir Path folder;

  /** Single events and runs of neighbours, across a turn of EVT3's clock. */
  private static EventPacket events() {
    SplittableRandom random = new SplittableRandom(12);
    EventPacket events = new EventPacket(EVENTS);
    long timeUs = (1 << 24) - 1_000_000;
    while (events.size() < EVENTS) {
      int x = random.nextInt(SENSOR.width());
      int y = random.nextInt(SENSOR.height());
      boolean on = random.nextBoolean();
      int run = random.nextInt(4) == 0 ? random.nextInt(1, 40) : 1;
      for (int i = 0; i < run && x < SENSOR.width() && events.size() < EVENTS; i++) {
        events.append(timeUs, x, y, on);
        x += random.nextInt(1, 3);
      }
      timeUs += random.nextInt(3) == 0 ? 0 : random.nextInt(2000);
    }
    return events;
  }

  private void write(Path file, String format, EventPacket events) throws IOException {
    try (RecordingWriter writer =
        Recordings.formats().get(format).create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      for (EventPacket part : EventPackets.cut(events, 4)) {
        writer.write(part);
      }
      assertEquals(List.of(), writer.losses());
      writer.finish();
    }
  }

  @Test
  void writtenEventsAreReadByOtherPrograms() throws IOException {
    PythonPrograms programs = PythonPrograms.orSkip("formats.py", folder);
    EventPacket events = events();
    StreamRecorder recorder = new StreamRecorder();
    recorder.packet(events);
    String facts = " " + EVENTS + " " + recorder.crc32(SENSOR);
    List<String> command = new ArrayList<>(List.of("read"));
    List<String> expected = new ArrayList<>();
    for (Map.Entry<String, List<String>> entry : READERS.entrySet()) {
      Path file = folder.resolve("ours." + entry.getKey());
      write(file, entry.getKey().split("\\.")[0], events);
      command.add(file.toString());
      for (String reader : entry.getValue()) {
        expected.add(file.getFileName() + " " + reader + facts);
      }
    }
    assertEquals(Optional.of(expected), programs.run(command.toArray(String[]::new)));
  }
}
