package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.internal.Json;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

class BatchCommandTest {
  private static final int KILLS = Integer.getInteger("haltere.kills", 12);

  @TempDir Path folder;

  private Path in;
  private Path chain;

  @BeforeEach
  void writeRecordingsAndChain() throws IOException {
    in = Files.createDirectories(folder.resolve("in/deep")).getParent();
    List<String> names = List.of("a.aedat", "b.es", "deep/c.raw", "deep/d.dat");
    for (int i = 0; i < names.size(); i++) {
      CommandRun made =
          CommandRun.of(
              "simulate",
              "dots",
              in.resolve(names.get(i)),
              "--duration",
              String.valueOf(0.1 * (i + 1)),
              "--truth",
              folder.resolve("truth" + i + ".csv"));
      assertEquals(0, made.status(), made.err());
    }
    Files.writeString(in.resolve("notes.txt"), "These are not events.\n");
    chain = folder.resolve("chain.json");
    Files.writeString(
        chain,
        """
        {"filters": [{"filter": "background-activity"}, {"filter": "cluster-tracker"}]}
        """);
  }

  private CommandRun batch(Path out, Object... more) {
    Object[] args = {"batch", in, "--chain", chain, "--out", out};
    Object[] all = new Object[args.length + more.length];
    System.arraycopy(args, 0, all, 0, args.length);
    System.arraycopy(more, 0, all, args.length, more.length);
    return CommandRun.of(all);
  }

