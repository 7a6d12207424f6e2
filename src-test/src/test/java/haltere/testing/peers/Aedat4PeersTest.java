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
import haltere.core.format.aedat4.Aedat4Compression;
import haltere.core.format.aedat4.Aedat4Writer;
import haltere.testing.EventPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * dv-processing and aedat read every event of what we write, and we of what dv-processing writes.
 * Needs a Python that has both: the one that the environment's HALTERE_PEERS names, else the one in
 * build/peers, where the continuous build installs them; skipped without.
 */
class Aedat4PeersTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260, Origin.TOP);
  private static final int EVENTS = 30_000;

  @TempDir Path folder;
  private Path script;

  @BeforeEach
  void findPeers() throws IOException {
    script = folder.resolve("aedat4.py");
    try (InputStream in = Aedat4PeersTest.class.getResourceAsStream("/peers/aedat4.py")) {
      Files.copy(in, script);
    }
    Assumptions.assumeTrue(
        Files.isExecutable(python()) && run("check").isPresent(),
        "there is no Python with dv-processing and aedat (HALTERE_PEERS names one)");
  }

  private static Path python() {
    String named = System.getenv("HALTERE_PEERS");
    return named != null ? Path.of(named) : Path.of("../build/peers/bin/python3");
  }

  /** Lines that the script printed, empty if it failed. */
  private Optional<List<String>> run(String... arguments) throws IOException {
    List<String> command = new ArrayList<>(List.of(python().toString(), script.toString()));
    command.addAll(Arrays.asList(arguments));
    Path errors = folder.resolve("errors.txt");
    Process process = new ProcessBuilder(command).redirectError(errors.toFile()).start();
    try (InputStream out = process.getInputStream()) {
      String text = new String(out.readAllBytes(), StandardCharsets.UTF_8);
      boolean done = process.waitFor(60, TimeUnit.SECONDS) && process.exitValue() == 0;
      return done ? Optional.of(text.lines().toList()) : Optional.empty();
    } catch (InterruptedException e) {
      throw new IOException(e);
    } finally {
      process.destroy();
    }
  }

  private static EventPacket events() {
    return EventPackets.uniform(SENSOR, 11, EVENTS, 1_718_925_184_590_631L, 15);
  }

  private static StreamRecorder record(EventPacket events) {
    StreamRecorder recorder = new StreamRecorder();
    recorder.packet(events);
    return recorder;
  }

  @Test
  void twoOtherProgramsReadEveryEventThatWeWrite() throws IOException {
    EventPacket events = events();
    List<String> command = new ArrayList<>(List.of("read"));
    List<String> expected = new ArrayList<>();
    String facts = " " + EVENTS + " " + record(events).crc32(SENSOR);
    for (Aedat4Compression compression : Aedat4Compression.values()) {
      Path file = folder.resolve("ours-" + compression + ".aedat4");
      try (RecordingWriter writer =
          Aedat4Writer.create(file, WriteOptions.of(SENSOR), compression)) {
        for (EventPacket part : EventPackets.cut(events, 3)) {
          writer.write(part);
        }
        writer.finish();
      }
      command.add(file.toString());
      expected.add("dv-processing" + facts);
      expected.add("aedat" + facts);
    }
    assertEquals(Optional.of(expected), run(command.toArray(String[]::new)));
  }

  @Test
  void weReadEveryEventThatAnotherProgramWrites() throws IOException {
    EventPacket events = events();
    ByteBuffer rows = ByteBuffer.allocate(EVENTS * 32).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < EVENTS; i++) {
      rows.putLong(events.timeUs(i)).putLong(events.x(i));
      rows.putLong(SENSOR.height() - 1 - events.y(i)).putLong(events.isOn(i) ? 1 : 0);
    }
    Path raw = Files.write(folder.resolve("events.bin"), rows.array());
    String target = folder.resolve("theirs").toString();
    assertTrue(run("write", raw.toString(), "346", "260", target).isPresent());
    for (Aedat4Compression compression : Aedat4Compression.values()) {
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          Recordings.open(Path.of(target + "-" + compression + ".aedat4"))) {
        assertEquals(SENSOR, reader.geometry());
        reader.drainTo(recorder);
        assertEquals(List.of(), reader.violations().describe());
      }
      assertEquals(events, recorder.events(), compression.toString());
    }
  }
}
