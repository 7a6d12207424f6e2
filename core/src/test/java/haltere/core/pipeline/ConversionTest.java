package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ProgressListener;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.testing.EventPackets;
import haltere.testing.RecordedPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Copies of recordings, whole or in part, through a chain or not. */
class ConversionTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(240, 180);

  @TempDir Path folder;

  private static Conversion copy(long fromUs, long toUs) {
    return new Conversion(fromUs, toUs, Optional.empty(), ProgressListener.NONE);
  }

  private static Conversion copyAll(StreamHandler stage) {
    return new Conversion(
        Long.MIN_VALUE, Long.MAX_VALUE, Optional.of(stage), ProgressListener.NONE);
  }

  private RecordingWriter writer(Path file) throws IOException {
    return Recordings.forWriting(file).create(file, WriteOptions.of(SENSOR)).orElseThrow();
  }

  private Path write(String name, EventPacket... packets) throws IOException {
    Path file = folder.resolve(name);
    try (RecordingWriter writer = writer(file)) {
      for (EventPacket packet : packets) {
        writer.write(packet);
      }
      writer.finish();
    }
    return file;
  }

  private static StreamRecorder read(Path file) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(recorder);
    }
    return recorder;
  }

  static List<RecordedPackets> recordings() {
    return RecordedPackets.aedat();
  }

  @ParameterizedTest
  @MethodSource("recordings")
  void copyOfARecordingContainsTheSameEvents(RecordedPackets facts) throws IOException {
    Path target = folder.resolve(facts.file() + ".copy.aedat");
    try (RecordingReader reader = facts.open();
        RecordingWriter writer =
            Recordings.forWriting(target)
                .create(target, WriteOptions.of(reader.geometry()))
                .orElseThrow()) {
      Conversion.Result result = copy(Long.MIN_VALUE, Long.MAX_VALUE).run(reader, writer);
      assertEquals(facts.events(), result.eventsRead());
      assertEquals(facts.events(), result.eventsWritten());
    }
    assertEquals(facts.crc32(), read(target).crc32(), facts.file());
  }

  @Test
  void stagesProcessCopiedEventsAndReceiveAllNotifications() throws IOException {
    Path source = write("source.aedat", EventPackets.uniform(SENSOR, 1, 20_000, 0, 10));
    Path target = folder.resolve("target.aedat");
    StreamRecorder heard = new StreamRecorder();
    StreamHandler onlyOn =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            int kept = 0;
            for (int i = 0; i < packet.size(); i++) {
              if (packet.isOn(i)) {
                packet.move(i, kept++);
              }
            }
            packet.truncate(kept);
            heard.packet(packet);
          }

          @Override
          public void notified(StreamNotification notification) {
            heard.notified(notification);
          }
        };
    Conversion.Result result;
    try (RecordingReader reader = Recordings.open(source);
        RecordingWriter writer = writer(target)) {
      result = copyAll(new StreamGrammar(onlyOn)).run(reader, writer);
    }
    assertEquals(20_000, result.eventsRead());
    assertEquals(heard.events().size(), result.eventsWritten());
    assertTrue(result.eventsWritten() > 9_000 && result.eventsWritten() < 11_000);
    assertEquals(heard.events(), read(target).events());
    assertEquals(1, heard.notifications(StreamStarted.class).size());
    assertEquals(1, heard.notifications(EndOfStream.class).size());
  }

  @Test
  void stageReceivesTheEndOfARangeOnce() throws IOException {
    Path source = write("source.aedat", EventPackets.uniform(SENSOR, 2, 50_000, 0, 10));
    StreamRecorder heard = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(source);
        RecordingWriter writer = writer(folder.resolve("part.aedat"))) {
      new Conversion(1000, 2000, Optional.of(new StreamGrammar(heard)), ProgressListener.NONE)
          .run(reader, writer);
      assertTrue(reader.positionBytes() < reader.sizeBytes() / 2 + 300_000, "stopped early");
    }
    assertEquals(2, heard.notifications().size());
    assertEquals(
        List.of(new EndOfStream(heard.events().lastTimeUs())),
        heard.notifications(EndOfStream.class));
  }

  @Test
  void timeRangeIsCopiedFromEverySegment() throws IOException {
    EventPacket first = EventPackets.uniform(SENSOR, 3, 5000, 10_000, 10);
    EventPacket second = EventPackets.uniform(SENSOR, 4, 5000, 9_000, 10);
    Path source = write("source.aedat", first, second);
    Path target = folder.resolve("part.aedat");
    try (RecordingReader reader = Recordings.open(source);
        RecordingWriter writer = writer(target)) {
      copy(20_000, 30_000).run(reader, writer);
    }
    assertEquals(
        EventPackets.join(
            List.of(
                EventPackets.part(
                    first, first.indexAtOrAfter(20_000), first.indexAtOrAfter(30_000)),
                EventPackets.part(
                    second, second.indexAtOrAfter(20_000), second.indexAtOrAfter(30_000)))),
        EventPackets.join(List.of(read(target).events())));
  }

  @Test
  void rangeWithoutEventsGivesAnEmptyRecording() throws IOException {
    Path source = write("source.aedat", EventPackets.uniform(SENSOR, 5, 100, 0, 10));
    Path target = folder.resolve("nothing.aedat");
    try (RecordingReader reader = Recordings.open(source);
        RecordingWriter writer = writer(target)) {
      assertEquals(0, copy(1_000_000, 2_000_000).run(reader, writer).eventsWritten());
    }
    assertEquals(0, read(target).events().size());
    assertThrows(IllegalArgumentException.class, () -> copy(2, 1));
  }

  @Test
  void failingStageLeavesNoFile() throws IOException {
    Path source = write("source.aedat", EventPackets.uniform(SENSOR, 6, 100, 0, 10));
    Path target = folder.resolve("failed.aedat");
    StreamHandler failing =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            throw new IllegalStateException("on purpose");
          }

          @Override
          public void notified(StreamNotification notification) {}
        };
    assertThrows(
        IllegalStateException.class,
        () -> {
          try (RecordingReader reader = Recordings.open(source);
              RecordingWriter writer = writer(target)) {
            copyAll(failing).run(reader, writer);
          }
        });
    assertFalse(Files.exists(target));
  }
}
