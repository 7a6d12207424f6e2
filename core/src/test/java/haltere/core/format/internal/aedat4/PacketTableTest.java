package haltere.core.format.internal.aedat4;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingFile;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.TimeSegment;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import haltere.testing.RecordedPackets;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Seeking by the packet table equals seeking by reading all events. */
class PacketTableTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260, Origin.TOP);
  private static final int TABLE_POSITION = Aedat4Header.TABLE_POSITION_OFFSET;

  @TempDir Path folder;

  /** Three segments: the clock goes back twice, once to a time within the packet before. */
  private byte[] file(Aedat4Compression compression) throws IOException {
    Path file = folder.resolve("table.aedat4");
    try (Aedat4Writer writer =
        Aedat4Writer.create(file, WriteOptions.of(SENSOR).withOverwrite(true), compression)) {
      long[] startsUs = {50_000, 1_000, 60_000};
      for (int i = 0; i < startsUs.length; i++) {
        writer.write(EventPackets.uniform(SENSOR, i + 1, 20_000, startsUs[i], 4));
        writer.writeThrough();
      }
      writer.finish();
    }
    return Files.readAllBytes(file);
  }

  private static ByteBuffer numbers(byte[] bytes) {
    return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
  }

  private Path withoutTable(byte[] bytes) throws IOException {
    byte[] cut = Arrays.copyOf(bytes, (int) numbers(bytes).getLong(TABLE_POSITION));
    numbers(cut).putLong(TABLE_POSITION, -1);
    return Files.write(folder.resolve("without.aedat4"), cut);
  }

  private static boolean isBelieved(Path path) throws IOException {
    try (RecordingFile file = new RecordingFile(path)) {
      Aedat4Header header = Aedat4Header.read(file);
      Aedat4Cursor.Layout layout =
          new Aedat4Cursor.Layout(
              header.streams().stream().map(Aedat4Stream::id).collect(Collectors.toSet()),
              header.dataOffset(),
              header.tablePosition() < 0 ? file.size() : header.tablePosition(),
              false,
              Map.of(),
              header.compression());
      int stream =
          header.streams().stream().filter(Aedat4Stream::isEvents).findFirst().orElseThrow().id();
      return PacketTable.readTable(file, layout, stream).isPresent();
    }
  }

  private static void assertSameSeeks(Path one, Path other, int seeks) throws IOException {
    try (RecordingReader first = Recordings.open(one);
        RecordingReader second = Recordings.open(other)) {
      List<TimeSegment> segments = first.segments();
      assertEquals(second.segments(), segments);
      SplittableRandom random = new SplittableRandom(5);
      for (int i = 0; i < seeks; i++) {
        int segment = random.nextInt(segments.size());
        TimeSegment within = segments.get(segment);
        long timeUs =
            random.nextLong(within.firstUs() - 1000, within.lastUs() + 1000 * random.nextInt(2));
        assertEquals(after(second, segment, timeUs), after(first, segment, timeUs));
      }
    }
  }

  /** Some events from a time on. */
  private static EventPacket after(RecordingReader reader, int segment, long timeUs)
      throws IOException {
    reader.seek(segment, timeUs);
    StreamRecorder recorder = new StreamRecorder();
    for (int i = 0; i < 4 && reader.next(recorder); i++) {
      // A few packets and the notifications between.
    }
    EventPacket events = recorder.events();
    return EventPackets.part(events, 0, Math.min(500, events.size()));
  }

  @ParameterizedTest
  @EnumSource(Aedat4Compression.class)
  void tableDoesNotChangeSegmentsAndSeeks(Aedat4Compression compression) throws IOException {
    byte[] bytes = file(compression);
    Path with = Files.write(folder.resolve("with.aedat4"), bytes);
    Path without = withoutTable(bytes);
    assertTrue(isBelieved(with));
    assertFalse(isBelieved(without));
    assertSameSeeks(with, without, 40);
  }

  @Test
  void tablesOfDvAreValid() throws IOException {
    for (RecordedPackets recording :
        List.of(RecordedPackets.DVXPLORER, RecordedPackets.DVS128_GESTURE)) {
      Path path = Recorded.file(recording.file());
      assertTrue(isBelieved(path), path.toString());
      assertSameSeeks(path, withoutTable(Files.readAllBytes(path)), 20);
    }
  }

  @Test
  void inconsistentTableIsIgnored() throws IOException {
    byte[] bytes = file(Aedat4Compression.NONE);
    Path without = withoutTable(bytes);
    int table = (int) numbers(bytes).getLong(TABLE_POSITION);
    SplittableRandom random = new SplittableRandom(6);
    int lies = 0;
    for (int i = 0; i < 200; i++) {
      byte[] lying = bytes.clone();
      lying[random.nextInt(table, bytes.length)] ^= (byte) (1 << random.nextInt(8));
      Path path = ReplacedFile.write(folder.resolve("lying.aedat4"), lying);
      if (!isBelieved(path)) {
        lies++;
      }
      if (i % 10 == 0) {
        assertSameSeeks(path, without, 2);
      }
    }
    assertTrue(lies > 100, "only " + lies + " of 200 were found out");
  }
}
