package haltere.core.format.internal.aedat2;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;

/** AEDAT-2.0 keeps the contract of all formats, and jAER reads its files. */
class Aedat2FormatTest extends RecordingFormatContract {
  private static final SensorGeometry DAVIS346 = new SensorGeometry(346, 260);

  @Override
  protected RecordingFormat format() {
    return new Aedat2Format();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(
        new SensorGeometry(128, 128),
        new SensorGeometry(240, 180),
        DAVIS346,
        new SensorGeometry(1, 1),
        new SensorGeometry(100, 200),
        new SensorGeometry(1024, 512));
  }

  @Override
  protected long earliestUs() {
    return Integer.MIN_VALUE;
  }

  @Override
  protected long latestUs() {
    return Integer.MAX_VALUE;
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    String text = new String(file, StandardCharsets.ISO_8859_1);
    List<byte[]> lies = new ArrayList<>();
    for (String lie :
        List.of(
            "Haltere sensor: 0x0",
            "Haltere sensor: 99999x99999",
            "Haltere sensor: -1x5",
            "Haltere sensor: 3x3",
            "Haltere time base: 99999999999999999999 us",
            "Haltere time base: 9223372036854775807 us",
            "Haltere time base: -9223372036854775808 us")) {
      lies.add(
          text.replace("Haltere sensor: 128x128", lie)
              .replace("# AEChip: ch.unizh.ini.jaer.chip.retina.DVS128\r\n", "")
              .getBytes(StandardCharsets.ISO_8859_1));
    }
    return lies;
  }

  private static EventPacket events(Path file) throws IOException {
    return events(file, ReadOptions.DEFAULT);
  }

  private static EventPacket events(Path file, ReadOptions options) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, options)) {
      reader.drainTo(recorder);
    }
    return recorder.events();
  }

  /** As jAER finds the first record: it counts characters and takes each line to end in CRLF. */
  private static int offsetThatJaerSees(byte[] file) {
    String[] lines = new String(file, StandardCharsets.UTF_8).split("\r\n", -1);
    int offset = 0;
    for (String line : lines) {
      assertTrue(line.startsWith("#"), line);
      offset += line.length() + 2;
      if (line.equals("#End Of ASCII Header")) {
        return offset;
      }
    }
    throw new AssertionError("no end line");
  }

  @Test
  void firstEventStartingWithANumberSignIsReadHereAndInJaer() throws IOException {
    EventPacket written = new EventPacket(3);
    written.append(5, 238, 0x23 << 2, true);
    written.append(6, 10, 0x23 << 2, false);
    written.append(7, 11, 3, false);
    Path file = folder.resolve("number-sign.aedat");
    write(file, new SensorGeometry(240, 180), written);

    byte[] bytes = Files.readAllBytes(file);
    int offset = offsetThatJaerSees(bytes);
    assertEquals('#', bytes[offset]);
    assertEquals(3 * 8, bytes.length - offset);
    assertEquals(written, events(file));
  }

  @Test
  void headerIsPlainAsciiWithCarriageReturns() throws IOException {
    Path file = folder.resolve("metadata.aedat");
    WriteOptions options =
        new WriteOptions(
            DAVIS346,
            false,
            Optional.empty(),
            Map.of("Place", "Zürich\r\n#End Of ASCII Header", "AEChip", "another.Chip"));
    EventPacket written = EventPackets.uniform(DAVIS346, 1, 100, 0, 20);
    try (RecordingWriter writer = new Aedat2Format().create(file, options).orElseThrow()) {
      writer.write(written);
      writer.finish();
    }

    byte[] bytes = Files.readAllBytes(file);
    int offset = offsetThatJaerSees(bytes);
    String header = new String(bytes, 0, offset, StandardCharsets.ISO_8859_1);
    assertEquals(100 * 8, bytes.length - offset);
    assertTrue(header.startsWith("#!AER-DAT2.0\r\n"));
    assertTrue(header.contains("# AEChip: eu.seebetter.ini.chips.davis.Davis346"), header);
    assertFalse(header.contains("another.Chip"));
    assertTrue(header.contains("# Place: Z?rich  #End Of ASCII Header\r\n"), header);
    assertEquals(written, events(file));
  }

  @Test
  void timesBeyond32BitsAreReadBack() throws IOException {
    Path file = folder.resolve("unix-time.aedat");
    EventPacket written =
        EventPackets.uniform(DAVIS346, 2, 1000, 1_718_925_184_590_631L, 10_000_000);
    write(file, DAVIS346, written);

    assertTrue(written.lastTimeUs() - written.firstTimeUs() > 1L << 33);
    assertEquals(written, events(file));
  }

  @Test
  void jumpsBeyondTheClockRangeAreReported() throws IOException {
    Path file = folder.resolve("leap.aedat");
    EventPacket written = new EventPacket(2);
    written.append(0, 1, 1, true);
    written.append(1L << 33, 1, 1, true);
    try (RecordingWriter writer =
        new Aedat2Format().create(file, WriteOptions.of(DAVIS346)).orElseThrow()) {
      writer.write(written);
      writer.finish();
      assertEquals(1, writer.losses().size());
      assertTrue(
          writer.losses().get(0).startsWith("1 jump of time does not fit"), writer.losses().get(0));
    }
  }

  @Test
  void eventOutsideTheSensorIsSkippedAndReported() throws IOException {
    Path file = folder.resolve("outside.aedat");
    EventPacket written = new EventPacket(3);
    written.append(0, 345, 259, true);
    written.append(1, 346, 0, true);
    written.append(2, 0, 260, true);
    try (RecordingWriter writer =
        new Aedat2Format().create(file, WriteOptions.of(DAVIS346)).orElseThrow()) {
      writer.write(written);
      writer.finish();
      assertEquals(List.of("2 events outside of 346x260 were left out"), writer.losses());
    }
    assertEquals(EventPackets.part(written, 0, 1), events(file));
  }

  @Test
  void oversizedSensorsAreRejected() {
    for (SensorGeometry sensor : List.of(new SensorGeometry(1025, 2), new SensorGeometry(2, 513))) {
      RecordingProblem refused =
          assertThrows(
              RecordingProblem.class,
              () ->
                  new Aedat2Format()
                      .create(folder.resolve("large.aedat"), WriteOptions.of(sensor)));
      assertTrue(refused.getMessage().contains("1024x512"), refused.getMessage());
    }
  }

  @Test
  void fileExtensionSelectsTheWrittenFormat() throws IOException {
    assertEquals("aedat2", Recordings.forWriting(Path.of("a.AEDAT")).name());
    assertEquals("csv", Recordings.forWriting(Path.of("a.csv")).name());
    RecordingProblem unknown =
        assertThrows(RecordingProblem.class, () -> Recordings.forWriting(Path.of("a.txt")));
    assertTrue(unknown.getMessage().contains(".aedat, .aedat4, .csv"), unknown.getMessage());
  }
}
