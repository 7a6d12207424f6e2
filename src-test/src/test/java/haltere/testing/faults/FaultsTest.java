package haltere.testing.faults;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.testing.faults.FaultyProgram.Ended;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The whole program on disks that get full, fail and are slow, with little memory and a clock that
 * jumps. Nothing is lost that was promised: an output is whole or not there, a line says why, and
 * the program ends.
 */
@Tag("faults")
class FaultsTest {
  private static final Map<String, ?> NONE = Map.of();
  private static final List<String> CUTS =
      List.of(
          "dvs128-moving-dark-box-cut.aedat",
          "dvs128-tmpdiff128-2007.dat",
          "evt3-eventpacket-cut.bag",
          "evt3-with-triggers.db3");

  /** Faults at random places; -Pfaults=N has so many of a kind. */
  private static final int TRIES = Integer.getInteger("haltere.faults.tries", 1);

  @TempDir static Path common;
  @TempDir Path folder;
  private static Path in;
  private Path out;
  private Path notes;

  @BeforeAll
  static void copyRecordings() throws IOException {
    common = common.toRealPath();
    in = Files.createDirectory(common.resolve("in"));
    for (String cut : CUTS) {
      Files.copy(Path.of("recordings", cut), in.resolve(cut));
    }
  }

  @BeforeEach
  void makeFolders() throws IOException {
    folder = folder.toRealPath();
    out = Files.createDirectory(folder.resolve("out"));
    notes = folder.resolve("notes");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "a.aedat",
        "a.aedat4",
        "a.raw",
        "a.dat",
        "a.es",
        "a.csv",
        "a.h5",
        "a.npz",
        "a.mcap"
      })
  void fullDiskLeavesNoRecording(String name) throws IOException {
    Path file = out.resolve(name);
    FaultyProgram.run(NONE, notes, "convert", in.resolve(CUTS.get(0)), file).wentWell();
    long bytes = Files.size(file);
    Files.delete(file);
    for (int i = 0; i < TRIES; i++) {
      long room = new Random(name.hashCode() + i).nextLong(bytes);
      Map<String, ?> full = Map.of("FAULTS_FOLDER", out, "FAULTS_FULL_AFTER", room);
      FaultyProgram.run(full, notes, "convert", in.resolve(CUTS.get(0)), file)
          .saysOf(file.toString(), "No space left on device; make room");
      assertEquals(Map.of(), files(out));
    }
    Map<String, ?> limited = Map.of("FAULTS_FOLDER", out, "FAULTS_LARGE_AFTER", bytes / 2);
    FaultyProgram.run(limited, notes, "convert", in.resolve(CUTS.get(0)), file)
        .saysOf(file.toString(), "File too large; the disk or a limit");
    assertEquals(Map.of(), files(out));
  }

  @ParameterizedTest
  @ValueSource(strings = {"tracks.csv", "tracks.parquet", "tracks.npz"})
  void fullDiskLeavesNoTable(String name) throws IOException {
    Path table = out.resolve(name);
    Map<String, ?> full = Map.of("FAULTS_FOLDER", out, "FAULTS_FULL_AFTER", 3000);
    FaultyProgram.run(full, notes, "track", in.resolve(CUTS.get(0)), "--out", table)
        .saysOf(table.toString(), "No space left on device");
    assertEquals(Map.of(), files(out));
  }

  @Test
  void fullDiskLeavesNeitherSceneNorTruth() throws IOException {
    Map<String, ?> full = Map.of("FAULTS_FOLDER", out, "FAULTS_FULL_AFTER", 60_000);
    Path truth = out.resolve("truth.csv");
    FaultyProgram.run(full, notes, "simulate", "fly", out.resolve("fly.dat"), "--truth", truth)
        .saysOf(out.toString(), "No space left on device");
    assertEquals(Map.of(), files(out));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void readErrorIsReportedWithFileAndByte(int number) throws IOException {
    Path recording = in.resolve(CUTS.get(number));
    Path whole = folder.resolve("whole.csv");
    FaultyProgram.run(NONE, notes, "convert", recording, whole).wentWell();
    Path file = out.resolve("a.csv");
    for (int i = 0; i < TRIES; i++) {
      long at = new Random(number + 10L * i).nextLong(Files.size(recording));
      Map<String, ?> faulty = Map.of("FAULTS_FOLDER", recording, "FAULTS_READ_ERROR_AT", at);
      Ended ended = FaultyProgram.run(faulty, notes, "convert", recording, file);
      if (ended.status() == 0) {
        ended.wentWell(); // nothing of the recording was there
        assertArrayEquals(Files.readAllBytes(whole), Files.readAllBytes(file));
        Files.delete(file);
      } else {
        ended.saysOf(recording + ", byte ", "Input/output error; the disk or its connection");
      }
      assertEquals(Map.of(), files(out));
    }
  }

  @Test
  void unreadableRecordingIsReportedAndDoesNotStopABatch() throws IOException {
    Map<String, byte[]> whole = undisturbedBatch();
    for (String cut : CUTS) {
      Path results = out.resolve(cut);
      Map<String, ?> faulty =
          Map.of("FAULTS_FOLDER", in.resolve(cut), "FAULTS_READ_ERROR_AT", 100_000);
      batch(faulty, results).saysOf(cut, "Input/output error");
      Map<String, byte[]> done = files(results);
      assertTrue(new String(done.remove("failed.json")).contains(cut));
      Map<String, byte[]> others = new TreeMap<>(whole);
      others.keySet().removeIf(name -> name.startsWith(cut));
      assertSame(others, done);
    }
  }

  @Test
  void folderThatCannotBeListedIsReportedAndDoesNotStopABatch() throws IOException {
    Path damaged = Files.createDirectory(in.resolve("damaged"));
    try {
      Map<String, ?> faulty = Map.of("FAULTS_FOLDER", damaged, "FAULTS_LIST_ERROR", 1);
      batch(faulty, out).saysOf("damaged", "cannot be read");
    } finally {
      Files.delete(damaged);
    }
    Map<String, byte[]> done = files(out);
    assertTrue(new String(done.remove("failed.json")).contains("damaged"));
    assertSame(undisturbedBatch(), done);
  }

  @Test
  void folderOfExtensionsThatCannotBeListedIsNamed() throws IOException {
    Path jars = Files.createDirectory(folder.resolve("jars"));
    Map<String, ?> faulty = Map.of("FAULTS_FOLDER", jars, "FAULTS_LIST_ERROR", 1);
    FaultyProgram.run(faulty, notes, "filters", "--extensions", jars)
        .saysOf(jars.toString(), "Input/output error");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"FAULTS_FULL_AFTER", "FAULTS_SYNC_ERROR", "FAULTS_RENAME_ERROR", "FAULTS_SLOW_US"})
  void batchInterruptedByDiskFaultsResumesToTheSameResults(String fault) throws IOException {
    Map<String, byte[]> whole = undisturbedBatch();
    long bytes = whole.values().stream().mapToLong(content -> content.length).sum();
    for (int i = 0; i < TRIES; i++) {
      Path results = out.resolve("results" + i);
      boolean slow = fault.equals("FAULTS_SLOW_US");
      long value =
          fault.equals("FAULTS_FULL_AFTER") ? new Random(i).nextLong(bytes) : slow ? 2000 : 1;
      Ended ended = batch(Map.of("FAULTS_FOLDER", out, fault, value), results);
      if (slow) {
        ended.wentWell();
      } else {
        ended.saysOf(out.toString(), "; ");
        batch(NONE, results).wentWell();
      }
      assertSame(whole, files(results));
    }
  }

  @Test
  void cameraRecordingOnAFullDiskHoldsTheReportedEvents() throws IOException {
    Path file = out.resolve("r.aedat4");
    Map<String, ?> full = Map.of("FAULTS_FOLDER", out, "FAULTS_FULL_AFTER", 200_000);
    Ended ended = record(full, file);
    ended.saysOf(file.toString(), "No space left on device");
    long events = eventsOf(file);
    assertTrue(events > 0 && events >= number(ended, "holds at least ([\\d,]+) events of"));
    assertTrue(events <= number(ended, "events of ([\\d,]+) received"));
    Path other = out.resolve("r.raw");
    record(full, other).saysOf(other.toString(), "was not kept");
    assertEquals(List.of("r.aedat4"), List.copyOf(files(out).keySet()));
  }

  @Test
  void cameraRecordingIsCompleteDespiteASlowDiskAndAClockJump() throws IOException {
    Path file = out.resolve("r.aedat4");
    Map<String, ?> faults =
        Map.of("FAULTS_FOLDER", out, "FAULTS_SLOW_US", 50_000, "FAULTS_CLOCK_JUMP_S", -7200);
    Ended ended = record(faults, file).wentWell();
    assertEquals(number(ended, "wrote .* \\(([\\d,]+) events"), eventsOf(file));
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void tracksAreTheSameWithLittleMemoryAndAClockJump(int number) throws IOException {
    Path recording = in.resolve(CUTS.get(number));
    Path usual = out.resolve("usual.csv");
    FaultyProgram.run(NONE, notes, "track", recording, "--out", usual).wentWell();
    Path other = out.resolve("other.csv");
    Map<String, ?> faults = Map.of("JAVA_OPTS", "-Xmx128m", "FAULTS_CLOCK_JUMP_S", -86_400);
    FaultyProgram.run(faults, notes, "track", recording, "--out", other).wentWell();
    assertArrayEquals(Files.readAllBytes(usual), Files.readAllBytes(other));
  }

  private Ended record(Map<String, ?> faults, Path file) throws IOException {
    return FaultyProgram.run(
        faults, notes, "record", "--device", "simulated:fly", "--duration", "1", file);
  }

  private Ended batch(Map<String, ?> faults, Path results) throws IOException {
    return FaultyProgram.run(
        faults, notes, "batch", in, "--track", "--out", results, "--resume", "--workers", "2");
  }

  private Map<String, byte[]> undisturbedBatch() throws IOException {
    Path results = common.resolve("whole");
    batch(NONE, results).wentWell();
    return files(results);
  }

  private long eventsOf(Path recording) throws IOException {
    Path table = folder.resolve("events.csv");
    FaultyProgram.run(NONE, notes, "convert", recording, table, "--overwrite").wentWell();
    try (Stream<String> lines = Files.lines(table)) {
      return lines.count() - 1;
    }
  }

  private static long number(Ended ended, String words) {
    Pattern pattern = Pattern.compile(words);
    return ended.messages().stream()
        .map(pattern::matcher)
        .filter(Matcher::find)
        .mapToLong(found -> Long.parseLong(found.group(1).replace(",", "")))
        .findFirst()
        .orElseThrow(() -> new AssertionError(ended.messages()));
  }

  private static Map<String, byte[]> files(Path folder) throws IOException {
    Map<String, byte[]> contents = new TreeMap<>();
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path file : all.filter(Files::isRegularFile).toList()) {
        contents.put(folder.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
    return contents;
  }

  private static void assertSame(Map<String, byte[]> expected, Map<String, byte[]> actual) {
    assertEquals(expected.keySet(), actual.keySet());
    expected.forEach((name, bytes) -> assertArrayEquals(bytes, actual.get(name), name));
  }
}
