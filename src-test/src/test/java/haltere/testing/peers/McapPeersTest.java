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
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * The Python packages mcap and rosbags read every event of the MCAP files that we write, and find
 * their checksums and indexes right.
 */
class McapPeersTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260, Origin.TOP);

  @TempDir Path folder;

  @Test
  void writtenEventsAreReadByTwoOtherPrograms() throws IOException {
    PythonPrograms programs = PythonPrograms.orSkip("mcap_bag.py", folder);
    EventPacket events = EventPackets.uniform(SENSOR, 12, 30_000, 1_718_925_184_590_631L, 40);
    Path file = folder.resolve("ours.mcap");
    try (RecordingWriter writer =
        Recordings.forWriting(file).create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      for (EventPacket part : EventPackets.cut(events, 3)) {
        writer.write(part);
      }
      writer.finish();
    }
    StreamRecorder recorder = new StreamRecorder();
    recorder.packet(events);
    String facts = events.size() + " " + recorder.crc32(SENSOR);
    assertEquals(
        Optional.of(List.of("mcap " + facts, "rosbags " + facts)),
        programs.run("read", file.toString()));
  }
}
