package haltere.ui.command;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import haltere.testing.ReplacedFile;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Every bad input has its line and its status, and leaves nothing behind. */
class BadInputTest {
  @TempDir Path folder;

  private Path good;
  private Path out;

  @BeforeEach
  void writeRecording() throws IOException {
    good = TinyRecording.hundred().write(folder.resolve("good.aedat"));
    out = folder.resolve("out.csv");
  }

  /** One line on the standard error that has all of these words in it, nothing else, status 1. */
  private void assertFails(CommandRun run, Object... arguments) {
    assertEquals(1, run.status(), run.err());
    assertEquals(1, run.errorLines().size(), run.err());
    String line = run.errorLines().get(0);
    assertTrue(line.startsWith("haltere: "), line);
    for (Object word : arguments) {
      assertTrue(line.contains(word.toString()), () -> "no \"" + word + "\" in: " + line);
    }
    assertEquals("", run.out());
  }

  /** Status 2, a line that has all of these words in it, then the usage. */
  private void assertWrongArguments(CommandRun run, Object... arguments) {
    assertEquals(2, run.status(), run.err());
    String line = run.errorLines().get(0);
    for (Object word : arguments) {
      assertTrue(line.contains(word.toString()), () -> "no \"" + word + "\" in: " + line);
    }
    assertTrue(run.err().contains("Usage: haltere"), run.err());
    assertTrue(run.err().endsWith(" --help\n"), run.err());
    assertFalse(run.err().contains("\tat "), run.err());
    assertEquals("", run.out());
  }

