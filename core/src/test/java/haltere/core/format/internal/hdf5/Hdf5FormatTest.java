package haltere.core.format.internal.hdf5;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.event.Trigger;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** HDF5 keeps the contract of all formats for all layouts and compressions. */
class Hdf5FormatTest extends RecordingFormatContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260);
  private static final int THEIRS = 300;
  private static final int DAMAGES = 150;
  private static final int CUT_STEP_BYTES = 5;

  @Override
  protected RecordingFormat format() {
    return new Hdf5Format();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(
        SENSOR,
        new SensorGeometry(1280, 720, Origin.TOP),
        new SensorGeometry(1, 1),
        new SensorGeometry(32768, 32768));
  }

  @Override
  protected long earliestUs() {
    return Long.MIN_VALUE + 1;
  }

  @Override
  protected long latestUs() {
    return Long.MAX_VALUE;
  }

  @Override
  protected boolean endsInEvents() {
    return false;
  }

  /** Each number of the structure, one after the other, becomes large, none or odd. */
  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    List<byte[]> lies = new ArrayList<>();
    for (int at = 8; at < file.length - 8; at += at < 2048 ? 4 : 60) {
      byte[] lie = file.clone();
      ByteBuffer bytes = ByteBuffer.wrap(lie).order(ByteOrder.LITTLE_ENDIAN);
      if (bytes.getLong(at) == 0 && at % 64 != 0) {
        continue;
      }
      switch (at / 4 % 4) {
        case 0 -> bytes.putInt(at, 0x7fffffff);
        case 1 -> bytes.putLong(at, Long.MAX_VALUE / 3);
        case 2 -> bytes.putInt(at, -1);
        default -> bytes.putInt(at, bytes.getInt(at) + 3);
      }
      lies.add(lie);
    }
    return lies;
  }

  private static StreamRecorder read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(recorder);
    return recorder;
  }

  /** A file that h5py made, see make.py beside it. */
  private Path theirs(String name) throws IOException {
    Path file = folder.resolve(name);
    try (InputStream in = Hdf5FormatTest.class.getResourceAsStream(name + ".h5")) {
      Files.copy(in, file);
    }
    return file;
  }

  /** Content of all of these files. */
  private static EventPacket theirEvents() {
    EventPacket events = new EventPacket(THEIRS);
    for (int i = 0; i < THEIRS; i++) {
      long timeUs = 1_000_000 + 7L * i + i / 150 * 1_000_000;
      events.append(timeUs, i * 31 % 346, 259 - i * 17 % 260, i / 3 % 2 == 1);
    }
    return events;
  }

  /** Files of other programs whose chunks are plain or compressed with DEFLATE or LZF. */
  static Stream<String> layouts() {
    return Stream.of(
        "old-deflate-shuffle-fletcher32",
        "new-growing",
        "new-array-lzf",
        "new-single-deflate",
        "new-run",
        "dsec",
        "prophesee",
        "fields-nanoseconds",
        "table-txyp",
        "table-xytp-seconds",
        "table-by-columns",
        "table-pairs-of-columns",
        "new-table-three-columns",
        "new-growing-table-by-columns",
        "seconds-big-endian-truth",
        "nanoseconds-user-block",
        "matlab-column",
        "matlab-row",
        "new-lists-of-one-row",
        "microseconds-in-greek",
        "nanoseconds-by-attribute",
        "polarities-of-255");
  }

  /**
   * Files of other programs whose chunks are compressed by filters that are registered with HDF5.
   */
  static Stream<String> compressions() {
    return Stream.of(
        "blosc-zstd", "blosc-blosclz-bits", "blosc-lz4", "zstd", "lz4", "prophesee-ecf");
  }

  @ParameterizedTest
  @MethodSource({"layouts", "compressions"})
  void layoutsOfOtherProgramsAreRead(String name) throws IOException {
    EventPacket events = theirEvents();
    try (RecordingReader reader = Recordings.open(theirs(name))) {
      assertEquals(new SensorGeometry(346, 260, Origin.TOP), reader.geometry());
      assertEquals(events, read(reader).events());
      reader.seek(events.timeUs(170));
      assertEquals(EventPackets.part(events, 170, THEIRS), read(reader).events());
      assertEquals(
          name.equals("prophesee") ? 3 : 0, reader.violations().count(Violation.OTHER_DATA));
      assertEquals(0, reader.violations().count(Violation.CUT_OFF));
    }
  }

  @Test
  void eventsInAllEncodingsOfPropheseesCompressionAreRead() throws IOException {
    EventPacket events = new EventPacket(10_000);
    for (int i = 0; i < 10_000; i++) {
      int row = i < 4000 ? i / 40 : i < 8000 ? i / 20 % 200 : i * 17 % 240;
      int column = i < 4000 ? 5 + i % 20 : i * 37 % 320;
      long timeUs = 1000 + i / 50 * 3L + i / 200 * 20L + i / 5000 * 12_345_678L;
      events.append(timeUs, column, 259 - row, i / 150 % 2 == 1);
    }
    try (RecordingReader reader = Recordings.open(theirs("prophesee-ecf-rows"))) {
      assertEquals(events, read(reader).events());
      assertEquals("ecf", reader.compression().orElseThrow());
      assertEquals(0, reader.violations().count(Violation.DAMAGED_PACKET));
      reader.seek(events.timeUs(9_990));
      int from = events.indexAtOrAfter(events.timeUs(9_990));
      assertEquals(EventPackets.part(events, from, 10_000), read(reader).events());
    }
  }

  @Test
  void triggersBesideTheEventsAreReadInOrderWithThem() throws IOException {
    EventPacket events = theirEvents();
    Path file = theirs("prophesee-triggers");
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSamples(true))) {
      StreamRecorder all = read(reader);
      assertEquals(events, all.events());
      assertEquals(
          List.of(
              external(999_000, Trigger.Edge.RISING, 0),
              external(1_000_014, Trigger.Edge.FALLING, 0),
              external(1_000_700, Trigger.Edge.RISING, 6),
              external(2_001_050, Trigger.Edge.FALLING, 6),
              external(2_500_000, Trigger.Edge.RISING, 0)),
          all.samples(Trigger.class));
      assertEquals(5, reader.countSamples().triggers());
      assertEquals(List.of(), reader.remarks(), "Metavision's rows count from the top");

      reader.seek(events.timeUs(150));
      StreamRecorder rest = read(reader);
      assertEquals(EventPackets.part(events, 150, THEIRS), rest.events());
      assertEquals(
          List.of(
              external(2_001_050, Trigger.Edge.FALLING, 6),
              external(2_500_000, Trigger.Edge.RISING, 0)),
          rest.samples(Trigger.class));
    }
  }

  private static Trigger external(long timeUs, Trigger.Edge edge, int channel) {
    return new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, edge, channel);
  }

  @Test
  void eachCameraOfAFileOfTwoIsATopicAndTheOtherIsNamed() throws IOException {
    Path file = theirs("two-cameras");
    EventPacket events = theirEvents();
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(events, read(reader).events());
      String remarks = reader.remarks().toString();
      assertTrue(remarks.contains("cameras/left are read"), remarks);
      assertTrue(remarks.contains("--topic chooses another: cameras/right"), remarks);
    }
    ReadOptions right = ReadOptions.DEFAULT.withTopic("cameras/right");
    try (RecordingReader reader = Recordings.open(file, right)) {
      assertEquals(EventPackets.part(events, 7, THEIRS), read(reader).events());
    }
    RecordingProblem missing =
        assertThrows(
            RecordingProblem.class,
            () -> Recordings.open(file, ReadOptions.DEFAULT.withTopic("imu/events")).close());
    assertTrue(
        missing.getMessage().endsWith("; there are cameras/left, cameras/right"),
        missing.getMessage());
  }

  @Test
  void eventsAreFoundBehindHundredsOfFrames() throws IOException {
    Path file = folder.resolve("frames-first");
    try (InputStream in = Hdf5FormatTest.class.getResourceAsStream("frames-first.h5.gz")) {
      Files.copy(new GZIPInputStream(in), file);
    }
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(theirEvents(), read(reader).events());
    }
  }

  @Test
  void rowsWithoutNumbersAreSkippedAndCounted() throws IOException {
    EventPacket events = new EventPacket(2);
    events.append(5, 0, 478, true);
    events.append(7, 2, 478, true);
    Path file = theirs("rows-without-numbers");
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withSensor(new SensorGeometry(640, 480)))) {
      assertEquals(events, read(reader).events());
      assertEquals(4, reader.violations().count(Violation.UNKNOWN_WORD));
    }
  }

  @Test
  void fractionsShowTheTimesOfATableOfOneRow() throws IOException {
    EventPacket events = new EventPacket(1);
    events.append(46_670, 639, 386, true);
    Path file = theirs("table-one-row-seconds");
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withSensor(new SensorGeometry(640, 480)))) {
      assertEquals(events, read(reader).events());
    }
  }

  @ParameterizedTest
  @CsvSource({
    "old-deflate-shuffle-fletcher32, deflate",
    "new-array-lzf, lzf",
    "blosc-blosclz-bits, blosc (blosclz)",
    "blosc-zstd, blosc (zstd)",
    "lz4, lz4",
    "zstd, zstd",
    "new-run, none"
  })
  void readerStatesTheCompression(String name, String method) throws IOException {
    try (RecordingReader reader = Recordings.open(theirs(name))) {
      assertEquals(method, reader.compression().orElseThrow());
    }
  }

  @ParameterizedTest
  @CsvSource({
    "filter-ecf, ECF",
    "filter-unknown, filter 54321",
    "large-chunks, h5repack -l CHUNK=65536",
    "polarities-of-text, its polarities cannot be read",
    "polarities-one-and-two, its polarities are 1 to 2",
    "no-events, [weights]"
  })
  void unsupportedFilesAreRejectedWithAReasonAndARemedy(String name, String reason)
      throws IOException {
    Path file = theirs(name);
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains(reason), refused.getMessage());
    assertEquals(1, refused.getMessage().lines().count());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "old-deflate-shuffle-fletcher32",
        "new-growing",
        "new-array-lzf",
        "table-pairs-of-columns",
        "new-growing-table-by-columns",
        "blosc-zstd",
        "blosc-lz4",
        "lz4",
        "prophesee",
        "prophesee-ecf",
        "prophesee-ecf-rows",
        "prophesee-triggers",
        "seconds-big-endian-truth"
      })
  void damageInFilesOfOtherProgramsIsReportedWithoutACrash(String name) throws IOException {
    byte[] whole = Files.readAllBytes(theirs(name));
    java.util.SplittableRandom random = new java.util.SplittableRandom(name.hashCode());
    Path file = folder.resolve("damaged");
    int refused = 0;
    for (int i = 0; i < DAMAGES; i++) {
      byte[] bytes = whole.clone();
      for (int flips = random.nextInt(1, 6); flips > 0; flips--) {
        bytes[random.nextInt(bytes.length)] = (byte) random.nextInt(256);
      }
      ReplacedFile.write(
          file, i % 5 == 0 ? Arrays.copyOf(bytes, i * bytes.length / DAMAGES) : bytes);
      try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
        assertTrue(read(reader).events().size() <= whole.length);
      } catch (RecordingProblem problem) {
        refused++;
        assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      }
    }
    assertTrue(refused > 10, refused + " were refused");
  }

  @ParameterizedTest
  @MethodSource("layouts")
  void truncatedFilesOfOtherProgramsYieldNoInventedEvent(String name) throws IOException {
    byte[] whole = Files.readAllBytes(theirs(name));
    EventPacket events = theirEvents();
    Path file = folder.resolve("cut");
    for (int length = whole.length - 1; length > 0; length -= CUT_STEP_BYTES) {
      ReplacedFile.write(file, Arrays.copyOf(whole, length));
      try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT.withSensor(SENSOR))) {
        EventPacket got = read(reader).events();
        assertEquals(EventPackets.part(events, 0, got.size()), got, "cut to " + length + " bytes");
      } catch (RecordingProblem problem) {
        assertEquals(1, problem.getMessage().lines().count());
      }
    }
  }

  @Test
  void damagedChunkIsSkippedAndTheNextIsRead() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 1, 150_000, 5_000_000, 40);
    Path file = folder.resolve("chunks.h5");
    write(file, SENSOR, events);
    byte[] bytes = Files.readAllBytes(file);
    bytes[Hdf5Structure.BYTES + 300_000] ^= 0x55;
    Files.write(file, bytes);
    try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT)) {
      EventPacket got = read(reader).events();
      assertEquals(1, reader.violations().count(Violation.DAMAGED_PACKET));
      assertTrue(got.size() >= 150_000 - 65_536 && got.size() < 150_000, got.toString());
      reader.seek(events.firstTimeUs());
      assertEquals(got, read(reader).events());
      assertEquals(1, reader.violations().count(Violation.DAMAGED_PACKET), "counted once");
    }
  }

  @Test
  void everyCompressionLevelAndChunkTreesAreWritten() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 2, 200_000, -5_000_000, 40);
    for (int level : new int[] {0, 1, 9}) {
      Path file = folder.resolve("level-" + level + ".h5");
      try (RecordingWriter writer =
          Hdf5Writer.create(file, WriteOptions.of(SENSOR).withOverwrite(true), level)) {
        for (int i = 0; i < (level == 0 ? 25 : 1); i++) {
          writer.write(EventPackets.shifted(events, 9_000_000L * i));
        }
        writer.finish();
      }
      try (RecordingReader reader = Recordings.open(file)) {
        assertEquals(SENSOR, reader.geometry());
        EventPacket last = events;
        if (level == 0) {
          last = EventPackets.shifted(events, 24 * 9_000_000L);
          reader.seek(last.firstTimeUs());
        }
        assertEquals(last, read(reader).events());
        assertEquals(List.of(), reader.violations().describe());
      }
    }
    assertThrows(
        IllegalArgumentException.class,
        () -> Hdf5Writer.create(folder.resolve("x.h5"), WriteOptions.of(SENSOR), 10));
  }

  @Test
  void eventsOutsideTheSensorAreSkippedAndReported() throws IOException {
    EventPacket events = new EventPacket(2);
    events.append(1, 345, 259, true);
    events.append(2, 346, 0, true);
    Path file = folder.resolve("outside.h5");
    try (RecordingWriter writer = format().create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      writer.write(events);
      assertEquals(1, writer.losses().size());
      writer.finish();
    }
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(EventPackets.part(events, 0, 1), read(reader).events());
    }
  }
}
