package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.testing.Recorded;
import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.StringReader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.util.ArrayList;
import java.util.Base64;
import java.util.HexFormat;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.imageio.ImageIO;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.xml.sax.InputSource;

class ReportTest {
  private static final Pattern PLOT = Pattern.compile("<svg .*?</svg>", Pattern.DOTALL);
  private static final Pattern PICTURE = Pattern.compile("src=\"data:image/png;base64,([^\"]+)\"");

  @TempDir Path folder;

  private Path scene(String name, String kind, String seconds) {
    Path file = folder.resolve(name);
    CommandRun run = CommandRun.of("simulate", kind, file, "--duration", seconds);
    assertEquals(0, run.status(), run.err());
    return file;
  }

  /** Runs a command with a report, which has to be one page that needs nothing else. */
  private String page(Object... arguments) throws Exception {
    Path report = folder.resolve("report.html");
    Object[] all = java.util.Arrays.copyOf(arguments, arguments.length + 2);
    all[arguments.length] = "--report";
    all[arguments.length + 1] = report;
    CommandRun run = CommandRun.of(all);
    assertEquals(0, run.status(), run.err());
    String page = Files.readString(report);
    assertFalse(page.contains("<script") || page.contains("<link"), "the page stands alone");
    // the letters of a picture may say anything
    String text = page.replaceAll("base64,[^\"]*", "");
    assertFalse(text.replace("http://www.w3.org/2000/svg", "").contains("http"), "no network");
    assertTrue(page.contains("prefers-color-scheme:dark"));
    assertTrue(page.contains("haltere " + arguments[0] + " "), "the command");
    for (String plot : plots(page)) {
      assertNotNull(
          DocumentBuilderFactory.newInstance()
              .newDocumentBuilder()
              .parse(new InputSource(new StringReader(plot))));
    }
    return page;
  }

  private static List<String> plots(String page) {
    return PLOT.matcher(page).results().map(found -> found.group()).toList();
  }

  private static void assertPlots(String page, String... titles) {
    for (String title : titles) {
      assertTrue(plots(page).stream().anyMatch(plot -> plot.contains(">" + title + "<")), title);
    }
  }

  private static BufferedImage picture(String page) throws IOException {
    Matcher found = PICTURE.matcher(page);
    assertTrue(found.find());
    return ImageIO.read(new ByteArrayInputStream(Base64.getDecoder().decode(found.group(1))));
  }