  private void assertNothingWritten(Path... expected) throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      List<Path> found = files.sorted().toList();
      List<Path> wanted = Stream.concat(Stream.of(good), Stream.of(expected)).sorted().toList();
      assertEquals(wanted, found);
    }
  }

  @Test
  void cameraIsNoRecording() {
    for (String command : List.of("info", "view")) {
      assertFails(CommandRun.of(command, "simulated:fly"), "simulated:fly", "camera", "--device");
    }
  }

  @Test
  void emptyFileIsReportedAsEmpty() throws IOException {
    Path empty = Files.createFile(folder.resolve("empty.aedat"));
    assertFails(CommandRun.of("info", empty), empty, "empty");
    assertFails(CommandRun.of("convert", empty, out), empty, "empty");
    assertNothingWritten(empty);
  }

  @Test
  void missingFileIsReportedByName() {
    Path missing = folder.resolve("missing.aedat");
    assertFails(CommandRun.of("info", missing), missing, "no such file");
  }

  @Test
  @DisabledOnOs(OS.WINDOWS)
  void nameThatWouldControlTheTerminalIsPrintedWithoutControls() throws IOException {
    Path named = Files.copy(good, folder.resolve("red\u001b[31m\u009b2J.aedat"));
    CommandRun read = CommandRun.of("info", named);
    assertEquals(0, read.status(), read.err());
    assertTrue(read.out().contains("red?[31m?2J.aedat"), read.out());
    CommandRun written = CommandRun.of("convert", named, folder.resolve("red\u001b[31m.csv"));
    assertTrue(written.err().contains("red?[31m.csv: "), written.err());
    assertFalse(written.err().contains("\u001b"), written.err());
    assertFails(CommandRun.of("info", folder.resolve("no\u001b[31m.aedat")), "no?[31m.aedat");
    assertWrongArguments(CommandRun.of("info", "--no\u001b[31m"), "--no?[31m");
  }

  @Test
  void folderOfSeveralRecordingsIsRejected() throws IOException {
    Files.copy(good, folder.resolve("copy-of-" + good.getFileName()));
    assertFails(CommandRun.of("info", folder), folder, "folder with 2 recordings");
  }

  @Test
  void missingReadPermissionIsReported() throws IOException {
    Files.setPosixFilePermissions(good, PosixFilePermissions.fromString("-w-------"));
    assumeFalse(Files.isReadable(good), "this user may read everything");
    assertFails(CommandRun.of("info", good), good, "permission");
  }

  @Test
  void fileOfAnotherKindWithARecordingExtensionIsRejected() throws IOException {
    Path picture = folder.resolve("picture.aedat");
    Files.write(picture, new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n', 1, 2, 3});
    assertFails(CommandRun.of("info", picture), picture, "--format");
  }

  @Test
  void truncatedFileIsReadUpToTheLastCompleteEvent() throws IOException {
    byte[] whole = TinyRecording.hundred().bytes();
    Path cut = folder.resolve("cut.aedat");
    for (int length = TinyRecording.headerBytes() + 8; length < whole.length; length += 13) {
      ReplacedFile.write(cut, Arrays.copyOf(whole, length));
      int events = (length - TinyRecording.headerBytes()) / 8;
      boolean between = (length - TinyRecording.headerBytes()) % 8 == 0;
      CommandRun run = CommandRun.of("info", "--json", cut);
      assertEquals(0, run.status(), run.err());
      assertTrue(run.out().contains("\"events\" : " + events + ","), run.out());
      assertEquals(between ? 0 : 1, run.errorLines().size(), run.err());
      CommandRun strict = CommandRun.of("convert", "--strict", "--overwrite", cut, out);
      assertEquals(between ? 0 : 1, strict.status(), strict.err());
      assertEquals(between, Files.deleteIfExists(out));
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 5, 11, 12, 13, 14, 20, 40})
  void fileTruncatedInItsHeaderIsHandled(int length) throws IOException {
    Path cut = folder.resolve("cut.aedat");
    Files.write(cut, Arrays.copyOf(TinyRecording.hundred().bytes(), length));
    CommandRun run = CommandRun.of("info", "--json", cut);
    assertTrue(run.status() == 0 || run.status() == 1, run.err());
    assertFalse(run.err().contains("unexpected"), run.err());
    assertFalse(run.err().contains("\tat "), run.err());
    if (run.status() == 1) {
      assertFails(run, cut);
    }
  }

  @Test
  void strictReadingReportsTheByteWhereTheFileEnds() throws IOException {
    Path cut = folder.resolve("cut.aedat");
    Files.write(cut, Arrays.copyOf(TinyRecording.hundred().bytes(), 100));
    CommandRun run = CommandRun.of("info", "--strict", cut);
    assertEquals(1, run.status());
    assertTrue(run.err().contains(cut + ", byte "), run.err());
    assertTrue(run.err().contains("--strict"), run.err());
  }

  @Test
  void eventsOutsideTheSensorAreSkippedWithAWarning() throws IOException {
    CommandRun run = CommandRun.of("info", "--json", "--sensor", "64x64", good);
    assertEquals(0, run.status(), run.err());
    assertTrue(run.err().contains("warning") || run.out().contains("\"width\" : 128"), run.err());
  }

  @Test
  void damagedFileDoesNotHideOtherFiles() throws IOException {
    Path empty = Files.createFile(folder.resolve("empty.aedat"));
    CommandRun run = CommandRun.of("info", "--json", good, empty, good);
    assertEquals(1, run.status());
    assertEquals(1, run.errorLines().size(), run.err());
    assertTrue(run.err().contains(empty.toString()), run.err());
    assertEquals(2, run.out().split("\"events\" : 100,", -1).length - 1, run.out());
  }

  @Test
  void existingOutputIsRejectedAndUnchanged() throws IOException {
    Files.writeString(out, "mine");
    assertFails(CommandRun.of("convert", good, out), out, "--overwrite");
    assertEquals("mine", Files.readString(out));
    assertEquals(0, CommandRun.of("convert", "--overwrite", good, out).status());
    assertTrue(Files.readString(out).startsWith("t_us,x,y,on\n"));
  }

  @Test
  void outputInAMissingFolderIsRejected() throws IOException {
    Path lost = folder.resolve("nowhere").resolve("out.csv");
    assertFails(CommandRun.of("convert", good, lost), lost, "folder");
    assertNothingWritten();
  }

  @Test
  void folderAsOutputIsRejected() throws IOException {
    Path taken = Files.createDirectory(folder.resolve("taken.csv"));
    assertFails(CommandRun.of("convert", "--overwrite", good, taken), taken, "folder");
  }

  @Test
  void inputAsOutputIsRejected() throws IOException {
    byte[] before = Files.readAllBytes(good);
    assertFails(CommandRun.of("convert", "--overwrite", good, good), good, "same file");
    Path link = Files.createSymbolicLink(folder.resolve("link.aedat"), good);
    assertFails(CommandRun.of("convert", "--overwrite", good, link), link, "same file");
    assertFails(
        CommandRun.of("run", "--overwrite", good, "--chain", emptyChain(), "--out", good),
        "same file");
    assertArrayEquals(before, Files.readAllBytes(good));
  }

  @Test
  void unknownOutputExtensionIsAWrongArgument() {
    assertWrongArguments(
        CommandRun.of("convert", good, folder.resolve("out.xyz")), ".xyz", ".aedat", ".csv");
    assertWrongArguments(CommandRun.of("convert", good, folder.resolve("out")));
  }

  @Test
  void fromAfterToIsAWrongArgument() throws IOException {
    assertWrongArguments(
        CommandRun.of("convert", good, out, "--from", 20, "--to", 10), "--from 20", "--to 10");
    assertWrongArguments(CommandRun.of("convert", good, out, "--from", "soon"), "--from", "soon");
    assertNothingWritten();
  }

  @Test
  void emptyNameOfAFileIsAWrongArgumentAndNotTheCurrentFolder() {
    String why = "the name of a file is empty";
    assertWrongArguments(CommandRun.of("info", ""), "FILE", why);
    assertWrongArguments(CommandRun.of("track", good, "--out", ""), "--out", why);
    assertWrongArguments(CommandRun.of("run", good, "--chain", ""), "--chain", why);
  }

  @ParameterizedTest
  @ValueSource(strings = {"346", "346x", "x260", "0x260", "346x-1", "346*260", "40000x1", ""})
  void invalidSensorSizeIsAWrongArgument(String size) {
    assertWrongArguments(CommandRun.of("info", "--sensor=" + size, good), "--sensor");
  }

  @Test
  void unknownFormatIsAWrongArgument() {
    assertWrongArguments(CommandRun.of("info", "--format", "tiff", good), "tiff", "aedat2");
  }

  @Test
  void unknownFilterIsAWrongArgument() {
    assertWrongArguments(
        CommandRun.of("convert", good, out, "--filter", "sharpen"), "sharpen", "refractory");
    assertWrongArguments(CommandRun.of("filters", "sharpen"), "sharpen", "refractory");
  }

  @Test
  void unknownCommandOrOptionIsAWrongArgument() {
    assertWrongArguments(CommandRun.of("polish", good), "polish");
    assertWrongArguments(CommandRun.of("info", "--shiny", good), "--shiny");
    assertWrongArguments(CommandRun.of("info"), "FILE");
    assertWrongArguments(CommandRun.of("convert", good), "OUT");
    assertWrongArguments(CommandRun.of("run", good), "--chain");
  }

  @Test
  void missingChainFileIsReportedByName() {
    assertFails(
        CommandRun.of("run", good, "--chain", folder.resolve("none.json")), "none.json", "no such");
  }

  @Test
  void malformedJsonIsReportedWithItsLine() throws IOException {
    Path chain = chain("{\"filters\": [\n  {\"filter\": \"refractory\",}\n]}");
    assertFails(CommandRun.of("run", good, "--chain", chain), chain, "line 2");
  }

  @Test
  void binaryChainFileIsRejected() throws IOException {
    Path chain = folder.resolve("chain.json");
    Files.write(chain, new byte[] {'{', (byte) 0xff, (byte) 0xfe, 0});
    assertFails(CommandRun.of("run", good, "--chain", chain), chain);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "[]", "{}", "7", "{\"filters\": 3}", "{\"filters\": [4]}"})
  void jsonOtherThanAChainIsRejected(String text) throws IOException {
    Path chain = chain(text);
    assertFails(CommandRun.of("run", good, "--chain", chain), chain);
  }

  @Test
  void unknownFilterInAChainIsReportedWithTheKnownFilters() throws IOException {
    Path chain = chain("{\"filters\": [{\"filter\": \"sharpen\"}]}");
    assertFails(CommandRun.of("run", good, "--chain", chain), chain, "sharpen", "refractory");
  }

  @Test
  void unknownSettingInAChainIsReportedWithTheKnownSettings() throws IOException {
    Path chain =
        chain("{\"filters\": [{\"filter\": \"refractory\", \"settings\": {\"sparkle\": 1}}]}");
    assertFails(CommandRun.of("run", good, "--chain", chain), chain, "sparkle", "refractory");
  }

  @Test
  void valueOutOfRangeInAChainIsReportedWithTheRange() throws IOException {
    Path chain =
        chain(
            "{\"filters\": [{\"filter\": \"refractory\", \"settings\":" + " {\"periodUs\": -1}}]}");
    assertFails(CommandRun.of("run", good, "--chain", chain), chain, "-1", " to ");
  }

  @Test
  void stackTraceIsPrintedOnlyWithDebug() throws IOException {
    Path empty = Files.createFile(folder.resolve("empty.aedat"));
    assertFalse(CommandRun.of("info", empty).err().contains("\tat "));
    assertTrue(CommandRun.of("info", "--debug", empty).err().contains("\tat "));
    assertTrue(CommandRun.of("--debug", "info", empty).err().contains("\tat "));
  }

  private Path chain(String text) throws IOException {
    return Files.write(folder.resolve("chain.json"), text.getBytes(StandardCharsets.UTF_8));
  }

  private Path emptyChain() throws IOException {
    return chain("{\"filters\": []}");
  }
}
