package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import haltere.core.json.internal.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The reader that docs/live-results.md shows works with the program as it is installed. */
@Timeout(120)
class LiveResultsPageTest {
  private static final Path PAGE = Path.of("..", "docs", "live-results.md");
  private static final Pattern EXAMPLE = Pattern.compile("```python\n(.*?)```", Pattern.DOTALL);

  @TempDir Path folder;
  private Path recording;
  private Path chain;

  @BeforeEach
  void writeRecordingAndChain() throws IOException {
    recording = folder.resolve("fly.aedat");
    assertEquals(0, CommandRun.of("simulate", "fly", recording, "--duration", "0.3").status());
    chain = folder.resolve("chain.json");
    Files.writeString(
        chain,
        """
        {"filters": [{"filter": "background-activity"}, {"filter": "cluster-tracker"}]}
        """);
  }

  private static boolean pythonIsHere() throws InterruptedException {
    try {
      return new ProcessBuilder("python3", "--version").start().waitFor() == 0;
    } catch (IOException missing) {
      return false;
    }
  }

  @Test
  void documentedReaderReceivesAllRowsOfTheTable() throws Exception {
    assumeTrue(pythonIsHere(), "SKIPPED python3 is not installed");
    Matcher block = EXAMPLE.matcher(Files.readString(PAGE));
    assertTrue(block.find(), "there is no Python in " + PAGE);
    String reader = block.group(1);
    assertTrue(reader.lines().filter(line -> !line.isBlank()).count() <= 15, reader);
    Path script = Files.writeString(folder.resolve("reader.py"), reader);
    CommandRun tables =
        CommandRun.of("run", recording, "--chain", chain, "--out", folder.resolve("left.csv"));
    assertEquals(0, tables.status(), tables.err());
    int rows = Files.readAllLines(folder.resolve("left.cluster-tracker.clusters.csv")).size() - 1;
    int shares =
        Files.readAllLines(folder.resolve("left.background-activity.shares.csv")).size() - 1;
    Path program = Path.of(System.getProperty("haltere.installed"), "bin", "haltere");
    Process haltere =
        new ProcessBuilder(
                program.toString(),
                "run",
                recording.toString(),
                "--chain",
                chain.toString(),
                "--publish",
                "tcp://127.0.0.1:0",
                "--receivers",
                "1")
            .redirectOutput(folder.resolve("run.out").toFile())
            .start();
    String said = haltere.errorReader().readLine();
    assertTrue(said.startsWith("publishing at tcp://127.0.0.1:"), said);
    Path heard = folder.resolve("heard.txt");
    Process python =
        new ProcessBuilder(
                "python3",
                script.toString(),
                "127.0.0.1",
                said.substring(said.lastIndexOf(':') + 1))
            .redirectOutput(heard.toFile())
            .redirectError(ProcessBuilder.Redirect.INHERIT)
            .start();
    assertTrue(python.waitFor(60, TimeUnit.SECONDS));
    assertTrue(haltere.waitFor(60, TimeUnit.SECONDS));
    assertEquals(0, haltere.exitValue());
    assertEquals(0, python.exitValue());
    List<String> lines = Files.readAllLines(heard);
    Map<?, ?> counts = (Map<?, ?>) Json.parse(lines.get(lines.size() - 1), "the last line");
    assertTrue(rows > 0);
    assertEquals((long) rows, counts.get("cluster-tracker/clusters"));
    assertEquals((long) shares, counts.get("background-activity/shares"));
    assertEquals(rows + shares, lines.size() - 1);
    String cluster =
        lines.stream()
            .filter(line -> line.startsWith("cluster-tracker/clusters\t"))
            .findFirst()
            .get();
    String[] first = cluster.split("\t");
    assertTrue(Long.parseLong(first[1]) < 300_000, cluster);
    assertTrue(Long.parseLong(first[2]) > 1_700_000_000_000_000L, cluster);
  }

  @Test
  void invalidAddressesAndIncompleteOptionsAreWrongArguments() {
    for (List<String> wrong :
        List.of(
            List.of("--publish", "nowhere"),
            List.of("--publish", "pigeon://a:5"),
            List.of("--outlet", "a/b"),
            List.of("--receivers", "1"),
            List.of("--speed", "0"))) {
      Object[] text = new Object[4 + wrong.size()];
      text[0] = "run";
      text[1] = recording;
      text[2] = "--chain";
      text[3] = chain;
      for (int i = 0; i < wrong.size(); i++) {
        text[4 + i] = wrong.get(i);
      }
      assertEquals(2, CommandRun.of(text).status(), wrong.toString());
    }
  }

  @Test
  void unknownOutletIsReportedWithTheExistingOnes() {
    CommandRun run =
        CommandRun.of(
            "run",
            recording,
            "--chain",
            chain,
            "--publish",
            "tcp://127.0.0.1:0",
            "--outlet",
            "a/b");
    assertEquals(1, run.status());
    assertTrue(
        run.err()
            .contains(
                "nothing publishes a/b; there are background-activity/shares,"
                    + " cluster-tracker/clusters"),
        run.err());
  }

  @Test
  void otherCommandsPublishResults() {
    for (List<String> command :
        List.of(List.of("track", "tracks.csv"), List.of("wings", "wings.csv"))) {
      CommandRun run =
          CommandRun.of(
              command.get(0),
              recording,
              "--out",
              folder.resolve(command.get(1)),
              "--publish",
              "tcp://127.0.0.1:0",
              "--publish",
              "zmq://127.0.0.1:0");
      assertEquals(0, run.status(), run.err());
      assertTrue(run.errorLines().get(0).startsWith("publishing at tcp://127.0.0.1:"), run.err());
      assertTrue(run.errorLines().get(1).startsWith("publishing at zmq://127.0.0.1:"), run.err());
    }
  }
}