  /** All files below a folder, by their relative names. */
  private static Map<String, String> files(Path out) throws IOException {
    Map<String, String> files = new TreeMap<>();
    try (Stream<Path> all = Files.walk(out)) {
      for (Path file : (Iterable<Path>) all.filter(Files::isRegularFile)::iterator) {
        files.put(
            out.relativize(file).toString(),
            new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1));
      }
    }
    return files;
  }

  private static Map<?, ?> json(Path file) throws IOException {
    return (Map<?, ?>) Json.read(file);
  }

  @Test
  void oneRecordingIsNotCountedInThePlural() {
    CommandRun run =
        CommandRun.of(
            "batch", in.resolve("a.aedat"), "--chain", chain, "--out", folder.resolve("one"));
    assertEquals(0, run.status(), run.err());
    assertTrue(run.out().startsWith("1 recording: 1 done"), run.out());
  }

  @Test
  void eachRecordingHasTablesAndACompletionRecord() throws IOException {
    Path out = folder.resolve("out");
    CommandRun run = batch(out);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.out().startsWith("4 recordings: 4 done"), run.out());
    assertTrue(run.err().contains("not read, no recording: 1 file\n"), run.err());
    assertEquals(
        List.of(
            "a.aedat/background-activity.shares.csv",
            "a.aedat/cluster-tracker.clusters.csv",
            "a.aedat/done.json"),
        files(out).keySet().stream().filter(name -> name.startsWith("a.aedat")).toList());
    Map<?, ?> done = json(out.resolve("deep/c.raw/done.json"));
    assertEquals("deep/c.raw", done.get("recording"));
    assertEquals(Files.size(in.resolve("deep/c.raw")), done.get("recordingBytes"));
    assertEquals(2, ((List<?>) done.get("outputs")).size());
  }

  @Test
  void tablesEqualThoseOfASingleRun() throws IOException {
    Path out = folder.resolve("out");
    assertEquals(0, batch(out).status());
    Path single = folder.resolve("single.csv");
    CommandRun run =
        CommandRun.of("run", in.resolve("deep/d.dat"), "--chain", chain, "--out", single);
    assertEquals(0, run.status(), run.err());
    assertArrayEquals(
        Files.readAllBytes(folder.resolve("single.cluster-tracker.clusters.csv")),
        Files.readAllBytes(out.resolve("deep/d.dat/cluster-tracker.clusters.csv")));
  }

  @Test
  void resultsAmongTheInputsAreNamedWhereNothingElseIsThere() {
    CommandRun run = batch(in);
    assertEquals(1, run.status());
    assertTrue(run.err().contains("no recording; " + in + " is not searched"), run.err());
  }

  @Test
  void workersAndShardsWriteTheSameBytes() throws IOException {
    Path one = folder.resolve("one");
    Path four = folder.resolve("four");
    Path shards = folder.resolve("shards");
    assertEquals(0, batch(one, "--workers", 1).status());
    assertEquals(0, batch(four, "--workers", 4).status());
    for (String shard : List.of("2/3", "1/3", "3/3")) {
      assertEquals(0, batch(shards, "--shard", shard).status());
    }
    assertEquals(files(one), files(four));
    assertEquals(files(one), files(shards));
  }

  @Test
  void unreadableRecordingIsReportedAndDoesNotStopTheBatch() throws IOException {
    Files.write(in.resolve("bad.aedat4"), new byte[] {1, 2, 3});
    Path out = folder.resolve("out");
    CommandRun run = batch(out);
    assertEquals(1, run.status());
    assertTrue(run.out().startsWith("5 recordings: 4 done"), run.out());
    List<?> failed = (List<?>) json(out.resolve("failed.json")).get("failed");
    assertEquals(1, failed.size());
    assertEquals("bad.aedat4", ((Map<?, ?>) failed.get(0)).get("recording"));
    assertEquals("recording", ((Map<?, ?>) failed.get(0)).get("kind"));
    assertFalse(Files.exists(out.resolve("bad.aedat4")));

    Files.delete(in.resolve("bad.aedat4"));
    CommandRun again = batch(out, "--resume");
    assertEquals(0, again.status(), again.err());
    assertFalse(Files.exists(out.resolve("failed.json")));
  }

  @Test
  void linkToAFolderThatIsGivenIsSearched() throws IOException {
    Path link = Files.createSymbolicLink(folder.resolve("link"), in);
    Path out = folder.resolve("out");
    CommandRun run = CommandRun.of("batch", link, "--chain", chain, "--out", out);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.out().startsWith("4 recordings: 4 done"), run.out());
    assertTrue(Files.exists(out.resolve("deep/c.raw/done.json")));
    CommandRun inside = CommandRun.of("batch", link, "--track", "--out", in.resolve("results"));
    assertTrue(inside.out().startsWith("4 recordings: 4 done"), inside.out());
    CommandRun again =
        CommandRun.of("batch", link, "--track", "--out", in.resolve("results"), "--resume");
    assertTrue(again.err().contains("not read, no recording: 1 file\n"), again.err());
  }

  @Test
  void resultsDoNotReplaceTheRecordingsBesideThem() throws IOException {
    CommandRun run =
        CommandRun.of("batch", in.resolve("a.aedat"), "--track", "--out", in, "--overwrite");
    assertEquals(1, run.status());
    assertTrue(run.err().contains("choose another folder"), run.err());
    assertTrue(Files.isRegularFile(in.resolve("a.aedat")));
  }

  @Test
  void existingResultsAreReplacedOnlyWithOverwrite() throws IOException {
    Path out = folder.resolve("out");
    assertEquals(0, batch(out).status());
    CommandRun again = batch(out);
    assertEquals(1, again.status());
    assertTrue(again.err().contains("--resume"), again.err());
    assertTrue(batch(out, "--overwrite").out().contains(" 4 done"));
  }

  @Test
  void resumeKeepsValidResultsAndComputesTheRest() throws IOException {
    Path out = folder.resolve("out");
    assertEquals(0, batch(out).status());
    Map<String, String> before = files(out);
    assertTrue(batch(out, "--resume").out().contains(" 0 done (0 events, 0.0 MB, 0 rows), 4 kept"));

    Files.write(out.resolve("b.es/cluster-tracker.clusters.csv"), new byte[] {'x'});
    Files.delete(out.resolve("deep/d.dat/done.json"));
    assertTrue(batch(out, "--resume").out().contains(" 2 done"));
    assertEquals(before, files(out));

    Files.setLastModifiedTime(in.resolve("a.aedat"), FileTime.fromMillis(1_000_000));
    assertTrue(batch(out, "--resume").out().contains(" 4 kept"), "its bytes are the same");

    Files.writeString(chain, "{\"filters\": [{\"filter\": \"cluster-tracker\"}]}\n");
    assertTrue(batch(out, "--resume").out().contains(" 4 done"), "the chain is another");
    assertFalse(Files.exists(out.resolve("b.es/background-activity.shares.csv")));
  }

  @Test
  void listFileNamesInputs() throws IOException {
    Path list = folder.resolve("list.txt");
    Files.writeString(list, "\ufeff" + in.resolve("a.aedat") + "\n\n" + in.resolve("deep") + "\n");
    Path out = folder.resolve("out");
    CommandRun run = CommandRun.of("batch", "--list", list, "--track", "--out", out);
    assertEquals(0, run.status(), run.err());
    assertTrue(Files.exists(out.resolve("c.raw/object-tracker.objects.csv")), run.err());
    assertTrue(Files.exists(out.resolve("a.aedat/done.json")));
  }

  @Test
  void badLineOfAListIsNamedByItsNumber() throws IOException {
    Path list = folder.resolve("list.txt");
    Files.writeString(list, in.resolve("a.aedat") + "\n\n" + folder.resolve("gone.raw") + "\n");
    CommandRun run =
        CommandRun.of("batch", "--list", list, "--track", "--out", folder.resolve("out"));
    assertEquals(1, run.status());
    assertEquals(
        "haltere: %s: line 3: %s: there is no such file or folder"
            .formatted(list, folder.resolve("gone.raw")),
        run.err().strip());
  }

  @Test
  void recordingsWithEqualNamesNeedARoot() throws IOException {
    Files.copy(in.resolve("a.aedat"), in.resolve("deep/a.aedat"));
    Object[] both = {
      "batch",
      in.resolve("a.aedat"),
      in.resolve("deep/a.aedat"),
      "--track",
      "--out",
      folder.resolve("out")
    };
    CommandRun refused = CommandRun.of(both);
    assertEquals(1, refused.status());
    assertTrue(refused.err().contains("--root"), refused.err());
    Object[] rooted = Stream.concat(Stream.of(both), Stream.of("--root", in)).toArray();
    assertEquals(0, CommandRun.of(rooted).status());
    assertTrue(Files.exists(folder.resolve("out/deep/a.aedat/done.json")));
  }

  @Test
  void onlySelectedOutletsHaveTables() throws IOException {
    Path out = folder.resolve("out");
    assertEquals(0, batch(out, "--outlets", "clusters").status());
    assertEquals(
        List.of("a.aedat/cluster-tracker.clusters.csv", "a.aedat/done.json"),
        files(out).keySet().stream().filter(name -> name.startsWith("a.aedat")).toList());
    CommandRun same = batch(out, "--outlets", "clusters", "--resume");
    assertTrue(same.out().contains("4 kept"), same.out());
    CommandRun all = batch(out, "--resume");
    assertTrue(all.out().contains("0 kept"), all.out());
    CommandRun wrong = batch(folder.resolve("other"), "--outlets", "clusters,moons");
    assertNotEquals(0, wrong.status());
    assertTrue(
        wrong.err().contains("the chain has no outlet \"moons\"; it has clusters, shares"),
        wrong.err());
  }

  @Test
  void wingsOptionWritesAllTablesExceptMeasurements() throws IOException {
    Path fly = folder.resolve("fly.aedat");
    assertEquals(0, CommandRun.of("simulate", "fly", fly, "--duration", "0.1").status());
    Files.writeString(chain, "{\"filters\": [{\"filter\": \"wing-tracker\"}]}");
    Path all = folder.resolve("all");
    assertEquals(0, CommandRun.of("batch", fly, "--chain", chain, "--out", all).status());
    Path usual = folder.resolve("usual");
    assertEquals(0, CommandRun.of("batch", fly, "--wings", "--out", usual).status());
    Map<String, String> tables = files(all);
    assertNotNull(tables.remove("fly.aedat/wing-tracker.measurements.csv"));
    assertEquals(tables.keySet(), files(usual).keySet());
  }

  @Test
  void invalidShardsAndContradictoryOptionsAreRejected() {
    Path out = folder.resolve("out");
    assertEquals(2, batch(out, "--shard", "0/4").status());
    assertEquals(2, batch(out, "--shard", "5/4").status());
    assertEquals(2, batch(out, "--resume", "--overwrite").status());
    assertEquals(2, batch(out, "--wings").status());
    assertEquals(2, batch(out, "--workers", 0).status());
    assertFalse(Files.exists(out));
  }

  @Test
  @Timeout(240)
  void batchKilledAtRandomMomentsResumesToTheSameFiles() throws Exception {
    Path undisturbed = folder.resolve("undisturbed");
    assertEquals(0, batch(undisturbed).status());
    Random random = new Random(5);
    int killed = 0;
    for (int kill = 0; kill < KILLS; kill++) {
      Path out = folder.resolve("killed-" + kill);
      Process process =
          new ProcessBuilder(
                  Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                  "-XX:TieredStopAtLevel=1",
                  "-XX:+UseSerialGC",
                  "-cp",
                  System.getProperty("java.class.path"),
                  BatchProcess.class.getName(),
                  in.toString(),
                  chain.toString(),
                  out.toString())
              .redirectErrorStream(true)
              .redirectOutput(folder.resolve("said.txt").toFile())
              .start();
      int begun = 1 + random.nextInt(9);
      while (count(out) < begun && !process.waitFor(1, TimeUnit.MILLISECONDS)) {
        // until so many files have been begun
      }
      killed += process.isAlive() ? 1 : 0;
      process.destroyForcibly().waitFor();
      CommandRun last = batch(out, "--resume");
      assertEquals(0, last.status(), last.err());
      assertEquals(files(undisturbed), files(out));
    }
    assertTrue(killed > KILLS / 2, "only " + killed + " processes were killed at work");
  }

  /** Files below a folder that is being written. */
  private static long count(Path out) {
    try (Stream<Path> all = Files.walk(out)) {
      return all.filter(Files::isRegularFile).count();
    } catch (IOException | UncheckedIOException changing) {
      return 0;
    }
  }
}
