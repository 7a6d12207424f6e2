package haltere.core.format.internal.dat;

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
import haltere.core.format.WriteOptions;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.StreamRecorder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** DAT keeps the contract of all formats and reports times beyond its clock. */
class DatFormatTest extends RecordingFormatContract {
  private static final SensorGeometry GEN4 = new SensorGeometry(1280, 720, Origin.TOP);

  @Override
  protected RecordingFormat format() {
    return new DatFormat();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(GEN4, new SensorGeometry(1, 1), new SensorGeometry(16384, 16384));
  }

  @Override
  protected long earliestUs() {
    return 0;
  }

  @Override
  protected long latestUs() {
    return 0xffffffffL;
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    String text = new String(file, StandardCharsets.ISO_8859_1);
    List<String> lies = new ArrayList<>();
    for (String width : List.of("0", "99999", "99999999999", "-1", "3", "x")) {
      lies.add(text.replace("Width 1280", "Width " + width));
    }
    lies.add(text.replaceFirst("\n\f\b", "\n\f\t"));
    lies.add(text.replaceFirst("\n\f\b", "\n\f\0"));
    lies.add(text.replaceFirst("\n\f\b", "\n\u000e\b"));
    lies.add(text.replace("% Width", "% " + DatFormat.TIME_BASE + " 9223372036854775807\n% Width"));
    return lies.stream().map(lie -> lie.getBytes(StandardCharsets.ISO_8859_1)).toList();
  }

  private static StreamRecorder read(Path file) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(new StreamGrammar(recorder));
    }
    return recorder;
  }

  private List<String> losses(Path file, EventPacket... packets) throws IOException {
    try (RecordingWriter writer = format().create(file, WriteOptions.of(GEN4)).orElseThrow()) {
      for (EventPacket packet : packets) {
        writer.write(packet);
      }
      writer.finish();
      return writer.losses();
    }
  }

  private static byte[] file(String header, int kind, int... words) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.writeBytes(header.getBytes(StandardCharsets.US_ASCII));
    out.write(kind);
    out.write(8);
    ByteBuffer records = ByteBuffer.allocate(4 * words.length).order(ByteOrder.LITTLE_ENDIAN);
    for (int word : words) {
      records.putInt(word);
    }
    out.writeBytes(records.array());
    return out.toByteArray();
  }

  @Test
  void timesBeyond32BitsAreReadBackAndReported() throws IOException {
    for (long startUs : new long[] {1_718_925_184_590_631L, -5_000_000_000L, 4_294_967_290L}) {
      Path file = folder.resolve("long" + startUs + ".dat");
      EventPacket written = EventPackets.uniform(GEN4, 1, 3000, startUs, 5_000_000);
      List<String> losses = losses(file, written);

      assertEquals(1, losses.size(), losses.toString());
      assertTrue(losses.get(0).contains("32 bits"), losses.get(0));
      assertEquals(written, read(file).events());
    }
  }

  @Test
  void jumpsBeyondTheClockRangeAreReported() throws IOException {
    EventPacket written = new EventPacket(0);
    written.append(5, 1, 1, true);
    written.append(5 + (3L << 32), 1, 1, true);
    written.append(6 + (3L << 32), 1, 1, true);
    List<String> losses = losses(folder.resolve("leap.dat"), written);

    assertEquals(2, losses.size(), losses.toString());
    assertTrue(losses.get(1).startsWith("1 jump of time does not fit"), losses.get(1));
    assertEquals(3, read(folder.resolve("leap.dat")).events().size());
  }

  @Test
  void clockWrapsAndRestarts() throws IOException {
    Path file = folder.resolve("wrap.dat");
    Files.write(
        file,
        file(
            "% Version 2\n% Width 10\n% Height 10\n",
            0x0c, -2, 0, 3, 1 << 28, 2_000_000, 2, 500_000, 3));
    StreamRecorder stream = read(file);

    assertEquals(0xfffffffeL, stream.events().timeUs(0));
    assertEquals((1L << 32) + 3, stream.events().timeUs(1));
    assertTrue(stream.events().isOn(1));
    assertEquals((1L << 32) + 2_000_000, stream.events().timeUs(2));
    assertEquals(500_000, stream.events().timeUs(3));
    assertEquals(1, stream.notifications(Reset.class).size());
  }

  @Test
  void version1HasNarrowerFields() throws IOException {
    Path file = folder.resolve("old.dat");
    Files.write(file, file("% Version 1\n", 0, 7, 303 | 239 << 9 | 1 << 17, 8, 5 | 1 << 9, 9, 304));
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(new SensorGeometry(640, 480, Origin.TOP), reader.geometry());
    }
    try (RecordingReader reader =
        Recordings.open(file, ReadOptions.DEFAULT.withSensor(new SensorGeometry(304, 240)))) {
      StreamRecorder stream = new StreamRecorder();
      reader.drainTo(stream);
      EventPacket expected = new EventPacket(0);
      expected.append(7, 303, 0, true);
      expected.append(8, 5, 238, false);
      assertEquals(expected, stream.events());
      assertEquals(1, reader.violations().count(Violation.OUTSIDE_SENSOR));
    }
  }

  @Test
  void triggerFileIsRejected() throws IOException {
    Path file = folder.resolve("triggers.dat");
    Files.write(file, file("% Version 2\n% Width 10\n% Height 10\n", 0x0e, 1, 1));
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains("byte 35"), refused.getMessage());
    assertTrue(refused.getMessage().contains("14"), refused.getMessage());
  }

  @Test
  void oversizedSensorsAreRejected() {
    assertThrows(
        RecordingProblem.class,
        () ->
            format()
                .create(
                    folder.resolve("large.dat"), WriteOptions.of(new SensorGeometry(16385, 2))));
  }

  @Test
  void eventsOutsideTheSensorAreSkippedAndReported() throws IOException {
    EventPacket written = new EventPacket(0);
    written.append(0, 1279, 719, true);
    written.append(1, 1280, 0, true);
    written.append(2, 0, 720, true);
    assertEquals(
        List.of("2 events outside of 1280x720 were left out"),
        losses(folder.resolve("outside.dat"), written));
  }
}
