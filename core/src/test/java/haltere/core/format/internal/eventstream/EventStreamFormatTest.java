package haltere.core.format.internal.eventstream;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.ViolationCounts;
import haltere.core.format.WriteOptions;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Event Stream keeps the contract of all formats, as far as a clock that only continues can. */
class EventStreamFormatTest extends RecordingFormatContract {
  private static final SensorGeometry SENSOR = new SensorGeometry(320, 240, Origin.TOP);

  @Override
  protected RecordingFormat format() {
    return new EventStreamFormat();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(SENSOR, new SensorGeometry(1, 1), new SensorGeometry(32768, 32768));
  }

  @Override
  protected long earliestUs() {
    return 0;
  }

  @Override
  protected long latestUs() {
    return 600_000_000L;
  }

  @Override
  protected boolean clockCanGoBack() {
    return false;
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    List<byte[]> lies = new ArrayList<>();
    for (int at : new int[] {12, 13, 15, 16, 17, 18, 19}) {
      for (int value : new int[] {0, 3, 200, 255}) {
        byte[] lie = file.clone();
        lie[at] = (byte) value;
        lies.add(lie);
      }
    }
    for (int filler : new int[] {0xff, 0xfe}) {
      byte[] endless = Arrays.copyOf(file, file.length + 2_000_000);
      Arrays.fill(endless, file.length, endless.length, (byte) filler);
      lies.add(endless);
    }
    return lies;
  }

  private static byte[] bytes(int... values) {
    byte[] bytes = new byte[values.length];
    for (int i = 0; i < values.length; i++) {
      bytes[i] = (byte) values[i];
    }
    return bytes;
  }

  private static ByteBuffer buffer(int... values) {
    return ByteBuffer.wrap(bytes(values)).order(ByteOrder.LITTLE_ENDIAN);
  }

