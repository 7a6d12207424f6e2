package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RunCommandTest {
  @TempDir Path folder;

  private Path in;
  private Path chain;

  @BeforeEach
  void writeRecordingAndChain() throws IOException {
    in = folder.resolve("fly.aedat");
    CommandRun made = CommandRun.of("simulate", "fly", in, "--duration", "0.3");
    assertEquals(0, made.status(), made.err());
    chain = folder.resolve("chain.json");
    Files.writeString(
        chain,
        """
        {"filters": [
          {"filter": "refractory", "enabled": false},
          {"filter": "background-activity"},
          {"name": "tracking", "filters": [{"filter": "cluster-tracker"}]}
        ]}
        """);
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void runWithoutOutputReportsOnlyTheStages() throws IOException {
    CommandRun run = CommandRun.of("run", in, "--chain", chain);
    assertEquals(0, run.status(), run.err());
    List<String> lines = run.out().lines().toList();
    assertTrue(lines.get(0).startsWith("stage "), run.out());
    assertTrue(lines.get(1).startsWith("refractory (off) "), run.out());
    assertTrue(lines.get(2).startsWith("background-activity "), run.out());
    assertTrue(lines.get(3).startsWith("tracking "), run.out());
    assertEquals(List.of("chain.json", "fly.aedat"), names());
  }

  @Test
  void runWithOutputWritesAndListsEventsAndTables() throws IOException {
    Path out = folder.resolve("left.csv");
    CommandRun run = CommandRun.of("run", in, "--chain", chain, "--out", out);
    assertEquals(0, run.status(), run.err());
    assertEquals(
        List.of(
            "chain.json",
            "fly.aedat",
            "left.background-activity.shares.csv",
            "left.cluster-tracker.clusters.csv",
            "left.csv"),
        names());
    assertEquals(4, run.errorLines().size(), run.err());
    assertTrue(run.errorLines().get(0).contains("rows count from the bottom"), run.err());
    assertTrue(run.errorLines().get(1).startsWith("wrote " + out + " ("), run.err());
    String shares = "left.background-activity.shares.csv";
    assertTrue(run.errorLines().get(2).contains(shares + " ("), run.err());
    assertEquals(
        "t_us,correlation_us,events,passed_share,removed_share",
        Files.readAllLines(folder.resolve(shares)).get(0));
    assertTrue(run.errorLines().get(3).contains("left.cluster-tracker.clusters.csv ("), run.err());
    List<String> rows = Files.readAllLines(folder.resolve("left.cluster-tracker.clusters.csv"));
    assertTrue(rows.get(0).startsWith("t_us,id,"), rows.get(0));
    assertTrue(rows.size() > 1);
    int columns = rows.get(0).split(",", -1).length;
    assertTrue(rows.stream().allMatch(row -> row.split(",", -1).length == columns));
  }

  @Test
  void filtersOfOneNameInTwoNestedChainsHaveTablesOfTheirOwn() throws IOException {
    Files.writeString(
        chain,
        """
        {"filters": [
          {"name": "a", "filters": [{"filter": "cluster-tracker"}]},
          {"name": "b", "filters": [{"filter": "cluster-tracker"}]}
        ]}
        """);
    CommandRun run =
        CommandRun.of("run", in, "--chain", chain, "--out", folder.resolve("left.csv"));
    assertEquals(0, run.status(), run.err());
    assertTrue(names().contains("left.cluster-tracker.clusters.csv"), names().toString());
    assertTrue(names().contains("left.cluster-tracker-2.clusters.csv"), names().toString());
  }

  @Test
  void runsAreReproducible() throws IOException {
    Path first = Files.createDirectory(folder.resolve("first"));
    Path second = Files.createDirectory(folder.resolve("second"));
    for (Path place : List.of(first, second)) {
      CommandRun run = CommandRun.of("run", in, "--chain", chain, "--out", place.resolve("o.csv"));
      assertEquals(0, run.status(), run.err());
    }
    for (String name : List.of("o.csv", "o.cluster-tracker.clusters.csv")) {
      assertEquals(-1, Files.mismatch(first.resolve(name), second.resolve(name)), name);
    }
  }

  @Test
  void existingTableIsRejectedBeforeAnyWork() throws IOException {
    Path table = folder.resolve("left.cluster-tracker.clusters.csv");
    Files.writeString(table, "mine");
    CommandRun run =
        CommandRun.of("run", in, "--chain", chain, "--out", folder.resolve("left.csv"));
    assertEquals(1, run.status());
    assertEquals(1, run.errorLines().size(), run.err());
    assertTrue(run.err().contains(table + ": exists already"), run.err());
    assertEquals("mine", Files.readString(table));
    assertFalse(Files.exists(folder.resolve("left.csv")));
  }

  @Test
  void strictRunOfATruncatedFileLeavesNoOutput() throws IOException {
    byte[] whole = Files.readAllBytes(in);
    Files.write(in, java.util.Arrays.copyOf(whole, whole.length - 3));
    CommandRun strict =
        CommandRun.of("run", in, "--chain", chain, "--strict", "--out", folder.resolve("left.csv"));
    assertEquals(1, strict.status(), strict.err());
    assertEquals(List.of("chain.json", "fly.aedat"), names());
    CommandRun lenient = CommandRun.of("run", in, "--chain", chain);
    assertEquals(0, lenient.status());
    assertTrue(lenient.err().startsWith("haltere: warning: "), lenient.err());
  }
}
