package haltere.testing.peers;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.InertialSample;
import haltere.core.event.Origin;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import haltere.core.event.Trigger;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.testing.EventPackets;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * dv-processing and aedat read every event of what we write, and we of what dv-processing writes.
 * Skipped without them, see {@link PythonPrograms}.
 */
class Aedat4PeersTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260, Origin.TOP);
  private static final int EVENTS = 30_000;

  @TempDir Path folder;
  private PythonPrograms programs;

  @BeforeEach
  void findPeers() throws IOException {
    programs = PythonPrograms.orSkip("aedat4.py", folder);
  }

  private static EventPacket events() {
    return EventPackets.uniform(SENSOR, 11, EVENTS, 1_718_925_184_590_631L, 15);
  }

  private static StreamRecorder record(EventPacket events) {
    StreamRecorder recorder = new StreamRecorder();
    recorder.packet(events);
    return recorder;
  }

  @Test
  void writtenEventsAreReadByTwoOtherPrograms() throws IOException {
    EventPacket events = events();
    List<String> command = new ArrayList<>(List.of("read"));
    List<String> expected = new ArrayList<>();
    String facts = " " + EVENTS + " " + record(events).crc32(SENSOR);
    for (Aedat4Compression compression : Aedat4Compression.values()) {
      Path file = folder.resolve("ours-" + compression + ".aedat4");
      try (RecordingWriter writer =
          Aedat4Writer.create(file, WriteOptions.of(SENSOR), compression)) {
        for (EventPacket part : EventPackets.cut(events, 3)) {
          writer.write(part);
        }
        writer.finish();
      }
      command.add(file.toString());
      expected.add("dv-processing" + facts);
      expected.add("aedat" + facts);
    }
    assertEquals(Optional.of(expected), programs.run(command.toArray(String[]::new)));
  }

  @Test
  void writtenFramesSamplesAndTriggersAreReadByTwoOtherPrograms() throws IOException {
    Path file = folder.resolve("readings.aedat4");
    WriteOptions options = WriteOptions.of(SENSOR).withSamples(EnumSet.allOf(SampleKind.class));
    List<String> expected = new ArrayList<>();
    try (RecordingWriter writer = Aedat4Writer.create(file, options, Aedat4Compression.LZ4)) {
      EventPacket events = events();
      for (int i = 0; i < 300; i++) {
        long timeUs = events.firstTimeUs() + 1000L * i;
        writer.write(
            EventPackets.part(
                events, events.indexAtOrAfter(timeUs - 1000), events.indexAtOrAfter(timeUs)));
        expected.add(writeSample(writer, timeUs, i));
        if (i % 10 == 0) {
          expected.add(writeFrame(writer, timeUs, i));
          expected.add(writeTrigger(writer, timeUs, i % 20 == 0));
        }
      }
      assertEquals(List.of(), writer.losses());
      writer.finish();
    }
    List<String> lines = programs.run("readings", file.toString()).orElseThrow();
    for (String program : List.of("dv-processing ", "aedat ")) {
      List<String> seen =
          lines.stream()
              .filter(line -> line.startsWith(program))
              .map(line -> line.substring(program.length()))
              .sorted()
              .toList();
      assertEquals(expected.stream().sorted().toList(), seen, program);
    }
  }

  private static String crc32(byte[] bytes) {
    CRC32 crc = new CRC32();
    crc.update(bytes);
    return String.format("%08x", crc.getValue());
  }

  private static String writeSample(RecordingWriter writer, long timeUs, int number)
      throws IOException {
    ByteBuffer values = ByteBuffer.allocate(40).order(ByteOrder.LITTLE_ENDIAN);
    float[] v = new float[10];
    for (int i = 0; i < v.length; i++) {
      v[i] = number / 8f + i;
      values.putFloat(v[i]);
    }
    writer.write(
        new InertialSample(timeUs, v[0], v[1], v[2], v[3], v[4], v[5], v[6], v[7], v[8], v[9]));
    return "sample " + timeUs + " " + crc32(values.array());
  }

  private static String writeTrigger(RecordingWriter writer, long timeUs, boolean rising)
      throws IOException {
    Trigger.Edge edge = rising ? Trigger.Edge.RISING : Trigger.Edge.FALLING;
    writer.write(new Trigger(timeUs, Trigger.Source.EXTERNAL_INPUT, edge, 0));
    return "trigger " + timeUs + (rising ? " 1" : " 2");
  }

  /** A grey picture of a part of the sensor; the rows of the other programs count from the top. */
  private static String writeFrame(RecordingWriter writer, long timeUs, int number)
      throws IOException {
    int width = 300 - number / 2;
    int height = 200 + number / 6;
    byte[] rows = new byte[width * height];
    new SplittableRandom(number).nextBytes(rows);
    writer.write(
        new Frame(
            new Frame.Times(timeUs, timeUs + 700, timeUs - 100, timeUs + 900),
            number / 10,
            4,
            width,
            height,
            1,
            Frame.Depth.UNSIGNED_8,
            rows));
    int top = SENSOR.height() - 4 - height;
    String place = number / 10 + " " + top + " " + width + " " + height;
    return "frame " + timeUs + " 700 " + place + " " + crc32(rows);
  }

  @Test
  void completePacketsOfAnInterruptedRecordingAreReadByOtherPrograms() throws IOException {
    EventPacket events = events();
    int whole = 20_000;
    String facts = " " + whole + " " + record(EventPackets.part(events, 0, whole)).crc32(SENSOR);
    List<String> command = new ArrayList<>(List.of("read-cut"));
    List<String> expected = new ArrayList<>();
    for (Aedat4Compression compression : Aedat4Compression.values()) {
      Path file = folder.resolve("killed-" + compression + ".aedat4");
      byte[] bytes;
      try (Aedat4Writer writer =
          Aedat4Writer.createInPlace(file, WriteOptions.of(SENSOR), compression)) {
        for (int from = 0; from < EVENTS; from += 5000) {
          writer.write(EventPackets.part(events, from, from + 5000));
          writer.writeThrough();
        }
        bytes = Files.readAllBytes(file);
      }
      // Two packets of six are left out, the second but for its first part.
      int end = (int) (bytes.length - 1.5 * (bytes.length - 2000) / 6);
      ReplacedFile.write(file, Arrays.copyOf(bytes, end));
      command.add(file.toString());
      expected.add("dv-processing" + facts);
      expected.add("aedat" + facts);
    }
    assertEquals(Optional.of(expected), programs.run(command.toArray(String[]::new)));
  }

  @Test
  void eventsOfAnotherProgramAreRead() throws IOException {
    EventPacket events = events();
    ByteBuffer rows = ByteBuffer.allocate(EVENTS * 32).order(ByteOrder.LITTLE_ENDIAN);
    for (int i = 0; i < EVENTS; i++) {
      rows.putLong(events.timeUs(i)).putLong(events.x(i));
      rows.putLong(SENSOR.height() - 1 - events.y(i)).putLong(events.isOn(i) ? 1 : 0);
    }
    Path raw = Files.write(folder.resolve("events.bin"), rows.array());
    String target = folder.resolve("theirs").toString();
    assertTrue(programs.run("write", raw.toString(), "346", "260", target).isPresent());
    for (Aedat4Compression compression : Aedat4Compression.values()) {
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          Recordings.open(Path.of(target + "-" + compression + ".aedat4"))) {
        assertEquals(SENSOR, reader.geometry());
        reader.drainTo(recorder);
        assertEquals(List.of(), reader.violations().describe());
      }
      assertEquals(events, recorder.events(), compression.toString());
    }
  }
}
