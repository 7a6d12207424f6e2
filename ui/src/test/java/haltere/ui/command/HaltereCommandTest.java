package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class HaltereCommandTest {
  @TempDir static Path demonstrated;
  private static CommandRun demonstration;

  @TempDir Path folder;

  private final Path table = demonstrated.resolve("build/demo/wings.csv");
  private final Path picture = demonstrated.resolve("build/demo/fly.png");

  @BeforeAll
  static void demonstrate() {
    demonstration = CommandRun.on(CommandRun.Machine.BARE.in(demonstrated));
  }

  @Test
  void demonstrationWithoutDisplayWritesAPictureAndATable() throws IOException {
    assertEquals(0, demonstration.status(), demonstration.err());
    assertEquals("", demonstration.err());
    assertTrue(demonstration.out().contains(picture.toString()), demonstration.out());
    assertTrue(demonstration.out().contains(table.toString()), demonstration.out());
    assertTrue(demonstration.out().contains("both wings tracked"), demonstration.out());
    assertTrue(Files.readAllLines(table).size() > 10);
    BufferedImage image = ImageIO.read(picture.toFile());
    assertTrue(colours(image) > 10, "a picture with " + colours(image) + " colours");
  }

  @Test
  void demonstrationReproducesItsFilesAndShowsProgressOnATerminal() throws IOException {
    String rows = Files.readString(table);
    byte[] pixels = Files.readAllBytes(picture);
    Files.writeString(table, "another");
    CommandRun again =
        CommandRun.on(CommandRun.Machine.BARE.in(demonstrated).withTerminal(), "--headless");
    assertEquals(0, again.status(), again.err());
    assertEquals(rows, Files.readString(table));
    assertArrayEquals(pixels, Files.readAllBytes(picture));
    try (Stream<Path> files = Files.list(demonstrated.resolve("build/demo"))) {
      assertEquals(2, files.count());
    }
    assertTrue(again.err().contains("fly scene ["), again.err());
    assertTrue(again.err().contains("Mev/s"), again.err());
  }

  @Test
  void viewerOpensTheBuiltInSceneOnADisplay() {
    CommandRun run = CommandRun.on(CommandRun.Machine.BARE.in(folder).withDisplay());
    assertEquals(0, run.status());
    assertEquals(List.of(Optional.empty()), run.windows());
  }

  @Test
  void viewOpensTheGivenRecording() throws IOException {
    Path recording = TinyRecording.hundred().write(folder.resolve("hundred.aedat"));
    CommandRun.Machine desk = CommandRun.Machine.BARE.withDisplay();
    assertEquals(List.of(Optional.of(recording)), CommandRun.on(desk, "view", recording).windows());
    assertEquals(List.of(Optional.empty()), CommandRun.on(desk, "view").windows());
  }

  @Test
  void viewReportsAnUnreadableRecordingBeforeOpeningAWindow() throws IOException {
    Path empty = Files.createFile(folder.resolve("empty.aedat"));
    CommandRun.Machine desk = CommandRun.Machine.BARE.withDisplay().withTerminal();
    CommandRun run = CommandRun.on(desk, "view", empty);
    assertEquals(1, run.status());
    assertEquals(1, run.errorLines().size(), run.err());
    assertEquals(List.of(), run.windows());
  }

  @Test
  void unreadableRecordingOpensInTheViewerWithoutATerminal() throws IOException {
    Path empty = Files.createFile(folder.resolve("empty.aedat"));
    CommandRun run = CommandRun.on(CommandRun.Machine.BARE.withDisplay(), "view", empty);
    assertEquals(0, run.status(), run.err());
    assertEquals(List.of(Optional.of(empty)), run.windows());
  }

  @Test
  void viewWithoutDisplayIsReportedInOneLine() {
    CommandRun run = CommandRun.of("view");
    assertEquals(1, run.status());
    assertEquals(1, run.errorLines().size(), run.err());
    assertTrue(run.err().contains("display"), run.err());
  }

  @Test
  void missingGraphicsLibrariesAreReportedInOneLine() {
    CommandRun.Machine lacking =
        CommandRun.Machine.BARE.withDisplay().withObstacle("install libgtk-3-0");
    for (Object[] label : new Object[][] {{}, {"view"}}) {
      CommandRun run = CommandRun.on(lacking, label);
      assertEquals(1, run.status());
      assertEquals("haltere: install libgtk-3-0\n", run.err());
      assertEquals(List.of(), run.windows());
    }
  }

  @Test
  void helpListsEveryCommand() {
    CommandRun run = CommandRun.of("--help");
    assertEquals(0, run.status());
    for (String command :
        List.of("view", "info", "convert", "run", "track", "simulate", "filters", "bench")) {
      assertTrue(run.out().contains("\n  " + command + " "), run.out());
      CommandRun help = CommandRun.of(command, "--help");
      assertEquals(0, help.status());
      assertTrue(help.out().startsWith("Usage: haltere " + command + " "), help.out());
    }
  }

  @Test
  void helpIsGroupedAndEndsWithAnExample() {
    String help = CommandRun.of("--help").out();
    assertTrue(help.indexOf("Work on recordings:") < help.indexOf("\n  wings "), help);
    assertTrue(help.indexOf("Make recordings:") < help.indexOf("\n  record "), help);
    assertTrue(help.lines().allMatch(line -> line.length() <= 80), help);
    String wings = CommandRun.of("wings", "--help").out();
    assertTrue(wings.stripTrailing().lines().reduce((a, b) -> b).get().startsWith("Example: "));
  }

  @Test
  void coloursAppearOnlyOnTerminals() {
    assertFalse(CommandRun.of("--help").out().contains("\u001b["));
    assertTrue(
        CommandRun.on(CommandRun.Machine.BARE.withTerminal(), "--help").out().contains("\u001b["));
  }

  @Test
  void fileOtherThanARecordingIsReportedInOneLine() throws IOException {
    Path text = Files.writeString(folder.resolve("passwd"), "root:x:0:0\n".repeat(40));
    CommandRun run = CommandRun.of("info", text);
    assertEquals(1, run.status());
    assertEquals(1, run.errorLines().size());
    assertTrue(run.err().length() < 200 + text.toString().length(), run.err());
  }

  @Test
  void versionIsOneLine() {
    CommandRun run = CommandRun.of("--version");
    assertEquals(0, run.status());
    assertTrue(run.out().startsWith("haltere "), run.out());
    assertEquals(1, run.out().lines().count());
  }

  private static long colours(BufferedImage image) {
    return java.util.Arrays.stream(
            image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
        .distinct()
        .count();
  }

  @Test
  void misspelledCommandOrOptionIsCorrectedInTheMessage() {
    CommandRun command = CommandRun.of("trak");
    assertEquals(2, command.status());
    assertTrue(command.err().contains("\nDid you mean: haltere track?\n"), command.err());
    assertTrue(command.err().startsWith("haltere: there is no command "), command.err());
    CommandRun option = CommandRun.of("info", "--jsn", "x.aedat");
    assertEquals(2, option.status());
    assertTrue(option.err().contains("Did you mean: --json?"), option.err());
    CommandRun required = CommandRun.of("run", "x.aedat", "--chian=chain.json");
    assertEquals(2, required.status());
    assertTrue(required.err().contains("Did you mean: --chain?"), required.err());
  }
}
