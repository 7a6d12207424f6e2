package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Options that contradict others or have no effect are refused before any work. */
class OptionsTest {
  @TempDir Path folder;

  @BeforeEach
  void writeRecordingAndChain() throws IOException {
    TinyRecording.hundred().write(folder.resolve("in.aedat"));
    Files.writeString(
        folder.resolve("chain.json"), "{\"filters\": [{\"filter\": \"background-activity\"}]}");
  }

  private CommandRun run(String line) {
    return CommandRun.of((Object[]) line.replace("@", folder + "/").split(" "));
  }

  private void assertRefused(String line, String why) throws IOException {
    CommandRun run = run(line);
    assertEquals(2, run.status(), run.err());
    assertTrue(run.errorLines().get(0).endsWith(": " + why.replace("@", folder + "/")), run.err());
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(2, files.count());
    }
  }

  @ParameterizedTest
  @CsvSource({
    "wings @in.aedat --out @o.csv --log-rows event, --log-rows needs --log",
    "wings @in.aedat --out @o.csv --log-rows tick --log-layout table,"
        + " --log-rows and --log-layout need --log",
    "run @in.aedat --chain @chain.json --tables csv, --tables needs --out",
    "run @in.aedat --chain @chain.json --origin top, --origin needs --out",
    "run --device simulated:fly --chain @chain.json --format es, --format needs a FILE",
    "run --device simulated:fly --chain @chain.json --speed 2, --speed needs a FILE",
    "track --device simulated:fly --out @o.csv --strict, --strict needs a FILE",
    "wings --device simulated:fly --out @o.csv --report @o.html, --report needs a FILE",
    "track @in.aedat --out @o.csv --crossings @c.csv, --crossings needs --road",
    "track @in.aedat --out @o.csv --duration 1, --duration needs --device",
    "track @in.aedat --out @o.csv --receivers 1, --receivers needs --publish",
    "track @in.aedat --out -, standard output is only for haltere convert; name a file",
    "wings - --out -, standard output is only for haltere convert; name a file",
    "bench --sensor 3x3, --sensor needs a FILE",
    "view --rows top, --rows needs a FILE",
    "simulate fly @o.aedat --rate 10, --rate needs --truth",
    "convert @in.aedat @o.csv --stream imu --origin top,"
        + " '--origin needs events, and excludes --stream'",
  })
  void optionWithoutEffectIsRefusedWithWhatItNeeds(String line, String why) throws IOException {
    assertRefused(line, why);
  }

  @ParameterizedTest
  @CsvSource({
    "track @in.aedat --out @o.csv --rate 10 --set reportRateHz=20, reportRateHz=10.0",
    "track @in.aedat --out @o.csv --preset original --rate 10 --set reportRateHz=20,"
        + " clusters.output.reportRateHz=10.0",
    "wings @in.aedat --out @o.csv --method wra --set method=ekf, filter.method=WRA",
    "wings @in.aedat --out @o.csv --flip-heading --set flipHeading=false,"
        + " position.flipHeading=true",
    "orient @in.csv --out @o.csv --gate-angle 5 --set gate.angleDeg=180, gate.angleDeg=5.0",
  })
  void optionIsNotReplacedByAnAssignmentToItsSetting(String line, String setting)
      throws IOException {
    assertRefused(line, "--set contradicts another option, which sets " + setting);
  }

  @Test
  void optionAndAssignmentMayAgree() {
    String line = "wings @in.aedat --out @o.csv --rate 500 --set output.rateHz=500";
    assertEquals(0, run(line).status());
  }

  @Test
  void optionsWithTheirDefaultsAreNotRefused() {
    assertEquals(0, run("run @in.aedat --chain @chain.json").status());
  }

  @Test
  void reportMayNotReplaceATableOfTheSameRun() throws IOException {
    assertRefused(
        "run @in.aedat --chain @chain.json --out @o.csv --overwrite --report"
            + " @./o.background-activity.shares.csv",
        "@./o.background-activity.shares.csv would be written by two outputs");
  }

  @Test
  void reportOfABatchMayNotReplaceAResult() throws IOException {
    String batch = "batch @in.aedat --wings --out @. --resume --report @in.aedat/done.json";
    assertRefused(batch, "--report needs a name in .html");
  }

  @Test
  void pictureHasTheNameOfItsFormat() throws IOException {
    assertRefused(
        "info @in.aedat --picture @sheet.jpg", "@sheet.jpg: a picture's name ends in .png");
    assertEquals(0, run("info @in.aedat --picture @sheet.PNG").status());
  }

  @Test
  void helpOfAnUnknownCommandSuggestsAKnownOne() throws IOException {
    assertRefused("trak --help", "there is no command trak");
    assertTrue(run("trak --help").err().contains("\nDid you mean: haltere track?\n"));
    assertRefused("--bogus --help", "Unknown option: '--bogus'");
  }

  @ParameterizedTest
  @CsvSource({
    "convert @in.aedat @o.csv --from 1e3, --from, '1e3' is no whole number",
    "convert @in.aedat @o.csv --to 9223372036854775808, --to, '9223372036854775808' is no whole"
        + " number",
    "batch @in.aedat --wings --out @o --workers 1.5, --workers, '1.5' is no whole number",
    "wings @in.aedat --out @o.csv --rate fast, --rate, 'fast' is no number",
    "record @o.aedat4 --bias x=y, --bias, 'y' is no number",
    "record @o.aedat4 --bias x, --bias, for option '--bias' must be in NAME=VALUE format but was x",
    "wings @in.aedat --out @o.csv --method no, --method, 'one of ekf, wra, both but was ''no'''",
    "convert @in.aedat @o.csv --rows up, --rows, 'one of top, bottom but was ''up'''",
    "run @in.aedat --chain @chain.json --speed 1e-5, --speed, must be 0.0001 or more",
    "example oscillator --out @o.parquet, --out, this table is written as CSV",
  })
  void invalidValueIsSaidInWords(String line, String option, String why) throws IOException {
    CommandRun run = run(line);
    assertEquals(2, run.status(), run.err());
    String said = run.errorLines().get(0);
    assertTrue(said.contains(option) && said.contains(why), said);
    assertFalse(said.contains("long") || said.contains("double"), said);
  }
}
