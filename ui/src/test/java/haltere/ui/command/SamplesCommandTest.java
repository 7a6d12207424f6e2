package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.json.internal.Json;
import haltere.testing.Recorded;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What the commands do with frames, inertial samples and triggers. */
class SamplesCommandTest {
  @TempDir Path folder;
  private Path davis;

  @BeforeEach
  void findRecording() {
    davis = Recorded.file("davis346-events-frames-imu.aedat4");
  }

  private Path out(String name) {
    return folder.resolve(name);
  }

  private static String succeed(Object... arguments) {
    CommandRun run = CommandRun.of(arguments);
    assertEquals(0, run.status(), run.err());
    return run.err();
  }

  @Test
  void infoCountsSamples() throws IOException {
    CommandRun run = CommandRun.of("info", "--json", davis);
    Map<?, ?> info = (Map<?, ?>) Json.parse(run.out(), "the output");
    assertEquals(59L, info.get("frames"));
    assertEquals(2363L, info.get("inertialSamples"));
    assertEquals(236L, info.get("triggers"));
    assertEquals(List.of(), info.get("warnings"));
    String text = CommandRun.of("info", davis).out();
    assertTrue(text.contains("59 frames, 2363 inertial samples, 236 triggers"), text);
  }

  @Test
  void convertCopiesSamplesIfTheTargetFormatHoldsThem() {
    Path copy = out("copy.aedat4");
    String said = succeed("convert", davis, copy);
    assertTrue(said.contains("59 frames, 2363 inertial samples, 236 triggers"), said);
    assertTrue(CommandRun.of("info", copy).out().contains("59 frames"));
  }

  @Test
  void convertReportsSkippedSamples() {
    assertEquals(
        davis
            + ": left out, as the format that is written cannot hold this: 59 frames, 2363 inertial"
            + " samples, 236 triggers",
        succeed("convert", davis, out("events.csv"), "--quiet").strip().replaceFirst("^.*?/", "/"));
    String part = succeed("convert", davis, out("part.dat"), "--to", "1589163147408000");
    assertTrue(part.contains("cannot hold this: 2 frames, 39 inertial samples, 4 triggers"), part);
  }

  @Test
  void runCopiesSamplesIfPossibleAndReportsSkippedOnes() throws IOException {
    Path chain = out("chain.json");
    Files.writeString(chain, "{\"filters\": [{\"filter\": \"refractory\"}]}");
    String carried = succeed("run", davis, "--chain", chain, "--out", out("left.aedat4"));
    assertTrue(carried.contains(" events, 59 frames, 2363 inertial samples, 236 trig"), carried);
    assertFalse(carried.contains("warning"), carried);
    String info = CommandRun.of("info", out("left.aedat4")).out();
    assertTrue(info.contains("59 frames, 2363 inertial samples, 236 triggers"), info);
    String left = succeed("run", davis, "--chain", chain, "--out", out("left.csv"), "--quiet");
    String loss = "cannot hold this: 59 frames, 2363 inertial samples, 236 triggers\n";
    assertTrue(left.startsWith("haltere: warning: " + davis + ": left out, as the format"), left);
    assertTrue(left.endsWith(loss), left);
    assertEquals(1, left.lines().count(), left);
  }

  @Test
  void trackGivesNoWarningAboutSamples() {
    String tracked = succeed("track", davis, "--out", out("tracks.csv"), "--quiet");
    assertEquals("", tracked);
  }

  @Test
  void runReportsSkippedWordsOfOtherData() throws IOException {
    Path recording = Recorded.file("imx636-evt3.raw");
    Path chain = out("chain.json");
    Files.writeString(chain, "{\"filters\": []}");
    String left = succeed("run", recording, "--chain", chain, "--out", out("left.csv"), "--quiet");
    assertTrue(left.contains("cannot hold this: 457639 words of other data"), left);
    assertEquals(1, left.lines().count(), left);
  }