  private static StreamRecorder read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(new StreamGrammar(recorder));
    return recorder;
  }

  @Test
  void bytesAreDecodedAsSpecified() {
    ViolationCounts violations = new ViolationCounts();
    EventStreamDecoder decoder =
        new EventStreamDecoder(EventStreamDecoder.StreamKind.DVS, SENSOR, violations);
    EventPacket packet = new EventPacket(0);
    decoder.decode(
        buffer(
            0x07, 5, 0, 6, 0, 0xff, 0xfe, 0xfc, 0x3f, 1, 0xef, 0, 0x00, 0x40, 1, 0, 0, 0x02, 1, 1,
            1),
        0,
        packet,
        100);

    EventPacket expected = new EventPacket(0);
    expected.append(3, 5, 233, true);
    expected.append(3 + 127 + 126, 319, 0, false);
    assertEquals(expected, packet);
    assertEquals(1, violations.count(Violation.OUTSIDE_SENSOR));
    assertEquals(12, violations.firstOffset(Violation.OUTSIDE_SENSOR));
  }

  @Test
  void pixelEventsOfAtisFilesAreRead() {
    ViolationCounts violations = new ViolationCounts();
    EventStreamDecoder decoder =
        new EventStreamDecoder(EventStreamDecoder.StreamKind.ATIS, SENSOR, violations);
    EventPacket packet = new EventPacket(0);
    decoder.decode(
        buffer(
            0x06, 5, 0, 6, 0, 0xff, 0xfc, 0xfd, 0x05, 5, 0, 6, 0, 0x08, 7, 0, 0, 0, 0x03, 1, 0, 1,
            0),
        0,
        packet,
        100);

    EventPacket expected = new EventPacket(0);
    expected.append(1, 5, 233, true);
    expected.append(1 + 3 * 63 + 63 + 1 + 2, 7, 239, false);
    assertEquals(expected, packet);
    assertEquals(2, violations.count(Violation.OTHER_DATA));
  }

  @Test
  void atisRecordingMatchesTheReaderOfItsAuthors() throws IOException {
    Path file = Recorded.file("atis.es");
    byte[] bytes = Files.readAllBytes(file);
    ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).position(20);
    EventPacket all = new EventPacket(0);
    new EventStreamDecoder(EventStreamDecoder.StreamKind.ATIS, SENSOR, true, new ViolationCounts())
        .decode(in, 20, all, 2_000_000);
    StreamRecorder recorder = new StreamRecorder();
    recorder.packet(all);
    assertEquals(1_326_017, all.size());
    assertEquals("b15ceb61", recorder.crc32(SENSOR));

    try (RecordingReader reader = Recordings.open(file)) {
      StreamRecorder stream = read(reader);
      assertEquals(SENSOR, reader.geometry());
      assertEquals(
          1_326_017,
          stream.events().size() + reader.violations().count(Violation.OTHER_DATA),
          "every event is a pixel event or an exposure");
      assertTrue(stream.events().size() > 400_000);
      assertEquals(0, stream.events().firstTimeUs());
      assertEquals(999_000, stream.events().lastTimeUs());
    }
  }

  @Test
  void genericRecordingHasNoPixelEvents() throws IOException {
    try (RecordingReader reader = Recordings.open(Recorded.file("generic.es"))) {
      assertEquals(0, read(reader).events().size());
      assertEquals(List.of(), reader.segments());
      assertEquals(70, reader.violations().count(Violation.OTHER_DATA));
      assertEquals(1, reader.remarks().size());
      assertEquals(0, reader.violations().count(Violation.IMPOSSIBLE_LENGTH));
      assertEquals(0, reader.violations().count(Violation.CUT_OFF));
    }
  }

  @Test
  void messagesWithFalseLengthsTakeNoMemory() throws IOException {
    byte[] head = Arrays.copyOf("Event Stream\2\0\0\0".getBytes("ISO-8859-1"), 16);
    int[][] messages = {
      {5, 0x0a, 1, 2, 3, 4, 5, 6, 0x0a, 1, 2, 3, 4, 5}, // two true ones
      {5, 0xff, 0xff, 0xff, 0xff, 0x0e, 1}, // 2 GB that are not there
      {5, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1}, // a length without end
      {5, 0xff, 0xff}
    };
    Violation[] found = {
      Violation.OTHER_DATA, Violation.CUT_OFF, Violation.IMPOSSIBLE_LENGTH, Violation.CUT_OFF
    };
    for (int i = 0; i < messages.length; i++) {
      Path file = folder.resolve("generic-" + i);
      byte[] bytes = Arrays.copyOf(head, head.length + messages[i].length);
      System.arraycopy(bytes(messages[i]), 0, bytes, head.length, messages[i].length);
      ReplacedFile.write(file, bytes);
      try (RecordingReader reader = Recordings.open(file)) {
        read(reader);
        assertTrue(reader.violations().count(found[i]) > 0, reader.violations().describe() + "");
      }
    }
  }

  @Test
  void colourEventsAreNotRead() throws IOException {
    Path file = folder.resolve("colour.es");
    byte[] head = "Event Stream\2\0\0\4\12\0\12\0".getBytes("ISO-8859-1");
    byte[] bytes = Arrays.copyOf(head, head.length + 9);
    System.arraycopy(bytes(0xff, 1, 2, 0, 3, 0, 9, 9, 9), 0, bytes, head.length, 9);
    Files.write(file, bytes);
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(0, read(reader).events().size());
      assertEquals(1, reader.violations().count(Violation.OTHER_DATA));
    }
  }

  @Test
  void startsBeyondTheClockRangeAreShiftedToZeroAndReported() throws IOException {
    for (long startUs : new long[] {-5, 1_718_925_184_590_631L}) {
      EventPacket written = EventPackets.uniform(SENSOR, 1, 1000, startUs, 30);
      Path file = folder.resolve("start" + startUs + ".es");
      try (RecordingWriter writer = format().create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
        writer.write(written);
        writer.finish();
        assertEquals(
            List.of(
                "the format's clock starts at 0: all times read back "
                    + (startUs < 0 ? "larger by 5 us" : "smaller by 1718925184590631 us")),
            writer.losses());
      }
      try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT)) {
        assertEquals(EventPackets.shifted(written, -startUs), read(reader).events());
      }
    }
  }

  @Test
  void eventsOutsideTheSensorAreSkippedAndReported() throws IOException {
    EventPacket written = new EventPacket(0);
    written.append(500, 320, 0, true);
    written.append(600, 319, 239, true);
    written.append(700, 0, 240, true);
    Path file = folder.resolve("outside.es");
    try (RecordingWriter writer = format().create(file, WriteOptions.of(SENSOR)).orElseThrow()) {
      writer.write(written);
      writer.finish();
      assertEquals(List.of("2 events outside of 320x240 were left out"), writer.losses());
    }
    try (RecordingReader reader = format().open(file, ReadOptions.DEFAULT)) {
      assertEquals(EventPackets.part(written, 1, 2), read(reader).events());
    }
  }

  @Test
  void unknownVersionIsRejected() throws IOException {
    Path file = folder.resolve("version.es");
    Files.write(file, "Event Stream\3\0\0\1\12\0\12\0".getBytes("ISO-8859-1"));
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains("version 3"), refused.getMessage());
  }
}
