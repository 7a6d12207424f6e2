package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.internal.hdf5.Hdf5TableWriter;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.Hdf5Column;
import haltere.core.format.internal.hdf5.Hdf5TableWriter.NumberType;
import haltere.core.format.internal.hdf5.Hdf5Tables;
import haltere.core.simulation.internal.flight.FlightScene;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.core.simulation.internal.flight.FlightTruth;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class OrientCommandTest {
  private static final String COLUMNS =
      "t_us,object,x_m,y_m,z_m,ux,uy,uz,sd_axis_rad,p_rad_s,q_rad_s,r_rad_s,used,rejected";

  private static final FlightScene FLIGHT =
      new FlightScene(FlightSettings.defaults().with("run.startUs=5000000"));

  @TempDir static Path simulated;
  @TempDir Path folder;

  private Path seen;
  private Path cameras;
  private Path out;

  @BeforeAll
  static void simulate() {
    CommandRun made =
        CommandRun.of(
            "simulate",
            "flight",
            simulated.resolve("camera-0.aedat"),
            "--duration",
            "1",
            "--set",
            "run.startUs=5000000",
            "--observations",
            simulated.resolve("seen.csv"),
            "--cameras",
            simulated.resolve("cameras.json"));
    assertEquals(0, made.status(), made.err());
  }

  @BeforeEach
  void copy() throws IOException {
    seen = Files.copy(simulated.resolve("seen.csv"), folder.resolve("seen.csv"));
    cameras = Files.copy(simulated.resolve("cameras.json"), folder.resolve("cameras.json"));
    out = folder.resolve("orientation.csv");
  }

  private CommandRun orient(Object... more) {
    List<Object> text =
        new ArrayList<>(List.of("orient", seen, "--cameras", cameras, "--out", out));
    Collections.addAll(text, more);
    return CommandRun.of(text.toArray());
  }

  private static List<String[]> rows(Path table) throws IOException {
    return Files.readAllLines(table).stream().skip(1).map(row -> row.split(",", -1)).toList();
  }

  private static double errorDeg(String[] row) {
    FlightTruth truth = FLIGHT.truthAt(Long.parseLong(row[0]));
    double dot =
        truth.ux() * Double.parseDouble(row[5])
            + truth.uy() * Double.parseDouble(row[6])
            + truth.uz() * Double.parseDouble(row[7]);
    return Math.toDegrees(Math.acos(Math.min(1, dot)));
  }

  private static double medianDeg(List<String[]> rows) {
    double[] errors = rows.stream().mapToDouble(OrientCommandTest::errorDeg).sorted().toArray();
    return errors[errors.length / 2];
  }

  @Test
  void everyTimeHasARowWithTheAxisFromTailToHead() throws IOException {
    CommandRun run = orient();
    assertEquals(0, run.status(), run.err());
    assertEquals(COLUMNS, Files.readAllLines(out).get(0));
    List<String[]> rows = rows(out);
    assertTrue(rows.size() >= 98, rows.size() + " rows");
    long lastUs = 0;
    for (String[] row : rows) {
      assertEquals(14, row.length);
      long timeUs = Long.parseLong(row[0]);
      assertTrue(timeUs > lastUs && timeUs >= 5_000_000 && timeUs < 6_000_000, row[0]);
      lastUs = timeUs;
      assertEquals("0", row[1]);
      double length = 0;
      for (int i = 2; i < 12; i++) {
        double value = Double.parseDouble(row[i]);
        assertTrue(Double.isFinite(value), String.join(",", row));
        length += i >= 5 && i <= 7 ? value * value : 0;
      }
      assertEquals(1, Math.sqrt(length), 1e-12);
      assertTrue(Integer.parseInt(row[12]) + Integer.parseInt(row[13]) <= 3);
    }
    assertTrue(medianDeg(rows.subList(20, rows.size())) < 2);
    assertTrue(run.out().contains("used for the axis"), run.out());
    assertTrue(run.out().contains("roll is not seen"), run.out());
    assertTrue(run.err().contains("wrote " + out), run.err());
  }

  @Test
  void reportContainsCamerasSettingsAndPlots() throws IOException {
    Path report = folder.resolve("report.html");
    assertEquals(0, orient("--gate-angle", "50", "--report", report).status());
    String page = Files.readString(report);
    for (String part :
        List.of("seen.csv", "cameras.json", "gate.angleDeg = 50.0", "used for the axis")) {
      assertTrue(page.contains(part), part);
    }
    for (String component : List.of("x", "y", "z", "ux", "uy", "uz", "sd axis")) {
      assertTrue(page.contains(">orientation: " + component + "<"), component);
    }
  }

  @Test
  void smoothingReducesTheError() throws IOException {
    assertEquals(0, orient().status());
    double before = medianDeg(rows(out));
    CommandRun run = orient("--smooth", "--overwrite");
    assertEquals(0, run.status(), run.err());
    List<String[]> rows = rows(out);
    assertTrue(medianDeg(rows) < before, before + " to " + medianDeg(rows));
    for (String[] row : rows) {
      assertTrue(errorDeg(row) < 90, "the wrong way round at " + row[0]);
    }
  }

  @Test
  void originalPresetHasTheSameColumns() throws IOException {
    for (String[] more : new String[][] {{}, {"--smooth"}}) {
      CommandRun run =
          more.length == 0
              ? orient("--preset", "original", "--overwrite")
              : orient("--preset", "original", "--overwrite", more[0]);
      assertEquals(0, run.status(), run.err());
      assertEquals(COLUMNS, Files.readAllLines(out).get(0));
      assertTrue(rows(out).size() >= 98);
    }
  }

  @Test
  void gateOfZeroRejectsAndGateOf180AcceptsAllLines() throws IOException {
    for (String mode : new String[] {"--quiet", "--smooth"}) {
      CommandRun none = orient("--gate-angle", "0", "--overwrite", mode);
      assertEquals(0, none.status(), none.err());
      assertEquals(List.of(COLUMNS), Files.readAllLines(out));
      assertTrue(none.err().contains("accepted lines of two cameras"), none.err());
      assertTrue(none.out().contains(" 0 used for the axis"), none.out());
    }
    assertEquals(0, orient("--gate-angle", "180", "--overwrite").status());
    List<String[]> rows = rows(out);
    assertTrue(rows.size() >= 98);
    for (String[] row : rows) {
      assertEquals("0", row[13]);
    }
  }

  @Test
  void folderIsReportedByName() {
    Path output = folder.resolve("none.csv");
    for (Path[] input : new Path[][] {{folder, cameras}, {seen, folder}}) {
      CommandRun run = CommandRun.of("orient", input[0], "--cameras", input[1], "--out", output);
      assertEquals(1, run.status(), run.err());
      assertTrue(run.err().contains(folder + ": this is a folder"), run.err());
    }
  }

  @Test
  void smallDetectionsAreNotUsed() {
    CommandRun run = orient("--min-area", "100000");
    assertEquals(0, run.status(), run.err());
    assertTrue(run.out().contains("too small"), run.out());
    // the cameras are not what is missing
    assertTrue(run.err().contains("no orientation found: each needs accepted lines"), run.err());
    assertTrue(run.err().contains("the counts above tell what is missing"), run.err());
  }

  @Test
  void severalBodiesAreSeparatedAndRowsStayInOrder() throws IOException {
    List<String> lines = new ArrayList<>();
    for (String line : Files.readAllLines(seen)) {
      lines.add(line);
      String[] fields = line.split(",", -1);
      if (!fields[2].equals("object")) {
        fields[2] = "\"second, too\"";
        lines.add(String.join(",", fields));
      }
    }
    Files.write(seen, lines);
    for (String mode : new String[] {"--quiet", "--smooth"}) {
      CommandRun run = orient("--overwrite", mode);
      assertEquals(0, run.status(), run.err());
      List<String> rows = Files.readAllLines(out);
      assertTrue(rows.size() > 196, rows.size() + " rows");
      assertTrue(rows.get(1).contains(",0,") && rows.get(2).contains(",\"second, too\","));
      assertTrue(run.out().contains("2 bodies"), run.out());
    }
  }

  @Test
  void invalidRowsAreReportedWithTheirLineAndSkipped() throws IOException {
    assertEquals(0, orient().status());
    List<String> good = Files.readAllLines(out);
    List<String> lines = new ArrayList<>(Files.readAllLines(seen));
    int from = lines.size();
    lines.add("4000000,camera-0,0,1,1,0.1,1,2");
    lines.add("7000000,camera-9,0,1,1,0.1,1,2");
    lines.add("7000000,camera-0,0,1,1");
    lines.add("late,camera-0,0,1,1,0.1,1,2");
    lines.add("7000000,camera-0,0,1,wide,0.1,1,2");
    Files.write(seen, lines);
    CommandRun run = orient("--overwrite");
    assertEquals(0, run.status(), run.err());
    for (int i = 1; i <= 5; i++) {
      assertTrue(run.err().contains(seen + ": line " + (from + i) + ": "), run.err());
    }
    assertEquals(good, Files.readAllLines(out));
  }

  @Test
  void nonNumericAnglesAndEmptyFieldsAreUnknown() throws IOException {
    List<String> lines = new ArrayList<>();
    int changed = 0;
    for (String line : Files.readAllLines(seen)) {
      String[] fields = line.split(",", -1);
      if (fields[1].equals("camera-1")) {
        fields[5] = changed++ % 2 == 0 ? "NaN" : "";
        fields[6] = "";
        fields[7] = "";
      }
      lines.add(String.join(",", fields));
    }
    Files.write(seen, lines);
    CommandRun run = orient();
    assertEquals(0, run.status(), run.err());
    assertTrue(run.out().contains("without an angle"), run.out());
    assertTrue(rows(out).size() > 80);
    assertFalse(Files.readString(out).contains("NaN"));
  }

  /** The same lines as Flydra stores them. */
  private Path flydra() throws IOException {
    Path file = folder.resolve("flydra.h5");
    List<Hdf5Column> columns = new ArrayList<>();
    for (String name : List.of("camn", "frame", "timestamp", "x", "y", "slope", "eccentricity")) {
      columns.add(new Hdf5Column(name, NumberType.F64));
    }
    try (Hdf5TableWriter table = Hdf5TableWriter.create(file, "data2d_distorted", columns, false)) {
      for (String[] row : rows(seen)) {
        double[] numbers = new double[8];
        for (int i = 3; i < 8; i++) {
          numbers[i] = row[i].isEmpty() ? Double.NaN : Double.parseDouble(row[i]);
        }
        double timeUs = Double.parseDouble(row[0]);
        table.append(
            row[1].charAt(row[1].length() - 1) - '0',
            timeUs / 10_000,
            timeUs * 1e-6,
            numbers[3],
            numbers[4],
            Math.tan(numbers[5]),
            numbers[7]);
      }
      table.finish();
    }
    return file;
  }

  @Test
  void hdf5LinesGiveTheSameAxesWithPlueckerCoordinates() throws IOException {
    assertEquals(0, orient().status());
    List<String[]> expected = rows(out);
    Path file = flydra();
    CommandRun run =
        CommandRun.of("orient", file, "--cameras", cameras, "--out", out, "--overwrite");
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("all are taken for one"), run.err());
    assertEquals(
        COLUMNS + ",frame,hz_line0,hz_line1,hz_line2,hz_line3,hz_line4,hz_line5",
        Files.readAllLines(out).get(0));
    List<String[]> rows = rows(out);
    assertEquals(expected.size(), rows.size());
    for (int k = 0; k < rows.size(); k++) {
      String[] row = rows.get(k);
      assertEquals(Long.parseLong(row[0]) / 10_000, Long.parseLong(row[14]), "frame");
      for (int i = 2; i < 9; i++) {
        assertEquals(Double.parseDouble(expected.get(k)[i]), Double.parseDouble(row[i]), 1e-6);
      }
      assertEquals(row[5], row[17].startsWith("-") ? row[17].substring(1) : "-" + row[17]);
      assertEquals(row[6], row[19]);
    }

    Path lines = folder.resolve("lines.h5");
    run = CommandRun.of("orient", file, "--cameras", cameras, "--out", lines, "--smooth");
    assertEquals(0, run.status(), run.err());
    try (Hdf5Tables tables = Hdf5Tables.open(lines)) {
      tables.read(
          "ML_estimates",
          List.of("obj_id", "frame", "timestamp", "x", "hz_line2", "hz_line4", "hz_line5"),
          7,
          row -> {
            String[] same = rows.get((int) row.index());
            assertEquals("0", row.text(0));
            assertEquals(same[14], row.text(1));
            assertEquals(Long.parseLong(same[0]) * 1e-6, row.number(2), 1e-9);
            assertEquals(Double.parseDouble(same[2]), row.number(3), 0.01);
            assertEquals(
                1,
                Math.sqrt(
                    Math.pow(row.number(4), 2)
                        + Math.pow(row.number(5), 2)
                        + Math.pow(row.number(6), 2)),
                1e-6);
          });
    }
    assertFailed(
        2, "frames", "orient", seen, "--cameras", cameras, "--out", folder.resolve("no.h5"));
    byte[] whole = Files.readAllBytes(file);
    Files.write(file, java.util.Arrays.copyOf(whole, whole.length / 2));
    assertFailed(
        1, "ends before", "orient", file, "--cameras", cameras, "--out", out, "--overwrite");
    assertEquals(rows.size(), rows(out).size(), "what was there stays");
  }

  @Test
  void invalidInputsAreReportedInOneLine() throws IOException {
    Path single = folder.resolve("one.json");
    String all = Files.readString(cameras);
    Files.writeString(single, "{\"cameras\": []}");
    assertFailed(1, "no camera", "orient", seen, "--cameras", single, "--out", out);
    Files.writeString(single, "{\"cameras\": 3}");
    assertFailed(1, "cameras", "orient", seen, "--cameras", single, "--out", out);
    Path none = folder.resolve("none.csv");
    assertFailed(1, "no such file", "orient", none, "--cameras", cameras, "--out", out);
    assertFailed(2, "--cameras", "orient", seen, "--out", out);
    assertFailed(2, "--gate-angle", "orient", seen, "--cameras", cameras);
    assertFailed(
        2,
        "gate.angleDeg",
        "orient",
        seen,
        "--cameras",
        cameras,
        "--out",
        out,
        "--gate-angle",
        "200");
    assertFailed(
        2, "original", "orient", seen, "--cameras", cameras, "--out", out, "--preset", "x");
    Files.writeString(none, "t_us,camera\n1,2\n");
    assertFailed(1, "object", "orient", none, "--cameras", cameras, "--out", out);
    Files.writeString(
        none, "t_us,camera,object,x_px,y_px,angle_rad,area_px,eccentricity\n1,x,2,3,4,5,6,7\n");
    assertFailed(1, "none of its 1 rows", "orient", none, "--cameras", cameras, "--out", out);
    assertFalse(Files.exists(out));
    Files.writeString(out, "mine");
    assertFailed(1, "exists", "orient", seen, "--cameras", cameras, "--out", out);
    assertEquals("mine", Files.readString(out));
    assertTrue(all.contains("camera-2"));
  }

  private static void assertFailed(int status, String text, Object... command) {
    CommandRun run = CommandRun.of(command);
    assertEquals(status, run.status(), run.err());
    assertTrue(run.err().contains(text), run.err());
    assertFalse(run.err().contains("\tat "), run.err());
  }

  @Test
  void singleUsefulCameraIsReportedAndGivesAnEmptyTable() throws IOException {
    Files.writeString(
        cameras,
        """
{"cameras": [
  {"id": "camera-0", "matrix": [[800, 0, 320, 10], [0, 820, 240, 20], [0, 0, 1, 2]]},
  {"id": "camera-1", "matrix": [[800, 0, 320, 10], [0, 820, 240, 20], [800, 820, 560, 30]]},
  {"id": "camera-2", "matrix": [[0, 0, 0, 0], [0, 0, 0, 0], [0, 0, 0, 0]]}]}
""");
    CommandRun run = orient();
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("camera camera-1 is left out"), run.err());
    assertTrue(run.err().contains("one camera"), run.err());
    assertTrue(run.out().contains("cannot be used"), run.out());
    assertTrue(run.out().contains("body 0: no line was compared with an axis"), run.out());
    assertFalse(run.out().contains("NaN") || run.out().contains("roll"), run.out());
    assertEquals(List.of(COLUMNS), Files.readAllLines(out));
  }
}
