package haltere.core.format.internal.aedat3;

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
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.stream.StreamGrammar;
import haltere.testing.EventPackets;
import haltere.testing.RecordingFormatContract;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** AEDAT-3 keeps the contract of all formats; its files are made here, from the layout. */
class Aedat3FormatTest extends RecordingFormatContract {
  private static final SensorGeometry DAVIS240 = new SensorGeometry(240, 180, Origin.TOP);
  private static final int FRAME = 2;

  /** Puts a file together. */
  private static final class Builder {
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();

    Builder text(String text) {
      bytes.writeBytes(text.getBytes(StandardCharsets.ISO_8859_1));
      return this;
    }

    Builder header(String version, String source) {
      return text("#!AER-DAT" + version + "\r\n#Format: RAW\r\n#Source 1: " + source + "\r\n")
          .text("#Start-Time: 2016-02-12 17:52:12 (TZ+0100)\r\n#!END-HEADER\r\n");
    }

    Builder packet(int kind, int source, int eventBytes, int overflow, int number, int capacity) {
      bytes.writeBytes(
          ByteBuffer.allocate(PacketHeader.BYTES)
              .order(ByteOrder.LITTLE_ENDIAN)
              .putShort((short) kind)
              .putShort((short) source)
              .putInt(eventBytes)
              .putInt(4)
              .putInt(overflow)
              .putInt(capacity)
              .putInt(number)
              .putInt(number)
              .array());
      return this;
    }

    Builder event(int word, int time) {
      bytes.writeBytes(
          ByteBuffer.allocate(8).order(ByteOrder.LITTLE_ENDIAN).putInt(word).putInt(time).array());
      return this;
    }

    Builder zeros(int count) {
      bytes.writeBytes(new byte[count]);
      return this;
    }

    /** Packets of version 3.1 with at most so many events. */
    Builder events(SensorGeometry sensor, EventPacket events, int most) {
      int from = 0;
      while (from < events.size()) {
        int overflow = (int) (events.timeUs(from) >>> 31);
        int to = from;
        while (to < events.size() && to - from < most && events.timeUs(to) >>> 31 == overflow) {
          to++;
        }
        packet(PacketHeader.POLARITY, 1, 8, overflow, to - from, to - from);
        for (; from < to; from++) {
          int y = sensor.height() - 1 - events.y(from);
          int word = events.x(from) << 17 | y << 2 | (events.isOn(from) ? 2 : 0) | 1;
          event(word, (int) events.timeUs(from) & Integer.MAX_VALUE);
        }
      }
      return this;
    }

    byte[] toBytes() {
      return bytes.toByteArray();
    }
  }

  @Override
  protected RecordingFormat format() {
    return new Aedat3Format();
  }

  @Override
  protected List<SensorGeometry> sensors() {
    return List.of(DAVIS240, new SensorGeometry(1, 1), new SensorGeometry(32768, 32768));
  }

  @Override
  protected ReadOptions options(SensorGeometry sensor) {
    return ReadOptions.DEFAULT.withSensor(sensor);
  }

  @Override
  protected long earliestUs() {
    return 0;
  }

  @Override
  protected long latestUs() {
    return Long.MAX_VALUE >>> 1;
  }

  @Override
  protected void write(Path file, SensorGeometry sensor, EventPacket... packets)
      throws IOException {
    Builder builder = new Builder().header("3.1", sensor == DAVIS240 ? "DAVIS240C" : "unknown");
    for (EventPacket packet : packets) {
      builder.events(sensor, packet, 3000);
    }
    Files.write(file, builder.toBytes());
  }

  @Override
  protected List<byte[]> lyingFiles(byte[] file) {
    int packet = new String(file, StandardCharsets.ISO_8859_1).indexOf("END-HEADER\r\n") + 12;
    List<byte[]> lies = new ArrayList<>();
    for (int at = packet; at < packet + PacketHeader.BYTES; at++) {
      for (int lie : new int[] {0, 1, -1, 500, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28}) {
        byte[] copy = file.clone();
        ByteBuffer.wrap(copy).order(ByteOrder.LITTLE_ENDIAN).putInt(at, lie);
        lies.add(copy);
      }
    }
    return lies;
  }

