package haltere.core.format.internal.aedat4;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Frame;
import haltere.core.event.Origin;
import haltere.core.event.SampleKind;
import haltere.core.event.SensorGeometry;
import haltere.core.event.SensorSample;
import haltere.core.event.Trigger;
import haltere.core.format.ProgressListener;
import haltere.core.format.RandomSamples;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.SampleCounts;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.compression.DamagedPacketException;
import haltere.core.format.internal.compression.LittleEndian;
import haltere.core.pipeline.Conversion;
import haltere.testing.EventPackets;
import haltere.testing.Recorded;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Samples are read back from AEDAT-4 unchanged. */
class Aedat4SamplesTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(24, 17, Origin.TOP);
  private static final WriteOptions ALL =
      WriteOptions.of(SENSOR).withSamples(EnumSet.allOf(SampleKind.class));

  @TempDir Path folder;

  private static StreamRecorder read(Path file) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSamples(true))) {
      reader.drainTo(recorder);
      assertEquals(0, reader.violations().count(Violation.INCOMPLETE_SAMPLE));
    }
    return recorder;
  }

  private static List<SensorSample> samples(StreamRecorder stream) {
    return stream.placedSamples().stream().map(StreamRecorder.Read::sample).toList();
  }

  /** Writes both in the order of their times, in packets of a few hundred events. */
  private static void write(RecordingWriter writer, EventPacket events, List<SensorSample> rest)
      throws IOException {
    int from = 0;
    for (SensorSample sample : rest) {
      int to = events.indexAtOrAfter(sample.timeUs());
      writer.write(EventPackets.part(events, from, to));
      from = to;
      assertTrue(writer.write(sample));
    }
    writer.write(EventPackets.part(events, from, events.size()));
  }

  @ParameterizedTest
  @EnumSource
  void samplesOfAllKindsAreReadBackUnchanged(Aedat4Compression compression) throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 3, 30_000, 1_000_000, 100);
    List<SensorSample> samples = new RandomSamples(SENSOR, 4).all(1500, 900_000, 2000);
    Path file = folder.resolve("all.aedat4");
    try (RecordingWriter writer = Aedat4Writer.create(file, ALL, compression)) {
      write(writer, events, samples);
      assertEquals(List.of(), writer.losses());
      writer.finish();
    }

    StreamRecorder stream = read(file);

    assertEquals(events, stream.events());
    assertEquals(samples, samples(stream));
    for (StreamRecorder.Read read : stream.placedSamples()) {
      assertEquals(events.indexAtOrAfter(read.sample().timeUs()), read.eventsBefore());
    }
  }

  @ParameterizedTest
  @ValueSource(longs = {0, 1, 300_000, 899_999})
  void seekYieldsSamplesStoredBeforeTheOnlyEventPacket(long fromUs) throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 3, 30, 1_000_000, 100);
    List<SensorSample> samples = new RandomSamples(SENSOR, 4).all(50, 900_000, 2000);
    Path file = folder.resolve("slow.aedat4");
    try (RecordingWriter writer = Aedat4Writer.create(file, ALL, Aedat4Compression.NONE)) {
      for (SensorSample sample : samples) {
        assertTrue(writer.write(sample));
      }
      writer.write(events);
      writer.finish();
    }
    StreamRecorder from = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file, ReadOptions.DEFAULT.withSamples(true))) {
      reader.seek(fromUs);
      reader.drainTo(from);
    }
    assertEquals(
        samples.stream().filter(sample -> sample.timeUs() >= fromUs).toList(), samples(from));
  }

  @Test
  void davisRecordingIsUnchangedByAConversion() throws IOException {
    Path original = Recorded.file("davis346-events-frames-imu.aedat4");
    Path copy = folder.resolve("copy.aedat4");
    ReadOptions options = ReadOptions.DEFAULT.withSamples(true);
    try (RecordingReader reader = Recordings.open(original, options);
        RecordingWriter writer =
            new Aedat4Format()
                .create(copy, WriteOptions.of(reader.geometry()).withSamples(ALL.samples()))
                .orElseThrow()) {
      Conversion.Result result =
          new Conversion(Long.MIN_VALUE, Long.MAX_VALUE, Optional.empty(), ProgressListener.NONE)
              .run(reader, writer);
      assertEquals(new SampleCounts(59, 2363, 236), result.samplesWritten());
      assertEquals(List.of(), result.warnings());
    }
    StreamRecorder before = read(original);
    StreamRecorder after = read(copy);
    assertEquals(before.events(), after.events());
    // Of samples at the same time the order is not told.
    for (SampleKind kind : SampleKind.values()) {
      assertEquals(placed(before, kind), placed(after, kind));
    }
  }

  private static List<StreamRecorder.Read> placed(StreamRecorder stream, SampleKind kind) {
    return stream.placedSamples().stream().filter(one -> one.sample().kind() == kind).toList();
  }

  @Test
  void kindsMissingInTheHeaderAreRejected() throws IOException {
    RandomSamples random = new RandomSamples(SENSOR, 5);
    Path file = folder.resolve("some.aedat4");
    try (RecordingWriter writer =
        Aedat4Writer.create(
            file,
            WriteOptions.of(SENSOR).withSamples(Set.of(SampleKind.TRIGGER)),
            Aedat4Compression.LZ4)) {
      assertFalse(writer.write(random.frame(1)));
      assertFalse(writer.write(random.sample(1)));
      assertTrue(writer.write(random.edge(1, 1)));
      assertFalse(writer.write(new Trigger(1, Trigger.Source.CLOCK_RESET, Trigger.Edge.RISING, 0)));
      assertTrue(
          writer.write(new Trigger(1, Trigger.Source.EXTERNAL_INPUT, Trigger.Edge.RISING, 2)));
      assertEquals(
          List.of("1 triggers are of other inputs than the first, which the format does not store"),
          writer.losses());
      writer.finish();
    }
    assertEquals(2, read(file).samples(Trigger.class).size());
  }

  @Test
  void recordingsInPlaceContainTheirSamplesAtAnyTime() throws IOException {
    Path file = folder.resolve("open.aedat4");
    List<SensorSample> samples = new RandomSamples(SENSOR, 6).all(50, 0, 100);
    try (Aedat4Writer writer = Aedat4Writer.createInPlace(file, ALL, Aedat4Compression.LZ4)) {
      write(writer, new EventPacket(0), samples);
      writer.writeThrough();
      assertEquals(samples, samples(read(file)));
    }
  }

  @Test
  void halfPrecisionFrameIsRead() throws DamagedPacketException {
    Frame frame =
        new Frame(new Frame.Times(7, 8), 0, 0, 2, 3, 1, Frame.Depth.UNSIGNED_16, halves());
    byte[][] written = new byte[1][];
    SamplePackets packets =
        new SamplePackets(
            3,
            Set.of(SampleKind.FRAME),
            (stream, payload, elements, firstUs, lastUs) -> written[0] = payload);
    try {
      assertTrue(packets.add(frame));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
    written[0][44 + 16] = 7;
    List<SensorSample> found = new ArrayList<>();
    new SamplePayload(3, false).read(SamplePayload.FRAME, written[0], 0, written[0].length, found);
    Frame read = (Frame) found.get(0);
    assertEquals(Frame.Depth.FLOAT_32, read.depth());
    double[] values = new double[6];
    for (int i = 0; i < 6; i++) {
      values[i] = read.value(i % 2, 2 - i / 2, 0);
    }
    assertArrayEquals(
        new double[] {1, -2, 65504, Math.scalb(1.0, -24), Double.POSITIVE_INFINITY, 0.333251953125},
        values);
  }

  private static byte[] halves() {
    int[] bits = {0x3c00, 0xc000, 0x7bff, 0x0001, 0x7c00, 0x3555};
    byte[] bytes = new byte[12];
    for (int i = 0; i < bits.length; i++) {
      LittleEndian.putShort(bytes, 2 * i, bits[i]);
    }
    return bytes;
  }

  @Test
  void damagedSamplesDoNotPreventOthers() throws IOException {
    Path file = folder.resolve("whole.aedat4");
    List<SensorSample> samples = new RandomSamples(SENSOR, 7).all(60, 0, 100);
    try (RecordingWriter writer = Aedat4Writer.create(file, ALL, Aedat4Compression.NONE)) {
      write(writer, new EventPacket(0), samples);
      writer.finish();
    }
    byte[] whole = Files.readAllBytes(file);
    SplittableRandom random = new SplittableRandom(8);
    Path damaged = folder.resolve("damaged.aedat4");
    int given = 0;
    for (int round = 0; round < 300; round++) {
      byte[] bytes = whole.clone();
      for (int i = 0; i < 4; i++) {
        bytes[random.nextInt(2500, bytes.length)] ^= (byte) (1 << random.nextInt(8));
      }
      ReplacedFile.write(damaged, round % 3 == 0 ? Arrays.copyOf(bytes, bytes.length / 2) : bytes);
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader =
          Recordings.open(damaged, ReadOptions.DEFAULT.withSamples(true))) {
        reader.drainTo(recorder);
      }
      given += recorder.placedSamples().size();
    }
    assertTrue(given > 300 * 20, given + " samples of " + 300 * 60);
  }
}