  private static String sha256(Path file) throws Exception {
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file));
    return HexFormat.of().formatHex(digest);
  }

  @Test
  void wingReportContainsSettingsPlotsAndPictures() throws Exception {
    Path fly = scene("a&b <fly>.aedat", "fly", "0.3");
    Path out = folder.resolve("wings.csv");
    String page = page("wings", fly, "--out", out, "--rate", "500");
    assertTrue(page.contains("a&amp;b &lt;fly&gt;.aedat") && !page.contains("<fly>"), "escaped");
    assertTrue(page.contains(sha256(fly)));
    assertTrue(page.contains("128x128") && page.contains("aedat2"));
    assertTrue(page.contains("output.rateHz = 500.0 (default 1000.0)"), "settings that differ");
    assertTrue(page.contains("frequency") && page.contains("in lock"), "the summary");
    assertTrue(page.contains("--rate 500") && page.contains("Version"));
    assertPlots(
        page,
        "Event rate of the recording",
        "wings: angle (wing-tracker)",
        "wings: frequency (wing-tracker)");
    assertEquals(4 * 420 + 3 * 4, picture(page).getWidth());
  }

  @Test
  void plotsContinueAfterARestartOfTheClock() throws Exception {
    Path fly = scene("fly.csv", "fly", "0.3");
    List<String> rows = Files.readAllLines(fly);
    List<String> twice = new ArrayList<>(rows);
    twice.addAll(rows.subList(1, rows.size()));
    Files.write(fly, twice);
    String page = page("wings", fly, "--sensor", "128x128", "--out", folder.resolve("wings.csv"));
    for (String title : List.of("Event rate of the recording", "wings: frequency (wing-tracker)")) {
      assertTrue(
          plots(page).stream().anyMatch(plot -> plot.contains(title) && plot.contains(">0.5<")),
          title);
    }
  }

  @Test
  void picturesShowTheResultsOfTheirMoment() throws Exception {
    Path fly = scene("fly.aedat", "fly", "0.3");
    String page = page("wings", fly, "--out", folder.resolve("wings.csv"));
    BufferedImage sheet = picture(page);
    int marked = 0;
    for (int x = 3 * 424; x < sheet.getWidth(); x++) {
      for (int y = 424; y < sheet.getHeight(); y++) {
        Color colour = new Color(sheet.getRGB(x, y));
        boolean isRight = // 0x2ed3a5, which smooth edges mix with what lies behind
            Math.abs(colour.getRed() - 0x2e) < 30
                && Math.abs(colour.getGreen() - 0xd3) < 30
                && Math.abs(colour.getBlue() - 0xa5) < 30;
        marked += isRight ? 1 : 0;
      }
    }
    assertTrue(marked > 50, marked + " pixels of the right wing's lines");
  }

  @Test
  void tracksAndChainsHaveReports() throws Exception {
    Path dots = scene("dots.aedat", "dots", "0.5");
    String track = page("track", dots, "--out", folder.resolve("tracks.csv"));
    assertPlots(track, "objects: x (object-tracker)", "objects: y (object-tracker)");
    assertTrue(track.contains("<h2>Objects of object-tracker</h2>"));
    assertTrue(track.contains("mean speed (px/s)"));
    assertEquals(
        plots(track).size(), track.split("time from the first event").length - 1, "one time axis");
    Path chain =
        Files.writeString(
            folder.resolve("chain.json"),
            """
            {"filters": [{"filter": "refractory"},
              {"filter": "background-activity", "settings": {"correlationUs": 7000}}]}
            """);
    String run = page("run", dots, "--chain", chain, "--overwrite");
    assertTrue(run.contains("correlationUs = 7000"));
    assertTrue(run.contains("refractory"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"--road", "--preset=original --road"})
  void tracksOnARoadArePlottedInMetresToo(String options) throws Exception {
    Path cars = scene("cars.aedat", "road", "4");
    Path road = folder.resolve("road.json");
    Files.writeString(road, "{\"bridgeHeightM\": 5, \"nearestM\": 6}");
    List<Object> command =
        new ArrayList<>(List.of("track", cars, "--out", folder.resolve("t.csv")));
    command.addAll(List.of(options.split(" ")));
    command.add(road);
    String page = page(command.toArray());
    assertPlots(page, "road: x", "road: y", "road: speed");
    assertTrue(page.contains(">speed (km/h)<"), "the unit");
  }

  @Test
  void eachObjectHasARowInATableOfBoundedLength() throws Exception {
    Path dots = scene("dots.aedat", "dots", "1");
    Path out = folder.resolve("tracks.csv");
    String page = page("track", dots, "--out", out);
    List<String[]> rows = Files.lines(out).skip(1).map(line -> line.split(",")).toList();
    List<String[]> first = rows.stream().filter(row -> row[1].equals(rows.get(0)[1])).toList();
    double fromS = (Long.parseLong(first.get(0)[0]) - firstUs(dots)) * 1e-6;
    double toS = (Long.parseLong(first.get(first.size() - 1)[0]) - firstUs(dots)) * 1e-6;
    double speed =
        first.stream()
            .mapToDouble(row -> Math.hypot(Double.parseDouble(row[4]), Double.parseDouble(row[5])))
            .average()
            .orElseThrow();
    String wanted =
        "<tr><td>%s</td><td>%.3f</td><td>%.3f</td><td>%.3f</td><td>%s</td><td>%.1f</td>"
            .formatted(
                first.get(0)[1],
                fromS,
                toS,
                toS - fromS,
                "%,d".formatted(Long.parseLong(first.get(first.size() - 1)[10])),
                speed);
    assertTrue(page.contains(wanted), wanted);
    Path box = Recorded.file("dvs128-moving-dark-box.aedat");
    Path clusters = folder.resolve("clusters.csv");
    String many = page("track", box, "--out", clusters, "--preset", "original", "--overwrite");
    long tracks = Files.lines(clusters).skip(1).map(line -> line.split(",")[1]).distinct().count();
    assertTrue(tracks > 100, tracks + " tracks");
    assertTrue(many.contains("The 100 with the most events of " + tracks + "."));
    String table =
        many.substring(
            many.indexOf("<h2>Tracks of kalman-tracks</h2>"), many.indexOf("<h2>Pictures"));
    assertEquals(101, table.split("<tr>").length - 1);
  }

  private static long firstUs(Path recording) throws IOException {
    try (RecordingReader reader = Recordings.open(recording)) {
      return reader.segments().get(0).firstUs();
    }
  }

  @Test
  void batchReportIsOnePage() throws Exception {
    Path in = Files.createDirectory(folder.resolve("in"));
    scene("in/one.aedat", "dots", "0.2");
    Path two = scene("in/two.es", "dots", "0.3");
    Files.write(in.resolve("broken.aedat4"), new byte[] {'#', '!', 'A', 'E', 'R', '-', 'D', 'A'});
    Path out = folder.resolve("out");
    CommandRun broken =
        CommandRun.of("batch", in, "--track", "--out", out, "--report", out.resolve("all.html"));
    assertEquals(Files.exists(out.resolve("failed.json")) ? 1 : 0, broken.status(), broken.err());
    String page = page("batch", in.resolve("one.aedat"), two, "--track", "--out", out, "--resume");
    assertTrue(page.contains("one.aedat") && page.contains("two.es"));
    assertTrue(page.contains("2 kept"));
    assertTrue(page.replace("\n", "").contains(sha256(two)));
    assertPlots(page, "objects: x (object-tracker)");
    assertTrue(picture(page).getWidth() > 400);
  }

  @Test
  void reportOfABatchInParquetSaysWhyItHasNoMeans() throws Exception {
    Path dots = scene("dots.aedat", "dots", "0.5");
    Path out = folder.resolve("out");
    String page = page("batch", dots, "--track", "--out", out, "--format", "parquet");
    assertTrue(page.contains("a batch with --format csv shows the means"));
    assertEquals(List.of(), plots(page), "no empty plots");
  }

  @Test
  void twoTrackersOfOneChainAreToldApart() throws Exception {
    Path dots = scene("dots.aedat", "dots", "0.5");
    String two =
        "{\"filters\": [{\"filter\": \"object-tracker\"}, {\"filter\": \"object-tracker\"}]";
    String nested = "{\"filters\": [" + two + ", \"name\": \"inner\"}]";
    for (String filters : List.of(two, nested)) {
      Path chain = Files.writeString(folder.resolve("chain.json"), filters + "}");
      String page = page("run", dots, "--chain", chain, "--overwrite");
      assertTrue(page.contains("<h2>Objects of object-tracker</h2>"));
      assertTrue(page.contains("<h2>Objects of object-tracker-2</h2>"));
      assertPlots(page, "objects: x (object-tracker)", "objects: x (object-tracker-2)");
    }
  }

  @Test
  void recordingWithoutEventsHasNoPictureInItsReport() throws Exception {
    Path table = Files.writeString(folder.resolve("empty.csv"), "t,x,y,p\n");
    String page = page("track", table, "--sensor", "8x8", "--out", folder.resolve("t.csv"));
    assertTrue(page.contains("No events.") && !page.contains("<img"));
  }

  @Test
  void recordingsWithoutEventsHaveNoPicturesInTheReportOfABatch() throws Exception {
    Path table = Files.writeString(folder.resolve("empty.csv"), "t,x,y,p\n");
    Path out = folder.resolve("out");
    String page = page("batch", table, "--sensor", "8x8", "--track", "--out", out);
    assertTrue(page.contains("No events.") && !page.contains("<img"));
    String means = plots(page).get(0);
    assertTrue(means.contains("\"middle\">1<"), "recordings have whole numbers");
    assertFalse(means.contains("\"middle\">0.5<"), "and no others");
  }

  @Test
  void existingReportsAndReportsOfCamerasAreRejected() throws Exception {
    Path dots = scene("dots.aedat", "dots", "0.1");
    Path there = Files.writeString(folder.resolve("there.html"), "mine");
    Path out = folder.resolve("tracks.csv");
    CommandRun run = CommandRun.of("track", dots, "--out", out, "--report", there);
    assertEquals(1, run.status());
    assertTrue(run.err().contains("--overwrite"), run.err());
    assertFalse(Files.exists(out), "refused before any work");
    assertEquals(2, CommandRun.of("track", dots, "--out", out, "--report", out).status());
    Object[] camera = {"track", "--device", "simulated:dots", "--out", out, "--report", there};
    assertEquals(2, CommandRun.of(camera).status());
  }
}
