package haltere.testing.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.hdf5.Hdf5Writer;
import haltere.testing.EventPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * h5py and evutils read every event of what we write, and we of what h5py stores in each of its
 * ways. Needs {@link PythonPrograms}; skipped without.
 */
class Hdf5PeersTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260, Origin.TOP);
  private static final int EVENTS = 150_000;

  /** Fewer events have chunks of three in one of the files that h5py writes. */
  private static final int THEIR_EVENTS = 40_000;

  @TempDir Path folder;
  private PythonPrograms peers;

  @BeforeEach
  void findPeers() throws IOException {
    peers = PythonPrograms.orSkip("hdf5.py", folder);
  }

  private static EventPacket events(int count) {
    return EventPackets.uniform(SENSOR, 12, count, 1_718_925_184_590_631L, 15);
  }

  @Test
  void writtenEventsAndMillisecondIndexAreReadByTwoOtherPrograms() throws IOException {
    EventPacket events = events(EVENTS);
    StreamRecorder recorder = new StreamRecorder();
    recorder.packet(events);
    String facts = " " + EVENTS + " " + recorder.crc32(SENSOR);
    List<String> command = new ArrayList<>(List.of("read"));
    List<String> expected = new ArrayList<>();
    for (int level : new int[] {0, Hdf5Writer.DEFAULT_LEVEL}) {
      Path file = folder.resolve("ours-" + level + ".h5");
      try (RecordingWriter writer = Hdf5Writer.create(file, WriteOptions.of(SENSOR), level)) {
        for (EventPacket part : EventPackets.cut(events, 3)) {
          writer.write(part);
        }
        writer.finish();
      }
      command.add(file.toString());
      expected.add("h5py" + facts);
      expected.add("evutils" + facts);
      assertTrue(peers.run("index", file.toString()).isPresent(), "ms_to_idx of level " + level);
    }
    assertEquals(Optional.of(expected), peers.run(command.toArray(String[]::new)));
  }

  @Test
  void eventsAreReadFromEveryStorageLayoutOfH5py() throws IOException {
    EventPacket events = events(THEIR_EVENTS);
    ByteBuffer rows = ByteBuffer.allocate(THEIR_EVENTS * 32).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < THEIR_EVENTS; i++) {
      rows.putLong(events.timeUs(i)).putLong(events.x(i));
      rows.putLong(SENSOR.height() - 1 - events.y(i)).putLong(events.isOn(i) ? 1 : 0);
    }
    Path raw = Files.write(folder.resolve("events.bin"), rows.array());
    Path theirs = Files.createDirectory(folder.resolve("theirs"));
    assertTrue(peers.run("write", raw.toString(), "346", "260", theirs.toString()).isPresent());
    List<Path> files;
    try (Stream<Path> listed = Files.list(theirs)) {
      files = listed.sorted().toList();
    }
    assertTrue(files.size() > 30, files.toString());
    for (Path file : files) {
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(SENSOR, reader.geometry());
        reader.drainTo(recorder);
        assertEquals(List.of(), reader.violations().describe());
      }
      assertEquals(events, recorder.events(), file.getFileName().toString());
    }
  }
}
