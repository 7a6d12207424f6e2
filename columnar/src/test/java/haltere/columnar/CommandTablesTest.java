package haltere.columnar;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The installed program writes the same tables in Parquet as in CSV. */
class CommandTablesTest {
  private static final Path PROGRAM = Path.of(System.getProperty("haltere.installed"));

  @TempDir static Path folder;

  /** Runs a command that must succeed, and says no more than it should. */
  private static void haltere(Object... args) throws IOException, InterruptedException {
    assertEquals("", messagesOf(0, args));
  }

  private static String messagesOf(int status, Object... args)
      throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(PROGRAM.resolve("bin/haltere").toString()));
    Stream.of(args).map(Object::toString).forEach(command::add);
    command.add("--quiet");
    Path errors = folder.resolve("errors.txt");
    ProcessBuilder builder = new ProcessBuilder(command).redirectError(errors.toFile());
    builder.redirectOutput(ProcessBuilder.Redirect.DISCARD);
    builder.environment().put("JAVA_HOME", System.getProperty("java.home"));
    builder.environment().put("JAVA_OPTS", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC");
    Process process = builder.start();
    assertTrue(process.waitFor(2, TimeUnit.MINUTES), command::toString);
    String text = Files.readString(errors);
    assertEquals(status, process.exitValue(), text);
    return text;
  }

  @BeforeAll
  static void simulate() throws Exception {
    Files.createDirectories(folder.resolve("in"));
    haltere("simulate", "dots", folder.resolve("in/dots.aedat"), "--duration", "0.25");
    haltere("simulate", "fly", folder.resolve("in/fly.aedat"), "--duration", "0.25");
  }

  /** The same rows: numbers within the digits of the text, texts the same. */
  private static void assertSame(Path csv, Path parquet) throws IOException {
    List<String> lines = Files.readAllLines(csv);
    ParquetTables.Content content = ParquetTables.read(parquet);
    assertEquals(lines.get(0), String.join(",", content.columns()));
    assertEquals(lines.size() - 1, content.rows().size());
    assertFalse(content.rows().isEmpty(), "no row to compare in " + csv);
    for (int row = 0; row < content.rows().size(); row++) {
      String[] fields = lines.get(row + 1).split(",", -1);
      for (int column = 0; column < fields.length; column++) {
        assertSame(fields[column], content.rows().get(row).get(column), csv + " row " + row);
      }
    }
  }

  private static void assertSame(String text, Object value, String where) {
    if (value instanceof Double || value instanceof Float) {
      int point = text.indexOf('.');
      int decimals = point < 0 ? 0 : text.length() - point - 1;
      double exact = ((Number) value).doubleValue();
      double tolerance = text.contains("E") ? 0 : 0.5000001 * Math.pow(10, -decimals);
      assertEquals(Double.parseDouble(text), exact, tolerance, where);
    } else {
      assertEquals(text, value == null ? "" : value.toString(), where);
    }
  }

  @Test
  void wingAndBeatTablesMatchCsvAndNameTheirRecording() throws Exception {
    Path fly = folder.resolve("in/fly.aedat");
    for (String ending : List.of(".csv", ".parquet")) {
      haltere(
          "wings",
          fly,
          "--out",
          folder.resolve("wings" + ending),
          "--beats",
          folder.resolve("beats" + ending));
    }
    assertSame(folder.resolve("wings.csv"), folder.resolve("wings.parquet"));
    assertSame(folder.resolve("beats.csv"), folder.resolve("beats.parquet"));
    Map<String, String> metadata = ParquetTables.read(folder.resolve("wings.parquet")).metadata();
    assertTrue(metadata.get("haltere.program").startsWith("haltere "));
    assertEquals("fly.aedat", metadata.get("haltere.recording"));
    assertEquals(
        haltere.core.pipeline.internal.Checksums.of(fly), metadata.get("haltere.recordingSha256"));
    assertTrue(metadata.get("haltere.chain").contains("wing-tracker"));
    assertTrue(metadata.get("haltere.units").contains("\"frequency_hz\" : \"Hz\""));
  }

  @Test
  void trackTableMatchesCsv() throws Exception {
    for (String ending : List.of(".csv", ".parquet")) {
      haltere("track", folder.resolve("in/dots.aedat"), "--out", folder.resolve("tracks" + ending));
    }
    assertSame(folder.resolve("tracks.csv"), folder.resolve("tracks.parquet"));
  }

  @Test
  void eventTableMatchesCsv() throws Exception {
    for (String ending : List.of(".csv", ".parquet")) {
      Path out = folder.resolve("events" + ending);
      haltere("convert", folder.resolve("in/dots.aedat"), out, "--origin", "top", "--to", 200_000);
    }
    assertSame(folder.resolve("events.csv"), folder.resolve("events.parquet"));
    Map<String, String> metadata = ParquetTables.read(folder.resolve("events.parquet")).metadata();
    assertEquals("dots.aedat", metadata.get("haltere.recording"));
    assertEquals("top", metadata.get("haltere.rows"));
    assertTrue(metadata.get("haltere.sensor").matches("\\d+x\\d+"), metadata.toString());
    Path again = folder.resolve("events.parquet");
    assertTrue(
        messagesOf(1, "convert", folder.resolve("in/dots.aedat"), again).contains("--overwrite"));
  }

  @Test
  void outletTablesOfASavedChainMatchCsv() throws Exception {
    Path chain = folder.resolve("chain.json");
    Files.writeString(chain, "{\"filters\": [{\"filter\": \"object-tracker\"}]}");
    for (String format : List.of("csv", "parquet")) {
      haltere(
          "run",
          folder.resolve("in/dots.aedat"),
          "--chain",
          chain,
          "--out",
          folder.resolve("left-" + format + ".aedat"),
          "--tables",
          format);
    }
    assertSame(
        folder.resolve("left-csv.object-tracker.objects.csv"),
        folder.resolve("left-parquet.object-tracker.objects.parquet"));
  }

  @Test
  void orientationAndSimulationTablesMatchCsv() throws Exception {
    for (String ending : List.of(".csv", ".parquet")) {
      haltere(
          "simulate",
          "flight",
          folder.resolve("flight" + ending.replace('.', '-') + ".aedat"),
          "--duration",
          "0.3",
          "--truth",
          folder.resolve("truth" + ending),
          "--observations",
          folder.resolve("seen" + ending),
          "--cameras",
          folder.resolve("cameras" + ending + ".json"));
      haltere(
          "orient",
          folder.resolve("seen.csv"),
          "--cameras",
          folder.resolve("cameras.csv.json"),
          "--out",
          folder.resolve("orientation" + ending));
    }
    for (String table : List.of("truth", "seen", "orientation")) {
      assertSame(folder.resolve(table + ".csv"), folder.resolve(table + ".parquet"));
    }
  }

  @Test
  void batchTablesAreIdenticalWhateverTheNumberOfWorkers() throws Exception {
    for (int workers : new int[] {1, 2}) {
      haltere(
          "batch",
          folder.resolve("in"),
          "--wings",
          "--format",
          "parquet",
          "--workers",
          workers,
          "--out",
          folder.resolve("batch" + workers));
    }
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder.resolve("batch1"))) {
      files = all.filter(Files::isRegularFile).toList();
    }
    assertTrue(files.size() > 4, files::toString);
    for (Path file : files) {
      assertFalse(file.toString().endsWith(".csv"));
      Path other = folder.resolve("batch2").resolve(folder.resolve("batch1").relativize(file));
      assertArrayEquals(Files.readAllBytes(file), Files.readAllBytes(other), file.toString());
    }
    haltere("batch", folder.resolve("in"), "--wings", "--out", folder.resolve("batch"));
    assertSame(
        folder.resolve("batch/fly.aedat/wing-tracker.wings.csv"),
        folder.resolve("batch1/fly.aedat/wing-tracker.wings.parquet"));
  }

  @Test
  void missingFolderIsReportedInOneLine() throws Exception {
    String messages =
        messagesOf(
            1,
            "track",
            folder.resolve("in/dots.aedat"),
            "--out",
            folder.resolve("none/tracks.parquet"));
    assertTrue(messages.contains("there is no folder"), messages);
    assertEquals(1, messages.lines().count(), messages);
  }
}
