package haltere.core.format.internal.index;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The index stored beside a recording on request. */
class KeptIndexTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(240, 180, Origin.TOP);
  private static final ReadOptions KEEP = ReadOptions.DEFAULT.withKeptIndex(true);

  @TempDir Path folder;
  private EventPacket first;
  private EventPacket second;

  @BeforeEach
  void makeEvents() {
    first = EventPackets.uniform(SENSOR, 1, 100_000, 5_000_000, 20);
    second = EventPackets.uniform(SENSOR, 2, 100_000, 1_000_000, 20);
  }

  private Path write(String name) throws IOException {
    Path file = folder.resolve(name);
    try (RecordingWriter writer =
        Recordings.forWriting(file).create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      writer.write(first);
      writer.write(second);
      writer.finish();
    }
    return file;
  }

  private static Path index(Path file) {
    return file.resolveSibling(file.getFileName() + ".haltere-index");
  }

  /** Seeks to random places; returns what the reader remarks about the index. */
  private List<String> checkSeeks(Path file, ReadOptions options) throws IOException {
    SplittableRandom random = new SplittableRandom(4);
    try (RecordingReader reader = Recordings.open(file, options)) {
      assertEquals(2, reader.segments().size());
      for (int i = 0; i < 6; i++) {
        EventPacket events = i % 2 == 0 ? first : second;
        int from = random.nextInt(1, events.size());
        reader.seek(i % 2, events.timeUs(from));
        from = events.indexAtOrAfter(events.timeUs(from));
        StreamRecorder got = new StreamRecorder();
        while (got.events().isEmpty()) {
          reader.next(got);
        }
        EventPacket some = EventPackets.part(events, from, from + 1);
        assertEquals(some, EventPackets.part(got.events(), 0, 1));
      }
      return reader.remarks().stream().filter(line -> line.contains("index")).toList();
    }
  }

  @Test
  void indexIsWrittenOnlyOnRequest() throws IOException {
    Path file = write("plain.aedat");
    assertEquals(List.of(), checkSeeks(file, ReadOptions.DEFAULT));
    assertFalse(Files.exists(index(file)));
  }

  @ParameterizedTest
  @ValueSource(strings = {"a.aedat", "a.aedat4", "a.raw", "a.dat", "a.csv", "a.npz"})
  void storedIndexesYieldTheSameSeekPositions(String name) throws IOException {
    Path file = write(name);
    assertEquals(List.of(), checkSeeks(file, KEEP));
    FileTime written = Files.getLastModifiedTime(index(file));
    assertEquals(List.of(), checkSeeks(file, ReadOptions.DEFAULT));
    assertEquals(List.of(), checkSeeks(file, KEEP));
    assertEquals(written, Files.getLastModifiedTime(index(file)), "it is not made again");
  }

  @Test
  void indexOfAnotherRecordingIsReplaced() throws IOException {
    Path file = write("changed.aedat");
    checkSeeks(file, KEEP);
    byte[] old = Files.readAllBytes(index(file));
    second = EventPackets.uniform(SENSOR, 3, 100_000, 1_000_000, 20);
    Files.delete(file);
    write("changed.aedat");

    String expected = index(file) + " is out of date and is ignored";
    assertTrue(checkSeeks(file, ReadOptions.DEFAULT).get(0).startsWith(expected));
    assertTrue(Arrays.equals(old, Files.readAllBytes(index(file))), "nobody asked to replace it");
    assertTrue(checkSeeks(file, KEEP).get(0).startsWith(expected));
    assertEquals(List.of(), checkSeeks(file, ReadOptions.DEFAULT));
  }

  @Test
  void damagedIndexIsIgnored() throws IOException {
    Path file = write("damaged.aedat");
    checkSeeks(file, KEEP);
    byte[] whole = Files.readAllBytes(index(file));
    SplittableRandom random = new SplittableRandom(5);
    for (int round = 0; round < 20; round++) {
      byte[] bytes = Arrays.copyOf(whole, random.nextInt(whole.length));
      if (round % 2 == 0) {
        bytes = whole.clone();
        bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
      }
      Files.write(index(file), bytes);
      assertEquals(1, checkSeeks(file, ReadOptions.DEFAULT).size());
    }
  }

  @Test
  void readOnlyFolderIsNoFailure() throws IOException {
    Path file = write("full.aedat");
    Files.createDirectory(index(file));
    Files.createFile(index(file).resolve("something"));
    assertEquals(2, checkSeeks(file, KEEP).size());
  }
}
