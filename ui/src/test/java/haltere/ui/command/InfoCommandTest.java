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
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class InfoCommandTest {
  @TempDir Path folder;

  private Path recording;
  private Locale locale;

  @BeforeEach
  void writeRecording() throws IOException {
    locale = Locale.getDefault();
    recording = TinyRecording.hundred().write(folder.resolve("hundred.aedat"));
  }

  @AfterEach
  void restoreLocale() {
    Locale.setDefault(locale);
  }

  private static Map<?, ?> object(CommandRun run) throws IOException {
    assertEquals(0, run.status(), run.err());
    return (Map<?, ?>) Json.parse(run.out(), "the output");
  }

  @Test
  void jsonHasExactlyTheDocumentedKeys() throws IOException {
    assertEquals(
        List.of(
            "format",
            "width",
            "height",
            "origin",
            "events",
            "on",
            "off",
            "firstUs",
            "lastUs",
            "durationS",
            "meanRateEps",
            "peakRateEps",
            "timestampsMonotonic",
            "gaps",
            "warnings"),
        List.copyOf(object(CommandRun.of("info", "--json", recording)).keySet()));
  }

  @Test
  void jsonDescribesTheRecording() throws IOException {
    Map<?, ?> info = object(CommandRun.of("info", recording, "--json"));
    assertEquals("aedat2", info.get("format"));
    assertEquals(128L, info.get("width"));
    assertEquals(128L, info.get("height"));
    assertEquals("bottom", info.get("origin"));
    assertEquals(100L, info.get("events"));
    assertEquals(66L, info.get("on"));
    assertEquals(34L, info.get("off"));
    assertEquals(5_000_000L, info.get("firstUs"));
    assertEquals(5_099_000L, info.get("lastUs"));
    assertEquals(0.099, info.get("durationS"));
    assertEquals(100 / 0.099, (double) info.get("meanRateEps"), 1e-9);
    assertEquals(1000.0, info.get("peakRateEps"));
    assertEquals(true, info.get("timestampsMonotonic"));
    assertEquals(List.of(), info.get("gaps"));
    assertEquals(List.of(), info.get("warnings"));
  }

  @Test
  void optionsForPropertiesThatTheRecordingStatesAreNamed() throws IOException {
    CommandRun run =
        CommandRun.of("info", recording, "--sensor", "64x64", "--rows", "top", "--topic", "/dvs");
    assertEquals(0, run.status(), run.err());
    assertEquals(
        List.of(
            "haltere: warning: " + recording + ": it states 128x128 pixels; --sensor has no effect",
            "haltere: warning: "
                + recording
                + ": it states where rows count from; --rows has no effect",
            "haltere: warning: " + recording + ": it has no topics; --topic has no effect"),
        run.errorLines());
    Path table = Files.writeString(folder.resolve("t.csv"), "t_us,x,y,on\n1,2,3,1\n2,3,4,0\n");
    for (String rows : List.of("top", "bottom")) {
      CommandRun used = CommandRun.of("info", table, "--sensor", "9x8", "--rows", rows);
      assertEquals("", used.err());
      assertTrue(used.out().contains("9x8 pixels, rows count from the " + rows), used.out());
    }
  }

  @Test
  void rateOverTimeIsPrintedOnlyOnATerminal() throws IOException {
    TinyRecording bursts = new TinyRecording();
    for (int ms = 0; ms < 300; ms++) {
      for (int i = 0; i < (ms < 100 ? 1 : ms < 200 ? 8 : 4); i++) {
        bursts.event(1000 * ms, i, 1, true);
      }
    }
    Path file = bursts.write(folder.resolve("bursts.aedat"));
    String[] lines =
        CommandRun.on(CommandRun.Machine.BARE.withTerminal(), "info", file).out().split("\n");
    String last = lines[lines.length - 1];
    assertTrue(last.matches("  rate +\u2581{12}.\u2588{12}\u2584{13}  up to 8.00 kev/s"), last);
    assertFalse(CommandRun.of("info", file).out().contains("\u2588"));
  }

  @Test
  void pictureShowsTheRecordingAtEightMoments() throws IOException {
    TinyRecording sweep = new TinyRecording();
    for (int i = 0; i < 1000; i++) {
      sweep.event(1000 * i, i / 8, 64, true);
    }
    Path file = sweep.write(folder.resolve("sweep.aedat"));
    Path picture = folder.resolve("sweep.png");
    CommandRun run = CommandRun.of("info", file, "--picture", picture);
    assertEquals(0, run.status(), run.err());
    BufferedImage sheet = ImageIO.read(picture.toFile());
    assertEquals(4 * 420 + 3 * 4, sheet.getWidth());
    assertEquals(2 * 420 + 4, sheet.getHeight());
    int[] brightest = new int[8];
    for (int panel = 0; panel < 8; panel++) {
      for (int x = 0; x < 420; x++) {
        int top = panel / 4 * 424 + 210;
        int left = panel % 4 * 424;
        if (brightness(sheet, left + x, top) > brightness(sheet, left + brightest[panel], top)) {
          brightest[panel] = x;
        }
      }
    }
    for (int panel = 1; panel < 8; panel++) {
      assertTrue(brightest[panel] > brightest[panel - 1] + 20, Arrays.toString(brightest));
    }
    assertTrue(CommandRun.of("info", file, "--picture", picture).err().contains("--overwrite"));
    assertEquals(2, CommandRun.of("info", file, file, "--picture", picture).status());
  }

  private static int brightness(BufferedImage image, int x, int y) {
    return image.getRGB(x, y) >> 16 & 0xff;
  }

  @Test
  void gapsAndClockRestartsAreReported() throws IOException {
    Path file =
        new TinyRecording()
            .event(1_000_000, 1, 1, true)
            .event(9_000_000, 1, 1, true)
            .event(500_000, 1, 1, true)
            .write(folder.resolve("odd.aedat"));
    Map<?, ?> info = object(CommandRun.of("info", file, "--json"));
    assertEquals(false, info.get("timestampsMonotonic"));
    Map<?, ?> gap = (Map<?, ?>) ((List<?>) info.get("gaps")).get(0);
    assertEquals(1_000_000L, gap.get("fromUs"));
    assertEquals(9_000_000L, gap.get("toUs"));
  }

  @Test
  void severalFilesGiveAnArrayInTheGivenOrder() throws IOException {
    Path other = new TinyRecording().event(1, 2, 3, true).write(folder.resolve("one.aedat"));
    CommandRun run = CommandRun.of("info", "--json", recording, other);
    List<?> array = (List<?>) Json.parse(run.out(), "the output");
    assertEquals(2, array.size());
    assertEquals(100L, ((Map<?, ?>) array.get(0)).get("events"));
    assertEquals(1L, ((Map<?, ?>) array.get(1)).get("events"));
  }

  @Test
  void unreadableFileHasAnEntryInTheArray() throws IOException {
    Path missing = folder.resolve("missing.aedat");
    CommandRun run = CommandRun.of("info", "--json", missing, recording);
    assertEquals(1, run.status());
    List<?> array = (List<?>) Json.parse(run.out(), "the output");
    assertEquals(2, array.size());
    Map<?, ?> first = (Map<?, ?>) array.get(0);
    assertEquals(Set.of("file", "error"), first.keySet());
    assertEquals(missing.toString(), first.get("file"));
    assertEquals("haltere: " + first.get("error") + "\n", run.err());
    Map<?, ?> second = (Map<?, ?>) array.get(1);
    assertEquals(100L, second.get("events"));
    assertFalse(second.containsKey("error"));
  }

  @Test
  void strictErrorsAreInTheObject() throws IOException {
    byte[] bytes = Files.readAllBytes(recording);
    Path cut = Files.write(folder.resolve("cut.aedat"), Arrays.copyOf(bytes, bytes.length - 3));
    CommandRun lenient = CommandRun.of("info", "--json", cut);
    assertEquals(0, lenient.status());
    assertFalse(lenient.out().contains("error"), lenient.out());
    CommandRun strict = CommandRun.of("info", "--json", "--strict", cut);
    assertEquals(1, strict.status());
    Map<?, ?> object = (Map<?, ?>) Json.parse(strict.out(), "the output");
    assertEquals(99L, object.get("events"));
    assertTrue(strict.err().endsWith("haltere: " + object.get("error") + "\n"), strict.err());
  }

  @Test
  void fileWithoutEventsHasNoRates() throws IOException {
    Path none = new TinyRecording().write(folder.resolve("none.aedat"));
    Map<?, ?> info = object(CommandRun.of("info", "--json", none));
    assertEquals(0L, info.get("events"));
    assertEquals(0.0, info.get("meanRateEps"));
    assertEquals(0.0, info.get("peakRateEps"));
    assertEquals(0, CommandRun.of("info", none).status());
  }

  @Test
  void textIsAlignedAndIndependentOfTheLocale() {
    String expected =
        """
        %s
          format      aedat2
          sensor      128x128 pixels, rows count from the bottom
          events      100  (66 ON, 34 OFF)
          time        5.000000 s to 5.099000 s
          duration    0.099000 s
          mean rate   1.01 kev/s
          peak rate   1.00 kev/s  (over 10 ms)
          clock       never goes back
          zero        the camera's start or its clock's last reset; wraps of 4294.967296 s are undone
          gaps        none
        """
            .formatted(recording);
    for (String tag : List.of("en-US", "de-DE", "ar-EG", "fa-IR", "tr-TR")) {
      Locale.setDefault(Locale.forLanguageTag(tag));
      assertEquals(expected, CommandRun.of("info", recording).out());
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"aedat4", "h5", "npz"})
  void quickInfoContainsOnlyStatedValues(String ending) throws IOException {
    Path file = folder.resolve("hundred." + ending);
    assertEquals(0, CommandRun.of("convert", recording, file).status());

    Map<?, ?> told = object(CommandRun.of("info", "--json", "--quick", file));

    Map<?, ?> read = object(CommandRun.of("info", "--json", file));
    assertEquals(
        List.of(
            "format",
            "width",
            "height",
            "origin",
            "events",
            "firstUs",
            "lastUs",
            "durationS",
            "meanRateEps",
            "warnings"),
        List.copyOf(told.keySet()));
    told.forEach((key, value) -> assertEquals(read.get(key), value, key.toString()));
    assertTrue(CommandRun.of("info", "--quick", file).out().contains("events      100\n"));
  }

  @Test
  void quickInfoReadsFilesWithoutStatedValues() throws IOException {
    assertEquals(
        object(CommandRun.of("info", "--json", recording)),
        object(CommandRun.of("info", "--json", "--quick", recording)));
  }

  @Test
  void fileExtensionDoesNotMatter() throws IOException {
    Path renamed = TinyRecording.hundred().write(folder.resolve("photo.jpg"));
    assertEquals("aedat2", object(CommandRun.of("info", "--json", renamed)).get("format"));
  }

  @Test
  void progressBarAppearsOnlyOnTerminalsAndNotWhenQuiet() throws IOException {
    TinyRecording large = new TinyRecording();
    for (int i = 0; i < 1_000_000; i++) {
      large.event(i, i & 127, 64, true);
    }
    Path file = large.write(folder.resolve("large.aedat"));
    CommandRun.Machine terminal = CommandRun.Machine.BARE.withTerminal();
    assertEquals("", CommandRun.of("info", file).err());
    assertEquals("", CommandRun.on(terminal, "info", "--quiet", file).err());
    assertFalse(CommandRun.on(terminal, "info", file).err().contains("\n"));
  }

  @ParameterizedTest(name = "{0}")
  @CsvSource({
    "dvs128-tmpdiff128-2007.dat, aedat1, 128, 128, 121270, 49059, 72211, 679877510, 701768090",
    "dvs128-moving-dark-box.aedat, aedat2, 128, 128, 489834, 246923, 242911, 946459683, 986269729",
    "dvs128-walking-10s.aedat, aedat2, 128, 128, 125028, 55976, 69052, 262847757, 270891631",
    "dvs128-pendulum.aedat, aedat2, 128, 128, 278538, 153062, 125476, 64300579, 84240611",
    "davis240c-rotating-disk-imu-aps.aedat, aedat2, 240, 180, 374296, 163098, 211198, 341678,"
        + " 3508437",
    "synthetic-rotating-bar.aedat, aedat2, 240, 180, 45000, 45000, 0, 100000, 90000000"
  })
  void realRecordingsMatchTheDescriptionsOfTheirSources(
      String name,
      String format,
      long width,
      long height,
      long events,
      long on,
      long off,
      long firstUs,
      long lastUs)
      throws IOException {
    Map<?, ?> info = object(CommandRun.of("info", "--json", Recorded.file(name)));
    assertEquals(format, info.get("format"));
    assertEquals(width, info.get("width"));
    assertEquals(height, info.get("height"));
    assertEquals("bottom", info.get("origin"));
    assertEquals(events, info.get("events"));
    assertEquals(on, info.get("on"));
    assertEquals(off, info.get("off"));
    assertEquals(firstUs, info.get("firstUs"));
    assertEquals(lastUs, info.get("lastUs"));
    assertEquals((lastUs - firstUs) / 1e6, (double) info.get("durationS"), 1e-9);
    assertEquals(true, info.get("timestampsMonotonic"));
    assertTrue((double) info.get("peakRateEps") >= (double) info.get("meanRateEps"));
  }
}