  private StreamRecorder read(byte[] bytes, long others) throws IOException {
    Path file = Files.write(folder.resolve("made.aedat"), bytes);
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals("aedat3", reader.formatName());
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(others, reader.violations().count(Violation.OTHER_DATA));
    }
    return recorder;
  }

  @Test
  void otherPacketsAndInvalidEventsAreSkipped() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS240, 1, 900, 4_000, 30);
    byte[] bytes =
        new Builder()
            .header("3.1", "DAVIS240C")
            .packet(0, 1, 8, 0, 3, 3)
            .zeros(24)
            .events(DAVIS240, EventPackets.part(events, 0, 400), 100)
            .packet(FRAME, 1, 300_000, 0, 1, 2)
            .zeros(600_000)
            .packet(PacketHeader.POLARITY, 1, 8, 0, 1, 3)
            .event(2, 0)
            .zeros(16)
            .packet(PacketHeader.POLARITY, 2, 8, 0, 5, 5)
            .zeros(40)
            .packet(3, 1, 36, 0, 10, 10)
            .zeros(360)
            .events(DAVIS240, EventPackets.part(events, 400, 900), 100)
            .toBytes();
    assertEquals(events, read(bytes, 3 + 1 + 1 + 5 + 10).events());
  }

  @Test
  void version30HasAnotherAddressLayout() throws IOException {
    byte[] bytes =
        new Builder()
            .text("#!AER-DAT3.0\n#Format: RAW\n#Source 0: DVS128\n")
            .packet(PacketHeader.POLARITY, 0, 8, 2, 2, 2)
            .event(127 << 18 | 1 << 4 | 2 | 1, 7)
            .event(3 << 18 | 127 << 4 | 1, 8)
            .toBytes();
    EventPacket expected = new EventPacket(2);
    expected.append((2L << 31) + 7, 127, 126, true);
    expected.append((2L << 31) + 8, 3, 0, false);
    assertEquals(expected, read(bytes, 0).events());
  }

  @Test
  void sizeOfAnUnknownCameraFollowsFromItsEvents() throws IOException {
    byte[] bytes =
        new Builder()
            .header("3.1", "Something")
            .packet(PacketHeader.POLARITY, 0, 8, 0, 2, 2)
            .event(9 << 17 | 4 << 2 | 1, 7)
            .event(3 << 17 | 19 << 2 | 1, 8)
            .toBytes();
    Path file = Files.write(folder.resolve("unknown.aedat"), bytes);
    try (RecordingReader reader = Recordings.open(file)) {
      assertEquals(new SensorGeometry(10, 20, Origin.TOP), reader.geometry());
      assertTrue(reader.remarks().get(0).contains("10x20"), reader.remarks().toString());
    }
  }

  @Test
  void compressedPacketsAreRejected() throws IOException {
    byte[] bytes = new Builder().text("#!AER-DAT3.1\n#Format: PNGFrames\n#!END-HEADER\n").toBytes();
    Path file = Files.write(folder.resolve("packed.aedat"), bytes);
    RecordingProblem refused =
        assertThrows(RecordingProblem.class, () -> Recordings.open(file).close());
    assertTrue(refused.getMessage().contains("PNGFrames"), refused.getMessage());
  }

  @Test
  void packetAfterADamagedHeaderIsFound() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS240, 2, 300, 4_000, 30);
    byte[] bytes = new Builder().header("3.1", "DAVIS240C").events(DAVIS240, events, 100).toBytes();
    int second = bytes.length - 2 * (28 + 800);
    bytes[second + 5] = 77;
    Path file = Files.write(folder.resolve("damaged.aedat"), bytes);
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(1, reader.violations().count(Violation.IMPOSSIBLE_LENGTH));
      assertEquals(second, reader.violations().firstOffset(Violation.IMPOSSIBLE_LENGTH));
    }
    EventPacket expected = EventPackets.part(events, 0, 100);
    expected.append(events, 200, 300);
    assertEquals(expected, recorder.events());
  }

  @Test
  void damagedFilesAreReadOrRejected() throws IOException {
    EventPacket events = EventPackets.uniform(DAVIS240, 3, 150, 4_000, 30);
    byte[] whole = new Builder().header("3.1", "DAVIS240C").events(DAVIS240, events, 30).toBytes();
    int header = whole.length - 150 * 8 - 5 * 28;
    SplittableRandom random = new SplittableRandom(8);
    Path file = folder.resolve("fuzz.aedat");
    for (int i = 0; i < 2000; i++) {
      byte[] bytes = whole.clone();
      int first = bytes.length;
      for (int flips = 1 + random.nextInt(6); flips > 0; flips--) {
        int at = random.nextInt(bytes.length);
        bytes[at] ^= (byte) (1 << random.nextInt(8));
        first = Math.min(first, at);
      }
      if (random.nextInt(3) == 0) {
        first = random.nextInt(bytes.length);
        bytes = Arrays.copyOf(whole, first);
      }
      ReplacedFile.write(file, bytes);
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          new Aedat3Format().open(file, options(DAVIS240).withPacketEvents(40))) {
        reader.drainTo(new StreamGrammar(recorder));
        reader.seek(5_000);
      } catch (RecordingProblem problem) {
        assertTrue(first < header, problem.getMessage());
      }
      int sound = Math.max(0, (first - header) / (28 + 240) * 30);
      assertTrue(recorder.events().size() >= sound, "case " + i);
      assertEquals(
          EventPackets.part(events, 0, sound),
          EventPackets.part(recorder.events(), 0, sound),
          "case " + i);
    }
  }
}
