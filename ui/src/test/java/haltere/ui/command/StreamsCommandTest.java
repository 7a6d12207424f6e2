package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Recordings in pipes: {@code -} is standard input and output. */
class StreamsCommandTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128, Origin.TOP);

  /** More than a stream keeps of what it has read. */
  private static final int EVENTS = 400_000;

  @TempDir Path folder;

  private Path recording(String name, int events) throws IOException {
    Path file = folder.resolve(name);
    try (RecordingWriter writer =
        Recordings.forWriting(file).create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      writer.write(EventPackets.uniform(SENSOR, 1, events, 1000, 20));
      writer.finish();
    }
    return file;
  }

  private static CommandRun piped(byte[] input, Object... arguments) {
    return CommandRun.on(CommandRun.Machine.BARE.withInput(input), arguments);
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.es", "a.raw", "a.dat", "a.aedat", "a.csv"})
  void recordingPassesThroughAPipeUnchanged(String name) throws IOException {
    byte[] bytes = Files.readAllBytes(recording(name, EVENTS));
    CommandRun copy = piped(bytes, "convert", "-", "-", "--sensor", "128x128");
    assertEquals(0, copy.status(), copy.err());
    assertArrayEquals(bytes, copy.bytes());
    CommandRun info = piped(copy.bytes(), "info", "-", "--json", "--sensor", "128x128");
    assertEquals(0, info.status(), info.err());
    assertTrue(info.out().contains("\"events\" : " + EVENTS), info.out());
  }

  @Test
  void anyFormatIsWrittenToAPipeAndAPartAsText() throws IOException {
    Path file = recording("a.aedat4", 1000);
    CommandRun out = CommandRun.of("convert", file, "-");
    assertEquals(0, out.status(), out.err());
    assertTrue(out.out().startsWith("Event Stream"), out.out().substring(0, 20));
    CommandRun text =
        piped(out.bytes(), "convert", "-", "-", "--from", "2000", "--out-format", "csv");
    assertEquals(0, text.status(), text.err());
    CommandRun same = CommandRun.of("convert", file, folder.resolve("part.csv"), "--from", "2000");
    assertEquals(0, same.status(), same.err());
    assertEquals(Files.readString(folder.resolve("part.csv")), text.out());
  }

  @Test
  void truncatedStreamIsReadUpToTheLastCompleteEvent() throws IOException {
    byte[] bytes = Files.readAllBytes(recording("a.dat", 1000));
    CommandRun cut = piped(Arrays.copyOf(bytes, bytes.length - 3), "info", "-");
    assertEquals(0, cut.status(), cut.err());
    assertTrue(cut.out().contains("events      999"), cut.out());
    assertTrue(cut.err().contains("byte "), cut.err());
  }

  @Test
  void streamsThatNeedSeveralPassesAreRejectedWithAdvice() throws IOException {
    byte[] aedat4 = Files.readAllBytes(recording("a.aedat4", 100));
    CommandRun format = piped(aedat4, "info", "-");
    assertEquals(1, format.status());
    assertTrue(format.err().contains("save it to a file first"), format.err());
    byte[] csv = Files.readAllBytes(recording("a.csv", 100));
    CommandRun size = piped(csv, "info", "-");
    assertEquals(1, size.status());
    assertTrue(size.err().contains("--sensor WxH"), size.err());
    CommandRun nothing = piped(new byte[0], "info", "-");
    assertEquals(1, nothing.status());
    assertEquals(1, nothing.errorLines().size(), nothing.err());
    assertEquals(2, piped(csv, "info", "-", "--index").status());
    CommandRun unknown = piped(csv, "convert", "-", "-", "--out-format", "npz");
    assertEquals(2, unknown.status());
    assertTrue(unknown.err().contains("npz, it must be one of [aedat2, "), unknown.err());
    assertEquals(2, piped(csv, "convert", "-", "b.csv", "--out-format", "csv").status());
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void namedPipesAndDevicesAreRejectedAndNotReplaced() throws Exception {
    Path pipe = folder.resolve("pipe.aedat");
    assertEquals(0, new ProcessBuilder("mkfifo", pipe.toString()).start().waitFor());
    Path file = recording("a.es", 100);
    for (Path no : new Path[] {pipe, Path.of("/dev/zero")}) {
      CommandRun in = CommandRun.of("info", no);
      assertEquals(1, in.status());
      assertEquals(1, in.errorLines().size(), in.err());
      assertTrue(in.err().contains(no + ": this is a pipe or a device"), in.err());
      CommandRun out = CommandRun.of("run", file, "--chain", no);
      assertEquals(1, out.status());
      assertTrue(out.err().contains(no + ": "), out.err());
    }
    CommandRun replaced = CommandRun.of("convert", file, pipe, "--overwrite");
    assertEquals(1, replaced.status());
    assertTrue(replaced.err().contains("this is a pipe or a device"), replaced.err());
    assertTrue(Files.exists(pipe) && !Files.isRegularFile(pipe));
  }
}
