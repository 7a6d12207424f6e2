package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.internal.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

@Timeout(120)
class RecordCommandTest {
  @TempDir Path folder;

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  private static Map<?, ?> info(Path file) throws IOException {
    CommandRun run = CommandRun.of("info", "--json", file);
    assertEquals(0, run.status(), run.err());
    return (Map<?, ?>) Json.parse(run.out(), "info");
  }

  @Test
  void devicesListsSimulatedCamerasAfterPhysicalOnes() throws IOException {
    CommandRun text = CommandRun.of("devices");
    assertEquals(0, text.status(), text.err());
    assertTrue(text.out().lines().anyMatch(line -> line.startsWith("simulated:fly ")), text.out());
    CommandRun json = CommandRun.of("devices", "--json");
    assertEquals(0, json.status(), json.err());
    List<?> devices = (List<?>) ((Map<?, ?>) Json.parse(json.out(), "devices")).get("devices");
    Map<?, ?> last = (Map<?, ?>) devices.get(devices.size() - 1);
    assertEquals("simulated:road", last.get("id"));
    assertEquals(128L, last.get("width"));
    assertEquals(true, last.get("canOpen"));
    assertEquals("", last.get("serial"));
    assertTrue(last.containsKey("model") && last.containsKey("note"));
  }

  @Test
  void cameraIsRecordedWithItsBiasesAndReadBack() throws IOException {
    Path out = folder.resolve("fly.aedat4");
    CommandRun run =
        CommandRun.of(
            "record",
            "--device",
            "simulated:fly",
            out,
            "--duration",
            "0.4",
            "--biases",
            "fast",
            "--bias",
            "threshold=0.3");
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("recording simulated:fly to " + out), run.err());
    assertTrue(run.err().contains("wrote " + out + " ("), run.err());
    assertEquals(List.of("fly.aedat4"), names());
    Map<?, ?> info = info(out);
    assertEquals("aedat4", info.get("format"));
    assertTrue((Long) info.get("events") > 0);
    Map<?, ?> metadata = (Map<?, ?>) info.get("metadata");
    assertEquals("0.3 ln", metadata.get("camera.bias.threshold"));
    assertEquals("10000.0 Hz", metadata.get("camera.bias.bandwidthHz"));
    assertEquals("simulated:fly", metadata.get("camera"));
    assertTrue(Long.parseLong((String) metadata.get("clockOffsetUs")) > 1e15);
    CommandRun text = CommandRun.of("info", out);
    assertTrue(text.out().contains("camera.bias.threshold  0.3 ln"), text.out());
  }

  @Test
  void chainFiltersAndIsSavedInTheHeader() throws IOException {
    Path out = folder.resolve("fly.aedat4");
    Path chain = folder.resolve("chain.json");
    Files.writeString(chain, "{\"filters\": [{\"filter\": \"background-activity\"}]}");
    CommandRun run =
        CommandRun.of(
            "record", "--device", "simulated:road", out, "--duration", "0.2", "--chain", chain);
    assertEquals(0, run.status(), run.err());
    String saved = (String) ((Map<?, ?>) info(out).get("metadata")).get("chain");
    List<?> filters = (List<?>) ((Map<?, ?>) Json.parse(saved, "chain")).get("filters");
    assertEquals("background-activity", ((Map<?, ?>) filters.get(0)).get("filter"));
  }

  @Test
  void twoCamerasHaveSeparateFilesWithRelatedClocks() throws IOException {
    Path out = folder.resolve("both.aedat4");
    CommandRun run =
        CommandRun.of(
            "record",
            "--device",
            "simulated:fly",
            "--device",
            "simulated:road",
            out,
            "--duration",
            "0.3");
    assertEquals(0, run.status(), run.err());
    assertEquals(List.of("both.simulated-fly.aedat4", "both.simulated-road.aedat4"), names());
    assertTrue(run.err().contains("the clock of simulated:road is "), run.err());
    for (String name : names()) {
      Map<?, ?> metadata = (Map<?, ?>) info(folder.resolve(name)).get("metadata");
      assertTrue(Long.parseLong((String) metadata.get("clockOffsetUs")) > 1e15, name);
    }
  }

  @Test
  void wrongArgumentsAreReportedBeforeTheCameraIsOpened() throws IOException {
    Path out = folder.resolve("fly.aedat4");
    for (List<String> wrong :
        List.of(
            List.of("--duration", "0"),
            List.of("--duration", "-1"),
            List.of("--bias", "threshold"),
            List.of("--max-size", "0.1"),
            List.of("--keep-free", "-1"),
            List.of("--when-full", "sometimes"),
            List.of("--device", "simulated:fly"))) {
      CommandRun run =
          CommandRun.of(
              Stream.concat(Stream.of("record", "--device", "simulated:fly", out), wrong.stream())
                  .toArray());
      assertEquals(2, run.status(), wrong + run.err());
    }
    CommandRun large = CommandRun.of("record", out, "--keep-free", "1e10");
    assertTrue(large.err().contains("it must be 0 to 1e9 MB"), large.err());
    CommandRun unnamed = CommandRun.of("record", folder.resolve("fly"));
    assertTrue(unnamed.err().contains("fly: its name has no ending"), unnamed.err());
    assertEquals(2, CommandRun.of("record", folder.resolve("fly.nothing")).status());
    assertEquals(
        2, CommandRun.of("record", folder.resolve("fly.csv"), "--max-size", "10").status());
    assertTrue(names().isEmpty());
  }

  @Test
  void simulationThatIsTooSlowIsNotReportedAsBrokenTransfers() {
    Path out = folder.resolve("rendered.aedat4");
    CommandRun run =
        CommandRun.of("record", "--device", "simulated:rendered-fly", out, "--duration", "1");
    assertEquals(0, run.status(), run.err());
    assertFalse(run.err().contains("transfers that were broken"), run.err());
  }

  @Test
  void failuresAreReportedInOneLine() throws IOException {
    Path out = folder.resolve("fly.aedat4");
    CommandRun unknown = CommandRun.of("record", "--device", "dvs128:none", out);
    assertEquals(1, unknown.status());
    assertEquals(1, unknown.errorLines().size(), unknown.err());
    assertTrue(unknown.err().contains("simulated:fly"), unknown.err());
    CommandRun bias =
        CommandRun.of("record", "--device", "simulated:fly", out, "--bias", "nothing=1");
    assertEquals(1, bias.status());
    assertTrue(bias.err().contains("there is no bias named nothing; there are threshold"));
    assertTrue(names().isEmpty());
    Files.writeString(folder.resolve("fly-2.aedat4"), "mine");
    CommandRun inTheWay = CommandRun.of("record", "--device", "simulated:fly", out);
    assertEquals(1, inTheWay.status());
    assertTrue(inTheWay.err().contains("fly-2.aedat4: exists already"), inTheWay.err());
    assertFalse(Files.exists(out));
  }

  @Test
  @Timeout(60)
  void fullDiskIsRejectedAtTheStartAndTheOldFileRemains() throws IOException {
    Files.writeString(folder.resolve("fly.aedat4"), "mine");
    CommandRun run =
        CommandRun.of(
            "record",
            "--device",
            "simulated:fly",
            folder.resolve("fly.aedat4"),
            "--overwrite",
            "--keep-free",
            "999999999");
    assertEquals(1, run.status());
    assertTrue(
        run.err().contains("(--keep-free); make room, or record to another disk"), run.err());
    assertFalse(run.err().contains("recording simulated:fly"), run.err());
    assertEquals("mine", Files.readString(folder.resolve("fly.aedat4")));
  }

  @Test
  void chainOnACameraWritesItsTables() throws IOException {
    Path chain = folder.resolve("chain.json");
    Files.writeString(chain, "{\"filters\": [{\"filter\": \"cluster-tracker\"}]}");
    CommandRun plain =
        CommandRun.of("run", "--device", "simulated:fly", "--chain", chain, "--duration", "0.2");
    assertEquals(0, plain.status(), plain.err());
    assertTrue(plain.out().contains("cluster-tracker"), plain.out());
    Path out = folder.resolve("left.aedat4");
    CommandRun run =
        CommandRun.of(
            "run",
            "--device",
            "simulated:fly",
            "--chain",
            chain,
            "--duration",
            "0.2",
            "--out",
            out,
            "--publish",
            "tcp://127.0.0.1:0");
    assertEquals(0, run.status(), run.err());
    assertEquals(
        List.of("chain.json", "left.aedat4", "left.cluster-tracker.clusters.csv"), names());
    assertEquals(
        2, CommandRun.of("run", out, "--device", "simulated:fly", "--chain", chain).status());
    assertEquals(2, CommandRun.of("run", "--chain", chain).status());
    assertEquals(2, CommandRun.of("run", out, "--chain", chain, "--bias", "a=1").status());
  }

  @Test
  void objectsOfACameraAreTracked() throws IOException {
    Path out = folder.resolve("tracks.csv");
    CommandRun run =
        CommandRun.of("track", "--device", "simulated:road", "--out", out, "--duration", "0.3");
    assertEquals(0, run.status(), run.err());
    assertTrue(Files.readAllLines(out).get(0).startsWith("t_us,id,x_px"), run.err());
    assertEquals(2, CommandRun.of("track", "--out", out, "--overwrite").status());
  }

  @Test
  void wingsOfACameraAreTracked() throws IOException {
    Path out = folder.resolve("wings.csv");
    CommandRun run =
        CommandRun.of("wings", "--device", "simulated:fly", "--out", out, "--duration", "0.3");
    assertEquals(0, run.status(), run.err());
    assertTrue(Files.readAllLines(out).get(0).startsWith("t_us,edge,angle_rad"), run.err());
    assertEquals(2, CommandRun.of("wings", "--out", out, "--overwrite").status());
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void terminatedRecordingLeavesACompleteFile() throws Exception {
    Path out = folder.resolve("fly.aedat4");
    Path program = Path.of(System.getProperty("haltere.installed"), "bin", "haltere");
    Process haltere =
        new ProcessBuilder(
                program.toString(), "record", "--device", "simulated:fly", out.toString())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .start();
    assertTrue(haltere.errorReader().readLine().startsWith("recording simulated:fly"));
    while (!Files.exists(out) || Files.size(out) < 50_000) {
      LockSupport.parkNanos(200_000);
      assertTrue(haltere.isAlive());
    }
    haltere.toHandle().destroy(); // the other way would close its streams
    assertTrue(haltere.waitFor(60, TimeUnit.SECONDS));
    assertEquals(0, haltere.exitValue());
    assertTrue(haltere.errorReader().lines().anyMatch(line -> line.startsWith("wrote " + out)));
    CommandRun strict = CommandRun.of("info", "--json", "--strict", out);
    assertEquals(0, strict.status(), strict.err());
    assertEquals("", strict.err());
  }
}
