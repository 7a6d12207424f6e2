package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SimulateCommandTest {
  @TempDir Path folder;

  @Test
  void recordingAndTruthAreWrittenAtTheRequestedRate() throws IOException {
    Path out = folder.resolve("fly.csv");
    Path truth = folder.resolve("truth.csv");
    CommandRun run =
        CommandRun.of(
            "simulate",
            "fly",
            out,
            "--truth",
            truth,
            "--duration",
            "0.1",
            "--rate",
            "200",
            "--set",
            "run.startUs=5000000");
    assertEquals(0, run.status(), run.err());
    List<String> events = Files.readAllLines(out);
    assertTrue(events.size() > 1000);
    assertTrue(time(events.get(1)) >= 5_000_000, events.get(1));
    assertTrue(time(events.get(events.size() - 1)) < 5_100_000);
    List<String> rows = Files.readAllLines(truth);
    assertTrue(rows.get(0).startsWith("t_us,"), rows.get(0));
    assertEquals(20 + 1, rows.size());
    assertEquals(5_000_000, time(rows.get(1)));
    assertEquals(5_095_000, time(rows.get(20)));
    assertEquals(3, run.errorLines().size(), run.err());
    assertTrue(run.errorLines().get(0).contains("rows count from the bottom"), run.err());
  }

  private static long time(String row) {
    return Long.parseLong(row.substring(0, row.indexOf(',')));
  }

  @Test
  void recordingsAreReproducibleAndDifferBetweenSeeds() throws IOException {
    Path first = simulate("first.aedat", "run.seed=7");
    Path second = simulate("second.aedat", "run.seed=7");
    Path third = simulate("third.aedat", "seed=7");
    Path other = simulate("other.aedat", "run.seed=8");
    assertEquals(-1, Files.mismatch(first, second));
    assertEquals(-1, Files.mismatch(first, third));
    assertTrue(Files.mismatch(first, other) >= 0);
  }

  private Path simulate(String name, String assignment) {
    Path out = folder.resolve(name);
    CommandRun run =
        CommandRun.of("simulate", "fly", out, "--duration", "0.05", "--set", assignment);
    assertEquals(0, run.status(), run.err());
    return out;
  }

  @Test
  void unknownSceneIsReportedWithTheExistingOnes() {
    Path out = folder.resolve("x.aedat");
    assertWrong("fly", "simulate", "unicorn", out);
    assertWrong("run.seed", "simulate", "fly", out, "--set", "wingspan=3");
    assertWrong("name=value", "simulate", "fly", out, "--set", "wingspan");
    assertWrong("--duration", "simulate", "fly", out, "--duration", "-1");
    assertWrong("--rate", "simulate", "fly", out, "--rate", "NaN");
  }

  @Test
  void settingThatContradictsAnOptionIsRefused() {
    Path out = folder.resolve("x.aedat");
    assertWrong(
        "durationS=0.1", "simulate", "dots", out, "--duration", 0.1, "--set", "durationS=3");
    Object[] rates = {"simulate", "dots", out, "--truth", folder.resolve("t.csv"), "--rate", 5};
    assertWrong("truthRateHz=5", plus(rates, "--set", "truthRateHz=100"));
    CommandRun same =
        CommandRun.of("simulate", "dots", out, "--duration", 0.1, "--set", "run.durationS=0.1");
    assertEquals(0, same.status(), same.err());
  }

  private static Object[] plus(Object[] arguments, Object... more) {
    return Stream.concat(Stream.of(arguments), Stream.of(more)).toArray();
  }

  private static void assertWrong(String word, Object... arguments) {
    CommandRun run = CommandRun.of(arguments);
    assertEquals(2, run.status(), run.err());
    assertTrue(run.errorLines().get(0).contains(word), run.err());
  }

  @Test
  void equalFilesForRecordingAndTruthAreRejected() {
    Path out = folder.resolve("x.csv");
    assertWrong("x.csv would be written by two outputs", "simulate", "fly", out, "--truth", out);
  }
}
