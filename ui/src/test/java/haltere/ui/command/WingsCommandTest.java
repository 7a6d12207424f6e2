package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.internal.Json;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class WingsCommandTest {
  @TempDir Path folder;

  private Path fly() {
    Path file = folder.resolve("fly.aedat");
    CommandRun run =
        CommandRun.of(
            "simulate",
            "fly",
            file,
            "--duration",
            "0.3",
            "--set",
            "disturbances.manoeuvres.everyS=0",
            "--set",
            "run.startUs=7000000");
    assertEquals(0, run.status(), run.err());
    return file;
  }

  @Test
  void documentedTablesAndASummaryAreWritten() throws IOException {
    Path wings = folder.resolve("wings.csv");
    Path beats = folder.resolve("beats.csv");
    Path geometry = folder.resolve("geometry.json");
    Path log = folder.resolve("log.txt");
    CommandRun run =
        CommandRun.of(
            "wings",
            fly(),
            "--out",
            wings,
            "--beats",
            beats,
            "--geometry",
            geometry,
            "--log",
            log,
            "--rate",
            "500");
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("wrote " + log + " ("), run.err());
    assertTrue(run.err().contains("wrote " + geometry), run.err());
    List<String> rows = Files.readAllLines(wings);
    assertEquals(
        "t_us,edge,angle_rad,centre_rad,amplitude_rad,phase_rad,frequency_hz,sd_angle_rad,"
            + "sd_frequency_hz,events",
        rows.get(0));
    Set<String> edges =
        rows.stream().skip(1).map(row -> row.split(",")[1]).collect(Collectors.toSet());
    assertEquals(
        Set.of("left-leading", "left-trailing", "right-leading", "right-trailing", "left", "right"),
        edges);
    long first = Long.parseLong(rows.get(1).split(",")[0]);
    assertEquals(0, first % 2000, "ticks of 500 Hz on the recording's own clock");
    assertTrue(first > 7_000_000 && first < 7_060_000, rows.get(1));
    assertEquals(
        "side,beat,t_us,period_us,frequency_hz,amplitude_rad,min_rad,max_rad,phase_lag_rad",
        Files.readAllLines(beats).get(0));
    Map<?, ?> keys = (Map<?, ?>) Json.read(geometry);
    assertEquals(
        Set.of(
            "centreX",
            "centreY",
            "headingRad",
            "sizePx",
            "leftHingeX",
            "leftHingeY",
            "rightHingeX",
            "rightHingeY",
            "headTailConfidence",
            "initialisedAtUs"),
        keys.keySet());
    assertEquals(Math.PI / 2, ((Number) keys.get("headingRad")).doubleValue(), 0.05);
    assertTrue(run.out().contains("in lock"), run.out());
    assertTrue(run.out().contains("mean NIS"), run.out());
    assertTrue(run.out().contains("beats") && run.out().contains("SD"), run.out());
    for (String side : List.of("left", "right")) {
      assertTrue(
          run.out().lines().anyMatch(line -> line.strip().startsWith(side)),
          "frequency and amplitude of the " + side + " wing: " + run.out());
    }
    List<String> lines = Files.readAllLines(log);
    assertTrue(lines.get(0).startsWith("# haltere"), lines.get(0));
    assertTrue(
        lines.contains("# column angle_rad: stroke angle, radians: 0 at the head, pi at the tail"));
    assertTrue(lines.contains("# setting: output.rateHz=500.0 Hz"), lines.toString());
    assertTrue(
        lines.contains("# setting: filter.harmonics=4 harmonics (default)"), lines.toString());
    List<String> table = lines.stream().filter(line -> !line.startsWith("#")).toList();
    assertEquals(rows, table, "the log has the same rows as the table");
  }

  @Test
  void logHasRowsOfEventsOrBeatsAndTheOriginalLayout() throws IOException {
    Path fly = fly();
    List<String> beats = log(fly, "beat", "table");
    assertTrue(beats.get(0).startsWith("side,beat,t_us,"), beats.get(0));
    assertTrue(beats.size() > 20, beats.size() + " rows of beats");
    List<String> events = log(fly, "event", "table");
    assertTrue(events.get(0).startsWith("t_us,edge,measured_rad,expected_rad,"), events.get(0));
    assertTrue(events.size() > 2000, events.size() + " rows of events");
    List<String> original = log(fly, "event", "original");
    assertEquals(events.size() - 1, original.size());
    for (String row : original) {
      String[] fields = row.split("\t");
      assertEquals(8, fields.length, row);
      assertTrue(fields[0].matches("[1-4]"), row);
    }
    List<String> average = log(fly, "tick", "original", "--method", "wra");
    assertTrue(average.size() > 200, average.size() + " rows of ticks");
    for (String row : average) {
      String[] fields = row.split("\t");
      // of the fourth edge the original wrote no frequency and no amplitude
      assertEquals(fields[0].equals("4") ? 4 : 6, fields.length, row);
    }
    CommandRun wrong =
        CommandRun.of(
            "wings",
            fly,
            "--out",
            folder.resolve("no.csv"),
            "--log-rows",
            "beat",
            "--log-layout",
            "original");
    assertEquals(2, wrong.status(), wrong.err());
  }

  private List<String> log(Path fly, String rows, String layout, String... more)
      throws IOException {
    Path log = folder.resolve(rows + layout + ".txt");
    List<Object> text =
        new ArrayList<>(
            List.of(
                "wings",
                fly,
                "--out",
                folder.resolve(rows + layout + ".csv"),
                "--log",
                log,
                "--log-rows",
                rows,
                "--log-layout",
                layout));
    text.addAll(List.of(more));
    CommandRun run = CommandRun.of(text.toArray());
    assertEquals(0, run.status(), run.err());
    return Files.readAllLines(log).stream().filter(line -> !line.startsWith("#")).toList();
  }

  @Test
  void flippedHeadingExchangesHeadAndTail() throws IOException {
    Path geometry = folder.resolve("geometry.json");
    CommandRun run =
        CommandRun.of(
            "wings",
            fly(),
            "--out",
            folder.resolve("w.csv"),
            "--geometry",
            geometry,
            "--flip-heading",
            "--method",
            "wra");
    assertEquals(0, run.status(), run.err());
    Map<?, ?> keys = (Map<?, ?>) Json.read(geometry);
    assertEquals(1.5 * Math.PI, ((Number) keys.get("headingRad")).doubleValue(), 0.1);
  }

  @Test
  void recordingWithoutAFlyGivesAnEmptyTableAndAMessage() throws IOException {
    Path dots = folder.resolve("dots.aedat");
    assertEquals(0, CommandRun.of("simulate", "dots", dots, "--duration", "0.3").status());
    Path wings = folder.resolve("wings.csv");
    CommandRun run = CommandRun.of("wings", dots, "--out", wings);
    assertEquals(0, run.status(), run.err());
    assertEquals(1, Files.readAllLines(wings).size());
    assertTrue(run.out().contains("waiting for wings"), run.out());
  }

  @Test
  void wrongArgumentsAreRejectedBeforeAnyOutput() {
    Path out = folder.resolve("wings.csv");
    Path fly = fly();
    for (List<String> wrong :
        List.of(
            List.of("--method", "magic"),
            List.of("--rate", "0"),
            List.of("--initial-frequency", "-1"),
            List.of("--preset", "new"),
            List.of("--set", "filter.harmonics=9"))) {
      CommandRun run = CommandRun.of("wings", fly, "--out", out, wrong.get(0), wrong.get(1));
      assertEquals(2, run.status(), run.err());
      assertFalse(Files.exists(out));
    }
  }

  @Test
  void originalTrackerIsOutOfLockAtAnotherFrequencyThanTheBeat() {
    Path file = folder.resolve("slow.aedat");
    CommandRun simulated =
        CommandRun.of(
            "simulate",
            "fly",
            file,
            "--duration",
            "0.5",
            "--set",
            "stroke.beat.frequencyHz=150",
            "--set",
            "fly.wing.visibleShare=0.15");
    assertEquals(0, simulated.status(), simulated.err());
    CommandRun run =
        CommandRun.of("wings", file, "--out", folder.resolve("w.csv"), "--preset", "original");
    assertEquals(0, run.status(), run.err());
    assertTrue(run.out().contains("in lock 0.0 % of the time"), run.out());
    assertTrue(run.out().contains("at another frequency than the beat's 9"), run.out());
    assertTrue(run.out().lines().anyMatch(line -> line.strip().matches("left +0")), run.out());
  }
}
