package haltere.core.format.internal.evt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Contract of the three encodings of RAW files. */
abstract class EvtContract extends RecordingFormatContract {
  static final SensorGeometry GEN3 = new SensorGeometry(640, 480, Origin.TOP);
  static final SensorGeometry GEN4 = new SensorGeometry(1280, 720, Origin.TOP);
  private static final long HOUR_US = 3_600_000_000L;

  /** Words that mean nothing, or nothing that is read. */
  abstract byte[] fillers();

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(
        GEN3,
        GEN4,
        new SensorGeometry(1, 1),
        new SensorGeometry(346, 260),
        new SensorGeometry(2048, 2048));
  }

  @Override
  protected long earliestUs() {
    return 0;
  }

  @Override
  protected long latestUs() {
    return 50 * HOUR_US;
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    String text = new String(file, StandardCharsets.ISO_8859_1);
    List<byte[]> lies = new ArrayList<>();
    for (String lie : List.of("0x0", "99999x99999", "2049x1", "3x3")) {
      int wide = lie.indexOf('x');
      lies.add(
          text.replace("geometry 640x480", "geometry " + lie)
              .replace(
                  "height=480;width=640",
                  "height=" + lie.substring(wide + 1) + ";width=" + lie.substring(0, wide))
              .getBytes(StandardCharsets.ISO_8859_1));
    }
    for (String base : List.of("99999999999999999999", "9223372036854775807", "-1", "x")) {
      lies.add(
          ("% " + EvtFormat.TIME_BASE + " " + base + "\n" + text)
              .getBytes(StandardCharsets.ISO_8859_1));
    }
    lies.add(("% a b\n".repeat(400_000) + text).getBytes(StandardCharsets.ISO_8859_1));
    byte[] filler = fillers();
    byte[] endless = Arrays.copyOf(file, file.length + 300_000 * filler.length);
    for (int i = file.length; i < endless.length; i++) {
      endless[i] = filler[(i - file.length) % filler.length];
    }
    lies.add(endless);
    return lies;
  }

  static StreamRecorder read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(new StreamGrammar(recorder));
    return recorder;
  }

  EventPacket events(Path file, ReadOptions options) throws IOException {
    try (RecordingReader reader = format().open(file, options)) {
      return read(reader).events();
    }
  }

  @Test
  void timesSince1970AndLongSilencesAreReadBack() throws IOException {
    EventPacket written = new EventPacket(0);
    long timeUs = 1_718_925_184_590_631L;
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 500; i++) {
      written.append(timeUs, random.nextInt(640), random.nextInt(480), random.nextBoolean());
      timeUs += 1L << random.nextInt(36);
    }
    Path file = folder.resolve("long.raw");
    writeWithBase(file, written);

    assertEquals(written, events(file, ReadOptions.DEFAULT));
  }

  private void writeWithBase(Path file, EventPacket written) throws IOException {
    try (RecordingWriter writer = format().create(file, WriteOptions.of(GEN3)).orElseThrow()) {
      writer.write(written);
      writer.finish();
      assertEquals(1, writer.losses().size());
      assertTrue(writer.losses().get(0).contains("other programs"), writer.losses().get(0));
    }
  }

  @Test
  void negativeTimesAreReadBack() throws IOException {
    EventPacket written = EventPackets.uniform(GEN3, 9, 1000, -30 * HOUR_US - 7, HOUR_US / 16);
    Path file = folder.resolve("negative.raw");
    writeWithBase(file, written);

    assertTrue(written.lastTimeUs() > 0);
    assertEquals(written, events(file, ReadOptions.DEFAULT));
  }

  @Test
  void descendingTimesWithinAWrapPeriodAreReadBack() throws IOException {
    List<EventPacket> packets = new ArrayList<>();
    for (long startUs : new long[] {16_000_000, 15_998_000, 9_000_000, 2000, 99}) {
      packets.add(EventPackets.uniform(GEN3, startUs, 50, startUs, 3));
    }
    Path file = folder.resolve("back.raw");
    write(file, GEN3, packets.toArray(EventPacket[]::new));
    try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT)) {
      StreamRecorder stream = read(reader);
      assertEquals(EventPackets.join(packets), stream.events());
      assertEquals(4, stream.notifications(Reset.class).size());
      assertEquals(5, reader.segments().size());
    }
  }

  @Test
  void jumpsBeyondTheClockRangeAreReported() throws IOException {
    EventPacket late = EventPackets.uniform(GEN3, 1, 10, 40 * HOUR_US, 3);
    EventPacket early = EventPackets.uniform(GEN3, 2, 10, 0, 3);
    try (RecordingWriter writer =
        format().create(folder.resolve("leap.raw"), WriteOptions.of(GEN3)).orElseThrow()) {
      writer.write(late);
      writer.write(early);
      writer.finish();
      assertTrue(
          writer.losses().stream().anyMatch(line -> line.startsWith("1 jump of time does not fit")),
          writer.losses().toString());
    }
    assertEquals(20, events(folder.resolve("leap.raw"), ReadOptions.DEFAULT).size());
  }

  @Test
  void eventOutsideTheSensorIsSkippedAndReported() throws IOException {
    EventPacket written = new EventPacket(0);
    written.append(0, 639, 479, true);
    written.append(0, 640, 479, true);
    written.append(2, 0, 480, true);
    Path file = folder.resolve("outside.raw");
    try (RecordingWriter writer = format().create(file, WriteOptions.of(GEN3)).orElseThrow()) {
      writer.write(written);
      writer.finish();
      assertEquals(List.of("2 events outside of 640x480 were left out"), writer.losses());
    }
    assertEquals(EventPackets.part(written, 0, 1), events(file, ReadOptions.DEFAULT));
  }

  @Test
  void oversizedSensorsAreRejected() {
    RecordingProblem refused =
        assertThrows(
            RecordingProblem.class,
            () ->
                format()
                    .create(
                        folder.resolve("large.raw"), WriteOptions.of(new SensorGeometry(2049, 2))));
    assertTrue(refused.getMessage().contains("2048x2048"), refused.getMessage());
  }

  @Test
  void metadataAreWrittenToTheHeaderAndCannotForgeIt() throws IOException {
    Path file = folder.resolve("metadata.raw");
    WriteOptions options =
        new WriteOptions(
            GEN3,
            false,
            Optional.empty(),
            Map.of("Place of it", "Zürich\n% end", "geometry", "1x1", "END", ""));
    EventPacket written = EventPackets.uniform(GEN3, 3, 100, 0, 20);
    try (RecordingWriter writer = format().create(file, options).orElseThrow()) {
      writer.write(written);
      writer.finish();
    }
    String text = Files.readString(file, StandardCharsets.ISO_8859_1);
    assertTrue(text.contains("% Place_of_it Z?rich % end\n"), text.substring(0, 200));
    assertEquals(written, events(file, ReadOptions.DEFAULT));
  }

  @Test
  void unstatedSizesComeFromTheUserOrTheEvents() throws IOException {
    EventPacket written = EventPackets.uniform(GEN3, 4, 1000, 0, 20);
    Path file = folder.resolve("size.raw");
    write(file, GEN3, written);
    String text = Files.readString(file, StandardCharsets.ISO_8859_1);
    Files.writeString(
        file,
        text.replace("% geometry 640x480\n", "").replace(";height=480;width=640", ""),
        StandardCharsets.ISO_8859_1);

    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(GEN3, reader.geometry());
      assertTrue(reader.remarks().get(0).contains("--sensor"), reader.remarks().toString());
      assertEquals(written, read(reader).events());
    }
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withSensor(new SensorGeometry(700, 480)))) {
      assertEquals(new SensorGeometry(700, 480, Origin.TOP), reader.geometry());
      assertEquals(List.of(), reader.remarks());
      assertEquals(written, read(reader).events());
    }
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withSensor(new SensorGeometry(320, 480)))) {
      int outside = 1000 - read(reader).events().size();
      assertTrue(outside > 300);
      assertEquals(outside, reader.violations().count(Violation.OUTSIDE_SENSOR));
    }
  }

  @Test
  void unknownEncodingsInTheHeaderAreRejected() throws IOException {
    Path file = folder.resolve("other.raw");
    Files.writeString(file, "% format EVT4;height=480;width=640\n% end\n");
    RecordingProblem refused =
        assertThrows(
            RecordingProblem.class, () -> format().open(file, ReadOptions.DEFAULT).close());
    assertTrue(refused.getMessage().contains("EVT4"), refused.getMessage());
  }

  /** Decodes words in any order, truncated anywhere, with any packet size. */
  @Test
  void eventsOfArbitraryBytesDoNotDependOnPacketSizes() throws IOException {
    for (long seed = 0; seed < 40; seed++) {
      SplittableRandom random = new SplittableRandom(seed);
      byte[] words = randomWords(random);
      Path file = folder.resolve("any-" + seed);
      ReplacedFile.write(file, words);
      ReadOptions options =
          ReadOptions.DEFAULT.withSensor(new SensorGeometry(600, 400)).withFormat(format().name());
      try (RecordingReader usual = Recordings.open(file, options);
          RecordingReader small = Recordings.open(file, options.withPacketEvents(5))) {
        StreamRecorder expected = read(usual);
        StreamRecorder got = read(small);
        assertEquals(expected.events(), got.events(), "seed " + seed);
        assertEquals(expected.notifications(), got.notifications(), "seed " + seed);
        assertEquals(usual.violations().describe(), small.violations().describe(), "seed " + seed);
      }
    }
  }

  /** Words of all kinds, those that make events more often than chance would have it. */
  abstract byte[] randomWords(SplittableRandom random);
}
