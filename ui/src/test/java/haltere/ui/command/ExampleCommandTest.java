package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Random;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.Stream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ExampleCommandTest {
  @TempDir Path folder;

  private Path out;
  private Path plots;
  private Path data;

  @BeforeEach
  void namePaths() {
    out = folder.resolve("table.csv");
    plots = folder.resolve("plots");
    data = folder.resolve("data.csv");
  }

  private double last(String column) throws IOException {
    List<String> lines = Files.readAllLines(out);
    int place = Arrays.asList(lines.get(0).split(",")).indexOf(column);
    assertTrue(place >= 0, column + " in " + lines.get(0));
    return Double.parseDouble(lines.get(lines.size() - 1).split(",", -1)[place]);
  }

  private void assertLast(double truth, String column, double sigmas) throws IOException {
    assertEquals(truth, last(column), sigmas * last("sd_" + column), column);
  }

  private void assertPlots(String example, String... names) throws Exception {
    List<String> expected = Stream.of(names).map(name -> example + "-" + name + ".svg").toList();
    try (Stream<Path> files = Files.list(plots)) {
      List<Path> found = files.sorted().toList();
      assertEquals(expected, found.stream().map(file -> file.getFileName().toString()).toList());
      for (Path file : found) {
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile());
        String svg = Files.readString(file);
        assertFalse(svg.contains("NaN") || svg.contains("Infinity"), file.toString());
        assertTrue(svg.length() < 40_000, file + " has " + svg.length() + " bytes");
      }
    }
  }

  @Test
  void simulatedFallYieldsGravityWithTableAndPlots() throws Exception {
    CommandRun run = CommandRun.of("example", "falling-weight", "--out", out, "--plots", plots);
    assertEquals(0, run.status(), run.err());
    assertEquals(98, Files.readAllLines(out).size());
    assertLast(9.81, "a_m_s2", 1.96);
    assertLast(9.81, "fit_a_m_s2", 1.96);
    assertTrue(run.out().contains("acceleration") && run.out().contains("least squares"));
    assertTrue(run.err().contains("wrote " + out + " (97 rows)"), run.err());
    assertFalse(run.err().contains("warning"), run.err());
    assertPlots(
        "falling-weight",
        "acceleration",
        "displacement",
        "gains",
        "phase-plane",
        "quantisation",
        "velocity");
  }

  @Test
  void simulatedOscillatorYieldsDampingAndFrequencyWithTableAndPlots() throws Exception {
    CommandRun run = CommandRun.of("example", "oscillator", "--out", out, "--plots", plots);
    assertEquals(0, run.status(), run.err());
    assertEquals(1203, Files.readAllLines(out).size());
    assertLast(0.07, "damping", 1.96);
    assertLast(4.37, "frequency_rad_s", 1.96);
    assertTrue(last("sd_frequency_rad_s") < 0.001);
    assertTrue(run.out().contains("linearised only once"), run.out());
    assertFalse(run.err().contains("warning"), run.err());
    assertPlots(
        "oscillator",
        "acceleration",
        "damping",
        "displacement",
        "frequency",
        "gains",
        "integrators",
        "linearisation",
        "phase-plane",
        "quantisation",
        "velocity");
  }

  @Test
  void tablesAreReproducibleForASeedAndDifferBetweenSeeds() throws IOException {
    byte[][] tables = new byte[3][];
    for (int i = 0; i < 3; i++) {
      CommandRun run =
          CommandRun.of(
              "example", "falling-weight", "--out", out, "--seed", i / 2 + 7, "--overwrite");
      assertEquals(0, run.status(), run.err());
      tables[i] = Files.readAllBytes(out);
    }
    assertArrayEquals(tables[0], tables[1]);
    assertFalse(Arrays.equals(tables[1], tables[2]));
  }

  private void write(String header, DoubleUnaryOperator... columns) throws IOException {
    Random random = new Random(4);
    List<String> lines = new ArrayList<>(List.of(header));
    for (int k = 0; k < 300; k++) {
      double t = 20 + k * 0.01;
      StringBuilder line = new StringBuilder(String.format(Locale.ROOT, "%.3f", t));
      for (DoubleUnaryOperator column : columns) {
        line.append(',').append(column.applyAsDouble(t - 20) + 0.002 * random.nextGaussian());
      }
      lines.add(line.toString());
    }
    Files.write(data, lines);
  }

  @Test
  void measuredPositionsAreEstimatedWithAndWithoutAccelerations() throws IOException {
    write("t_s,x_m", t -> 3 - 2 * t * t);
    Object[] fall = {"example", "falling-weight", "--data", data, "--out", out, "--overwrite"};
    assertEquals(0, CommandRun.of(fall).status());
    assertLast(-4, "a_m_s2", 3);
    double alone = last("sd_a_m_s2");
    write("t_s, x_m , a_m_s2,remark", t -> 3 - 2 * t * t, t -> -4, t -> 0);
    CommandRun run = CommandRun.of(fall);
    assertEquals(0, run.status(), run.err());
    assertLast(-4, "a_m_s2", 3);
    assertTrue(last("sd_a_m_s2") < alone);
    assertEquals(22.99, last("t_s"), 1e-9);
    assertFalse(run.err().contains("warning"), run.err());
  }

  @Test
  void fallInAnotherUnitCausesAWarning() throws IOException {
    for (double perMetre : new double[] {100, 1000}) {
      // its least-squares parabola fits, the filter does not
      write("t_s,x_m", t -> perMetre * (3 - 5 * t * t));
      CommandRun run =
          CommandRun.of("example", "falling-weight", "--data", data, "--out", out, "--overwrite");
      assertEquals(0, run.status(), run.err());
      assertTrue(run.err().contains("not in metres"), run.err());
    }
  }

  @Test
  void measuredOscillationsAreIdentifiedAndOtherMotionsCauseAWarning() throws IOException {
    DoubleUnaryOperator motion = t -> 0.2 * Math.exp(-0.1 * t) * Math.cos(15 * t);
    write("t_s,x_m", motion);
    Object[] command = {"example", "oscillator", "--data", data, "--out", out, "--overwrite"};
    CommandRun run = CommandRun.of(command);
    assertEquals(0, run.status(), run.err());
    assertFalse(run.err().contains("warning"), run.err());
    assertLast(Math.hypot(15, 0.1), "frequency_rad_s", 3);
    write("t_s,x_m", t -> 0.5 + motion.applyAsDouble(t));
    run = CommandRun.of(command);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("warning") && run.err().contains("from rest"), run.err());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "time,x_m|line 1: there is no column t_s",
        "t_s,x|line 1: there is no column x_m",
        "t_s,x_m;0,1;1,NaN;2,3|line 3: x_m is \"NaN\"",
        "t_s,x_m;0,1;1,;2,3|line 3: x_m is \"\"",
        "t_s,x_m;0,1;inf,2|line 3: t_s is \"inf\"",
        "t_s,x_m;0,1;1,2d|line 3: x_m is \"2d\"",
        "t_s,x_m,a_m_s2;0,1,2;1,2,x|line 3: a_m_s2 is \"x\"",
        "t_s,x_m;0,1;1|line 3: it has 1 fields, not 2",
        "t_s,x_m;0,1;2,2;1,3|line 4: t_s is 1.0, not after the row above",
        "t_s,x_m;0,1;0,2|line 3: t_s is 0.0, not after the row above",
        "t_s,x_m;0,1|line 2: the table ends after 1 row; at least 8",
        "t_s,x_m|line 1: the table ends after 0 rows",
        "t_s,x_m;0,1;1,1;2,1;3,1;4,1;5,1;6,1;7,1|x_m never changes",
        "t_s,x_m,a_m_s2;0,1,9;1,2,9;2,3,9;3,5,9;4,4,9;5,3,9;6,2,9;7,1,9|a_m_s2 never changes",
        "t_s,x_m;0,1e90;1,0;2,3;3,5;4,4;5,3;6,2;7,1|x_m has a noise of ",
      })
  void invalidTableIsReportedWithItsLineAndNoOutput(String text, String told) throws IOException {
    Files.writeString(data, text.replace(";", "\n") + "\n");
    for (String example : new String[] {"falling-weight", "oscillator"}) {
      CommandRun run =
          CommandRun.of("example", example, "--data", data, "--out", out, "--plots", plots);
      assertFailed(run, 1, data + ": ", told);
      assertFalse(Files.exists(out) || Files.exists(plots));
    }
  }

  private static void assertFailed(CommandRun run, int status, String... expected) {
    assertEquals(status, run.status(), run.err());
    assertTrue(status == 2 || run.errorLines().size() == 1, run.err());
    for (String word : expected) {
      assertTrue(run.err().contains(word), run.err());
    }
    assertFalse(run.err().contains("\tat "), run.err());
    assertEquals("", run.out());
  }

  @Test
  void invalidAndOverlongFilesAreRejected() throws IOException {
    Object[] command = {"example", "oscillator", "--data", data, "--out", out};
    assertFailed(CommandRun.of(command), 1, data.toString(), "no such file");
    Files.createDirectory(data);
    assertFailed(CommandRun.of(command), 1, data.toString(), "this is a folder");
    Files.delete(data);
    Files.writeString(data, "");
    assertFailed(CommandRun.of(command), 1, data.toString(), "empty");
    Files.write(data, new byte[] {'t', (byte) 0xff, (byte) 0xfe});
    assertFailed(CommandRun.of(command), 1, data.toString(), "UTF-8");
    List<String> lines = new ArrayList<>(List.of("t_s,x_m"));
    for (int k = 0; k <= 20_000; k++) {
      lines.add(k + "," + k % 7);
    }
    Files.write(data, lines);
    assertFailed(CommandRun.of(command), 1, data + ": line 20002", "20000 rows");
  }

  @Test
  void oscillatorRejectsGapsLongerThanASecond() throws IOException {
    Files.writeString(data, "t_s,x_m\n0,1\n1,2\n2,1\n3,0\n4,1\n7,2\n8,1\n9,0\n");
    Object[] command = {"example", "oscillator", "--data", data, "--out", out};
    assertFailed(CommandRun.of(command), 1, data + ": ", "for 3.0 s before t_s = 7.0");
    assertFalse(Files.exists(out));
    command[1] = "falling-weight";
    assertEquals(0, CommandRun.of(command).status());
  }

  @Test
  void existingOutputsAreRejectedAndUnchanged() throws IOException {
    Files.writeString(out, "mine");
    Object[] command = {"example", "falling-weight", "--out", out, "--plots", plots};
    assertFailed(CommandRun.of(command), 1, out.toString(), "--overwrite");
    assertEquals("mine", Files.readString(out));
    Files.delete(out);
    Files.createDirectory(plots);
    Path plot = Files.writeString(plots.resolve("falling-weight-gains.svg"), "mine");
    assertFailed(CommandRun.of(command), 1, plot.toString(), "--overwrite");
    try (Stream<Path> files = Files.list(plots)) {
      assertEquals(List.of(plot), files.toList());
    }
    assertFalse(Files.exists(out));
    write("t_s,x_m", t -> t * t);
    assertFailed(
        CommandRun.of("example", "oscillator", "--data", data, "--out", data, "--overwrite"),
        1,
        "same file");
    assertFailed(
        CommandRun.of("example", "oscillator", "--out", out, "--plots", data, "--overwrite"),
        1,
        data.toString(),
        "folder");
    assertFalse(Files.exists(out));
  }

  @Test
  void plotsInTheTablesPlaceAreRefusedBeforeTheirFolderIsMade() {
    assertFailed(
        CommandRun.of("example", "oscillator", "--out", out, "--plots", out),
        2,
        out + " would be written by two outputs");
    assertFalse(Files.exists(out));
  }

  @ParameterizedTest
  @ValueSource(strings = {"pendulum", "Falling-Weight"})
  void unknownExampleIsAWrongArgument(String name) {
    assertFailed(
        CommandRun.of("example", name, "--out", out), 2, name, "falling-weight, oscillator");
  }

  @Test
  void missingAndContradictoryOptionsAreWrongArguments() {
    assertFailed(CommandRun.of("example", "oscillator"), 2, "--out");
    assertFailed(CommandRun.of("example", "--out", out), 2, "EXAMPLE");
    assertFailed(
        CommandRun.of("example", "oscillator", "--out", out, "--data", data, "--seed", 3),
        2,
        "--seed");
  }
}