  @Test
  void inertialSamplesAndTriggersAreWrittenAsTables() throws IOException {
    succeed("convert", davis, out("imu.csv"), "--stream", "imu");
    List<String> imu = Files.readAllLines(out("imu.csv"));
    assertEquals(
        "t_us,acceleration_x_g,acceleration_y_g,acceleration_z_g,rotation_x_deg_s,rotation_y_deg_s,"
            + "rotation_z_deg_s,temperature_c,magnetic_x_microtesla,magnetic_y_microtesla,"
            + "magnetic_z_microtesla",
        imu.get(0));
    assertTrue(imu.get(1).startsWith("1589163147369190,0.02758789,-0.9951172,0.2590332,"));
    assertEquals(1 + 2363, imu.size());

    succeed("convert", davis, out("t.CSV"), "--stream", "triggers", "--to", "1589163147400000");
    assertEquals(
        List.of(
            "t_us,source,edge,channel",
            "1589163147374647,frame-readout,falling,0",
            "1589163147395806,frame-readout,rising,0"),
        Files.readAllLines(out("t.CSV")));
  }

  @Test
  void framesAreWrittenAsPicturesInAFolder() throws IOException {
    succeed("convert", davis, out("frames"), "--stream", "frames", "--to", "1589163147480000");
    assertEquals(
        Files.getPosixFilePermissions(Files.createDirectory(out("plain"))),
        Files.getPosixFilePermissions(out("frames")),
        "who may read other results may read the pictures");
    List<String> table = Files.readAllLines(out("frames").resolve("frames.csv"));
    assertEquals(
        "t_us,exposure_end_us,readout_start_us,readout_end_us,left_px,bottom_px,file",
        table.get(0));
    assertEquals(
        "1589163147364965,1589163147365465,1589163147355806,1589163147374647,0,0,frame-000000.png",
        table.get(1));
    assertEquals(1 + 3, table.size());
    BufferedImage picture = ImageIO.read(out("frames").resolve("frame-000000.png").toFile());
    assertEquals(346, picture.getWidth());
    assertEquals(260, picture.getHeight());
    assertEquals(78, picture.getRaster().getSample(0, 0, 0));
    assertEquals(13, picture.getRaster().getSample(345, 259, 0));
    CommandRun again = CommandRun.of("convert", davis, out("frames"), "--stream", "frames");
    assertEquals(1, again.status());
    assertTrue(again.err().contains("folder already; choose another name"), again.err());
  }

  @Test
  void greyFramesOf16BitsAreWrittenWithoutLoss() throws IOException {
    Path gray = Recorded.file("gray16-frame.aedat4");
    succeed("convert", gray, out("gray"), "--stream", "frames");
    BufferedImage picture = ImageIO.read(out("gray").resolve("frame-000000.png").toFile());
    assertEquals(16, picture.getColorModel().getPixelSize());
    assertEquals(1, picture.getRaster().getSample(0, 0, 0));
    assertEquals(1023, picture.getRaster().getSample(1, 1, 0));
  }

  @Test
  void failureLeavesNoFile() throws IOException {
    Path cut = out("cut.aedat4");
    byte[] bytes = Files.readAllBytes(davis);
    Files.write(cut, java.util.Arrays.copyOf(bytes, bytes.length / 3));
    CommandRun run = CommandRun.of("convert", cut, out("strict"), "--stream", "frames", "--strict");
    assertEquals(1, run.status(), run.err());
    try (Stream<Path> left = Files.list(folder)) {
      assertEquals(List.of(cut), left.toList());
    }
  }

  @Test
  void invalidStreamOptionsAreWrongArguments() {
    assertEquals(2, CommandRun.of("convert", davis, out("a.txt"), "--stream", "imu").status());
    assertEquals(2, CommandRun.of("convert", davis, out("a.csv"), "--stream", "smell").status());
    Object[] filtered = {
      "convert", davis, out("a.csv"), "--stream", "imu", "--filter", "refractory"
    };
    assertEquals(2, CommandRun.of(filtered).status());
  }

  @Test
  void indexIsWrittenOnlyOnRequest() throws IOException {
    Path file = Files.copy(davis, out("davis.aedat4"));
    Path index = out("davis.aedat4.haltere-index");
    succeed("info", file);
    assertFalse(Files.exists(index));
    succeed("info", file, "--index");
    assertTrue(Files.exists(index));
    succeed("convert", file, out("part.csv"), "--from", "1589163148000000");
  }
}
