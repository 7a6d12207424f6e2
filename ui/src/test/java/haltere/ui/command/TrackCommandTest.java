package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class TrackCommandTest {
  private static final String CLUSTER_COLUMNS =
      "t_us,id,x_px,y_px,vx_px_s,vy_px_s,sd_x_px,sd_y_px,sd_vx_px_s,sd_vy_px_s,events";
  private static final String EXTENT_COLUMNS = ",major_px,minor_px,angle_rad,existence";
  private static final String OBJECT_COLUMNS = CLUSTER_COLUMNS + EXTENT_COLUMNS;
  private static final String ADDED_COLUMNS = ",event_rate_hz,age_s,low_y_px";
  private static final String COLUMNS = OBJECT_COLUMNS + ADDED_COLUMNS;
  private static final String METRES =
      ",x_m,y_m,vx_m_s,vy_m_s,sd_x_m,sd_y_m,sd_vx_m_s,sd_vy_m_s,speed_km_h,sd_speed_km_h,lane";

  @TempDir Path folder;

  private Path in;
  private Path out;

  @BeforeEach
  void simulate() {
    in = folder.resolve("dots.aedat");
    out = folder.resolve("tracks.csv");
    CommandRun made =
        CommandRun.of(
            "simulate",
            "dots",
            in,
            "--duration",
            "1",
            "--set",
            "dots.count=2",
            "--set",
            "run.startUs=5000000",
            "--set",
            "noise.shotHz=0");
    assertEquals(0, made.status(), made.err());
  }

  private List<String[]> rows(Path table) throws IOException {
    return Files.readAllLines(table).stream().skip(1).map(row -> row.split(",", -1)).toList();
  }

  @Test
  void eachObjectHasARowAtEachTick() throws IOException {
    CommandRun run = CommandRun.of("track", in, "--out", out);
    assertEquals(0, run.status(), run.err());
    assertEquals(COLUMNS, Files.readAllLines(out).get(0));
    List<String[]> rows = rows(out);
    assertTrue(rows.size() > 120, rows.size() + " rows");
    for (String[] row : rows) {
      long timeUs = Long.parseLong(row[0]);
      assertTrue(timeUs > 5_000_000 && timeUs < 6_000_000, row[0]);
      assertEquals(0, timeUs % 10_000);
      assertEquals(18, row.length);
      for (int i = 6; i < 10; i++) {
        assertTrue(Double.parseDouble(row[i]) > 0, Arrays.toString(row));
      }
      double major = Double.parseDouble(row[11]);
      double minor = Double.parseDouble(row[12]);
      assertTrue(minor > 0 && major >= minor, Arrays.toString(row));
      double existence = Double.parseDouble(row[14]);
      assertTrue(existence > 0 && existence <= 1, Arrays.toString(row));
    }
    assertTrue(run.err().contains("wrote " + out + " ("), run.err());
  }

  @Test
  void rowsAscendInTimeDespiteDeferredObjects() throws IOException {
    assertEquals(0, CommandRun.of("track", in, "--out", out).status());
    List<String[]> rows = rows(out);
    for (int i = 1; i < rows.size(); i++) {
      long step = Long.parseLong(rows.get(i)[0]) - Long.parseLong(rows.get(i - 1)[0]);
      assertTrue(step >= 0, Arrays.toString(rows.get(i)));
      boolean isAnother = Integer.parseInt(rows.get(i)[1]) > Integer.parseInt(rows.get(i - 1)[1]);
      assertTrue(step > 0 || isAnother, Arrays.toString(rows.get(i)));
    }
  }

  @Test
  void tracksNearADotHaveItsVelocity() throws IOException {
    assertEquals(0, CommandRun.of("track", in, "--out", out).status());
    List<String[]> rows = rows(out);
    long lastUs = Long.parseLong(rows.get(rows.size() - 1)[0]);
    List<String[]> last = rows.stream().filter(row -> Long.parseLong(row[0]) == lastUs).toList();
    assertEquals(2, last.size(), "tracks at the end");
    for (String[] row : last) {
      double speed = Math.hypot(Double.parseDouble(row[4]), Double.parseDouble(row[5]));
      assertEquals(150, speed, 20);
      // Circles about the middle: the velocity is orthogonal to the radius.
      double along =
          (Double.parseDouble(row[2]) - 63.5) * Double.parseDouble(row[4])
              + (Double.parseDouble(row[3]) - 63.5) * Double.parseDouble(row[5]);
      assertEquals(0, along, 0.2 * 60 * speed);
    }
  }

  @Test
  void rateSetsTheTimesOfRows() throws IOException {
    assertEquals(0, CommandRun.of("track", in, "--out", out, "--rate", "30").status());
    for (String[] row : rows(out)) {
      long timeUs = Long.parseLong(row[0]);
      long tick = Math.round(timeUs * 30e-6);
      assertEquals(Math.round(tick * 1e6 / 30), timeUs);
    }
  }

  @Test
  void rateMayBeGivenAsASetting() throws IOException {
    assertEquals(0, CommandRun.of("track", in, "--out", out, "--rate", "30").status());
    Path other = folder.resolve("other.csv");
    CommandRun run = CommandRun.of("track", in, "--out", other, "--set", "reportRateHz=30");
    assertEquals(0, run.status(), run.err());
    assertEquals(-1, Files.mismatch(out, other));
  }

  @Test
  void originalPresetTracksClusterCentres() throws IOException {
    assertEquals(0, CommandRun.of("track", in, "--out", out).status());
    String usual = Files.readString(out);
    CommandRun run =
        CommandRun.of("track", in, "--out", out, "--preset", "original", "--overwrite");
    assertEquals(0, run.status(), run.err());
    List<String[]> rows = rows(out);
    assertTrue(rows.size() > 20, rows.size() + " rows");
    assertEquals(CLUSTER_COLUMNS, Files.readAllLines(out).get(0));
    assertNotEquals(usual, Files.readString(out));
    // R rises towards 8 px², so that it is less sure than with the defaults
    assertTrue(Double.parseDouble(rows.get(rows.size() - 1)[6]) > 0.3);
  }

  @Test
  void roadAddsColumnsInMetres() throws IOException {
    checkRoad(OBJECT_COLUMNS + METRES + ADDED_COLUMNS, 15, "vehicles.heightShare=1");
    String[] crossing = Files.readAllLines(folder.resolve("crossings.csv")).get(1).split(",");
    assertEquals("TOWARDS", crossing[3]);
    assertEquals(58, Double.parseDouble(crossing[5]), 2 * Double.parseDouble(crossing[6]));
    assertEquals(58, Double.parseDouble(crossing[5]), 10);
  }

  @Test
  void vehiclePriorIsASettingOfTheRoad() throws IOException {
    Path road = folder.resolve("road.json");
    Files.writeString(road, "{\"vehicles\": {\"speedMS\": 0}}");
    CommandRun run = CommandRun.of("track", in, "--out", out, "--road", road);
    assertNotEquals(0, run.status());
    assertTrue(run.err().contains("speedMS"), run.err());
  }

  @Test
  void settingsOfAnEarlierVersionInARoadFileAreReadAndNamed() throws IOException {
    Path road = folder.resolve("road.json");
    Files.writeString(road, "{\"bridgeHeightM\": 5, \"countingLines\": {\"apartM\": 9}}");
    CommandRun run = CommandRun.of("track", in, "--out", out, "--road", road);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("road.json: "), run.err());
    assertTrue(run.err().contains("apartM -> spacingM"), run.err());
  }

  @Test
  void roadAddsColumnsInMetresToKalmanTracks() throws IOException {
    Path chain = folder.resolve("chain.json");
    Files.writeString(
        chain,
        """
        {"filters": [
          {"filter": "background-activity", "settings": {"correlationUs": 10000}},
          {"filter": "hot-pixels"},
          {"filter": "kalman-tracks"}
        ]}
        """);
    // Vehicles are narrower than the clusters' usual size.
    checkRoad(
        CLUSTER_COLUMNS + METRES,
        11,
        "vehicles.heightShare=0",
        "--chain",
        chain,
        "--set",
        "clusters.shape.size=0.03");
  }

  private void checkRoad(String columns, int firstOfMetres, String scene, Object... options)
      throws IOException {
    Path cars = folder.resolve("road.aedat");
    CommandRun made =
        CommandRun.of(
            "simulate", "road", cars, "--duration", "4", "--set", scene, "--set", "noise.shotHz=0");
    assertEquals(0, made.status(), made.err());
    Path road = folder.resolve("road.json");
    Files.writeString(
        road,
        """
        {"bridgeHeightM": 5, "nearestM": 6, "farthestM": 300,
         "vanishingPoint": {"xPx": 63.5, "yPx": 127},
         "lanes": {"lanes": 4, "leftEdgeM": -7, "widthM": 3.5}, "countingLines": {"lines": 2}}
        """);
    Path crossings = folder.resolve("crossings.csv");
    CommandRun run =
        CommandRun.of(
            Stream.concat(
                    Stream.of("track", cars, "--out", out, "--road", road),
                    Stream.concat(Stream.of("--crossings", crossings), Stream.of(options)))
                .toArray());
    assertEquals(0, run.status(), run.err());
    List<String> crossed = Files.readAllLines(crossings);
    assertEquals(
        "t_us,id,line_m,direction,lane,speed_km_h,sd_speed_km_h,count_away,count_towards",
        crossed.get(0));
    assertTrue(crossed.size() > 1, "nobody crossed a line");
    assertEquals(columns, Files.readAllLines(out).get(0));
    List<String[]> rows = rows(out);
    assertTrue(rows.size() > 100, rows.size() + " rows");
    long onTheRoad =
        rows.stream()
            .filter(row -> Math.abs(Double.parseDouble(row[firstOfMetres])) < 9)
            .filter(row -> isFrom4To130(Double.parseDouble(row[firstOfMetres + 1])))
            .count();
    assertTrue(onTheRoad > 0.9 * rows.size(), onTheRoad + " of " + rows.size());
  }

  private static boolean isFrom4To130(double metres) {
    return metres > 4 && metres < 130;
  }

  @Test
  void givenChainIsUsedAndCompletedByTheObjectTracker() throws IOException {
    Path chain = folder.resolve("chain.json");
    Files.writeString(
        chain,
        """
        {"filters": [
          {"filter": "refractory"},
          {"filter": "kalman-tracks", "settings": {"life": {"eventsTillTrack": 500}}}
        ]}
        """);
    assertEquals(0, CommandRun.of("track", in, "--out", out, "--chain", chain).status());
    assertEquals(CLUSTER_COLUMNS, Files.readAllLines(out).get(0));
    for (String[] row : rows(out)) {
      assertTrue(Long.parseLong(row[10]) >= 500, Arrays.toString(row));
    }
    Files.writeString(chain, "{\"filters\": [{\"filter\": \"cluster-tracker\"}]}");
    Path other = folder.resolve("other.csv");
    assertEquals(0, CommandRun.of("track", in, "--out", other, "--chain", chain).status());
    assertEquals(COLUMNS, Files.readAllLines(other).get(0));
    assertTrue(rows(other).size() > 100);
  }

  @Test
  void chainOfAnEarlierVersionIsReadWithAHintToTheReplacedSetting() throws IOException {
    Path chain = folder.resolve("chain.json");
    Files.writeString(
        chain,
        """
        {"filters": [
          {"filter": "kalman-tracks", "settings": {"measurement": {"eventsTillTrack": 500},
                                                   "life": {"updatesTillShown": 40}}}
        ]}
        """);
    CommandRun run = CommandRun.of("track", in, "--out", out, "--chain", chain);
    assertEquals(0, run.status(), run.err());
    String line = run.errorLines().get(0);
    assertTrue(line.contains("measurement.eventsTillTrack -> life.eventsTillTrack"), line);
    assertTrue(line.contains("life.updatesTillShown -> "), line);
    assertTrue(Long.parseLong(rows(out).get(0)[10]) >= 500);
  }

  @Test
  void settingsAreChangedByName() throws IOException {
    CommandRun run = CommandRun.of("track", in, "--out", out, "--set", "scalePx=40");
    assertEquals(0, run.status(), run.err());
    assertTrue(rows(out).size() > 100);
    Path original = folder.resolve("original.csv");
    run =
        CommandRun.of(
            "track",
            in,
            "--out",
            original,
            "--preset",
            "original",
            "--set",
            "life.eventsTillTrack=500",
            "--set",
            "life.eventsOf=each-cluster");
    assertEquals(0, run.status(), run.err());
    assertTrue(Long.parseLong(rows(original).get(0)[10]) >= 500);
  }

  @Test
  void tablesAreReproducibleInEveryLocale() throws IOException {
    assertEquals(0, CommandRun.of("track", in, "--out", out).status());
    Path again = folder.resolve("again.csv");
    Locale before = Locale.getDefault();
    try {
      Locale.setDefault(Locale.GERMANY);
      assertEquals(0, CommandRun.of("track", in, "--out", again).status());
    } finally {
      Locale.setDefault(before);
    }
    assertEquals(-1, Files.mismatch(out, again));
  }

  @Test
  void recordingWithoutEventsGivesAnEmptyTable() throws IOException {
    Path empty = folder.resolve("empty.csv");
    Files.writeString(empty, "t_us,x,y,on\n");
    CommandRun run = CommandRun.of("track", empty, "--sensor", "128x128", "--out", out);
    assertEquals(0, run.status(), run.err());
    assertEquals(List.of(COLUMNS), Files.readAllLines(out));
  }

  @Test
  void wrongArgumentsAreReportedWithTheUsage() {
    assertFails(2, "--out", "track", in);
    assertFails(2, "--when-full", "track", in, "--out", out, "--when-full", "oldest");
    assertFails(2, "--rate", "track", in, "--out", out, "--rate", "0");
    assertFails(2, "--rate", "track", in, "--out", out, "--rate", "NaN");
    assertFails(2, "--rate", "track", in, "--out", out, "--rate", "fast");
    assertFails(2, "life.none", "track", in, "--out", out, "--set", "life.none=1");
    assertFails(2, "scalePx", "track", in, "--out", out, "--set", "scalePx=-1");
    assertFails(2, "confirmS", "track", in, "--out", out, "--set", "confirmS=NaN");
    String coast = "life.coastTimeS=-1";
    assertFails(2, "coastTimeS", "track", in, "--out", out, "--preset", "original", "--set", coast);
    assertFails(2, "no preset new", "track", in, "--out", out, "--preset", "new");
    assertFails(2, "--chain", "track", in, "--out", out, "--preset", "original", "--chain", in);
  }

  @Test
  void invalidInputIsReportedInOneLineAndLeavesNoOutput() throws IOException {
    Path json = folder.resolve("x.json");
    for (String text :
        List.of("", "[]", "{\"filters\": 1}", "{\"filters\": [{\"filter\": \"?\"}]}")) {
      Files.writeString(json, text);
      assertFails(1, json.toString(), "track", in, "--out", out, "--chain", json);
    }
    for (String text :
        List.of(
            "",
            "[]",
            "{\"bridgeHeightM\": -1}",
            "{\"bridge\": 5}",
            "{\"nearestM\": 50, \"farthestM\": 20}",
            "{\"lanes\": 4}",
            "{\"lanes\": {\"lanes\": -1}}",
            "{\"countingLines\": 20}",
            "{\"countingLines\": {\"spacingM\": 0}}",
            "{\"vanishingPoint\": {\"yPx\": 0}}")) {
      Files.writeString(json, text);
      assertFails(1, json.toString(), "track", in, "--out", out, "--road", json);
    }
    Path counts = folder.resolve("counts.csv");
    Files.writeString(json, "{}");
    assertFails(1, "lines", "track", in, "--out", out, "--road", json, "--crossings", counts);
    Path none = folder.resolve("none.json");
    assertFails(1, "none.json", "track", in, "--out", out, "--road", none);
    assertFails(1, "none.json", "track", in, "--out", out, "--chain", none);
    assertFails(1, "none.json", "track", none, "--out", out);
    assertFails(1, "same file", "track", in, "--out", in, "--overwrite");
    assertFails(2, "--road", "track", in, "--out", out, "--crossings", counts);
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(
          List.of("dots.aedat", "x.json"),
          files.map(file -> file.getFileName().toString()).sorted().toList());
    }
  }

  private static void assertFails(int status, String word, Object... arguments) {
    CommandRun run = CommandRun.of(arguments);
    assertEquals(status, run.status(), run.err());
    assertTrue(run.errorLines().get(0).contains(word), run.err());
    assertTrue(status == 2 || run.errorLines().size() == 1, run.err());
    assertFalse(run.err().contains("\tat "), run.err());
  }

  @Test
  void existingTableIsReplacedOnlyWithOverwrite() throws IOException {
    Files.writeString(out, "mine");
    assertFails(1, out + ": exists already", "track", in, "--out", out);
    assertEquals("mine", Files.readString(out));
    assertEquals(0, CommandRun.of("track", in, "--out", out, "--overwrite").status());
    assertTrue(Files.readString(out).startsWith(COLUMNS));
  }

  @Test
  void truncatedFileIsReadUpToItsEndAndRejectedWithStrict() throws IOException {
    byte[] whole = Files.readAllBytes(in);
    Files.write(in, Arrays.copyOf(whole, whole.length - 3));
    CommandRun strict = CommandRun.of("track", in, "--out", out, "--strict");
    assertEquals(1, strict.status(), strict.err());
    assertFalse(Files.exists(out));
    CommandRun lenient = CommandRun.of("track", in, "--out", out);
    assertEquals(0, lenient.status(), lenient.err());
    assertTrue(lenient.err().contains("warning"), lenient.err());
  }

  @Test
  void fourPointsOfAPlaneYieldPositionsInMetres() throws IOException {
    Path plane = folder.resolve("arena.json");
    Files.writeString(
        plane,
        """
        {"points": [{"xPx": 0, "yPx": 0, "xM": 0, "yM": 0}, {"xPx": 100, "yPx": 0, "xM": 1, "yM": 0},
         {"xPx": 100, "yPx": 100, "xM": 1, "yM": 1}, {"xPx": 0, "yPx": 100, "xM": 0, "yM": 1}]}
        """);
    CommandRun run = CommandRun.of("track", in, "--out", out, "--road", plane);
    assertEquals(0, run.status(), run.err());
    List<String> header = List.of(Files.readAllLines(out).get(0).split(","));
    for (String[] row : rows(out)) {
      double x = Double.parseDouble(row[header.indexOf("x_px")]);
      double y = Double.parseDouble(row[header.indexOf("y_px")]);
      assertEquals(x / 100, Double.parseDouble(row[header.indexOf("x_m")]), 1e-3);
      assertEquals(y / 100, Double.parseDouble(row[header.indexOf("y_m")]), 1e-3);
    }
  }

  @Test
  void degeneratePointsOfAPlaneAreReportedInOneLine() throws IOException {
    for (String points : List.of("3", "[]", "[{\"xPx\": 1}]")) {
      Path plane = folder.resolve("arena.json");
      Files.writeString(plane, "{\"points\": " + points + "}");
      CommandRun run = CommandRun.of("track", in, "--out", out, "--road", plane, "--overwrite");
      assertNotEquals(0, run.status());
      assertTrue(run.err().contains("points"), run.err());
      assertEquals(1, run.err().strip().lines().count(), run.err());
    }
  }
}
