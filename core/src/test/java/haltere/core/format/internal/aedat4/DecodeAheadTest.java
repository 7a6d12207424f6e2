package haltere.core.format.internal.aedat4;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.ReplacedFile;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/** Decoding ahead on a second thread yields the same events. */
class DecodeAheadTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(346, 260, Origin.TOP);
  private static final int PACKETS = 60;
  private static final int EVENTS = 900;

  @TempDir Path folder;

  private final EventPacket events = EventPackets.uniform(SENSOR, 1, PACKETS * EVENTS, 1000, 20);

  private byte[] file(Aedat4Compression compression) throws IOException {
    Path file = folder.resolve("true.aedat4");
    try (Aedat4Writer writer =
        Aedat4Writer.create(file, WriteOptions.of(SENSOR).withOverwrite(true), compression)) {
      for (int i = 0; i < PACKETS; i++) {
        writer.write(EventPackets.part(events, i * EVENTS, (i + 1) * EVENTS));
        writer.writeThrough();
      }
      writer.finish();
    }
    return Files.readAllBytes(file);
  }

  @ParameterizedTest
  @EnumSource(
      value = Aedat4Compression.class,
      names = {"LZ4", "ZSTD"})
  void longRecordingIsReadFromAnyTime(Aedat4Compression compression) throws IOException {
    Path path = Files.write(folder.resolve("whole.aedat4"), file(compression));
    SplittableRandom random = new SplittableRandom(2);
    try (RecordingReader reader = Recordings.open(path)) {
      for (int i = 0; i < 30; i++) {
        long timeUs = random.nextLong(events.lastTimeUs());
        reader.seek(timeUs);
        StreamRecorder recorder = new StreamRecorder();
        for (int steps = random.nextInt(4); steps > 0; steps--) {
          reader.next(recorder);
        }
        reader.seek(timeUs);
        recorder = new StreamRecorder();
        reader.drainTo(recorder);
        int from = events.indexAtOrAfter(timeUs);
        assertEquals(EventPackets.part(events, from, events.size()), recorder.events());
      }
      assertEquals(List.of(), reader.violations().describe());
    }
  }

  @ParameterizedTest
  @EnumSource(
      value = Aedat4Compression.class,
      names = {"LZ4", "ZSTD"})
  void damageIsDetectedAnywhere(Aedat4Compression compression) throws IOException {
    byte[] bytes = file(compression);
    ByteBuffer numbers = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    int at = 18 + numbers.getInt(14);
    Path path = folder.resolve("damaged.aedat4");
    for (int packet = 0; packet < PACKETS; packet++) {
      int size = numbers.getInt(at + 4);
      byte[] damaged = bytes.clone();
      damaged[at + 8] ^= 1;
      boolean inHeader = packet % 2 == 0;
      damaged[at] ^= (byte) (inHeader ? 64 : 0);
      ReplacedFile.write(path, damaged);
      StreamRecorder recorder = new StreamRecorder();
      try (RecordingReader reader = Recordings.open(path)) {
        reader.drainTo(recorder);
        Violation kind = inHeader ? Violation.IMPOSSIBLE_LENGTH : Violation.DAMAGED_PACKET;
        assertEquals(1, reader.violations().count(kind), "packet " + packet);
      }
      EventPacket expected = EventPackets.part(events, 0, packet * EVENTS);
      expected.append(events, (packet + 1) * EVENTS, events.size());
      assertEquals(expected, recorder.events(), "packet " + packet);
      at += 8 + size;
    }
  }

  private static List<Thread> helpers() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(thread -> thread.getName().equals("haltere-decode"))
        .toList();
  }

  @Test
  void threadEndsWithTheReader() throws IOException, InterruptedException {
    Path path = Files.write(folder.resolve("threads.aedat4"), file(Aedat4Compression.LZ4));
    List<Thread> before = helpers();
    List<Thread> own;
    try (RecordingReader reader = Recordings.open(path)) {
      reader.next(new StreamRecorder());
      reader.next(new StreamRecorder());
      own = helpers().stream().filter(thread -> !before.contains(thread)).toList();
      assertEquals(Runtime.getRuntime().availableProcessors() > 1, !own.isEmpty());
    }
    for (Thread thread : own) {
      thread.join(10_000);
      assertFalse(thread.isAlive());
    }
  }

  @Test
  void interruptedReaderDoesNotWaitForTheThread() throws IOException {
    Path path = Files.write(folder.resolve("interrupt.aedat4"), file(Aedat4Compression.LZ4));
    try (RecordingReader reader = Recordings.open(path)) {
      reader.next(new StreamRecorder());
      Thread.currentThread().interrupt();
      StreamRecorder recorder = new StreamRecorder();
      try {
        reader.drainTo(recorder);
        assertEquals(events, recorder.events());
      } catch (IOException interrupted) {
        assertTrue(recorder.events().size() <= events.size());
      } finally {
        assertTrue(Thread.interrupted());
      }
    }
  }
}
