package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.stream.DataLost;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamStarted;
import haltere.testing.EventPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(30)
class RecorderTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(4, 4);
  private static final Duration LONG = Duration.ofSeconds(20);

  @TempDir Path folder;

  /** A disk that tests hold up or break. */
  private static final class Disk implements RecordingWriter {
    final CountDownLatch reached = new CountDownLatch(1);
    final CountDownLatch flushed = new CountDownLatch(1);
    final EventPacket events = new EventPacket(0);
    final List<String> calls = new ArrayList<>();
    CountDownLatch gate = new CountDownLatch(0);
    int room = Integer.MAX_VALUE;
    IOException full = new IOException("No space left on device");

    @Override
    public void write(EventPacket packet) throws IOException {
      reached.countDown();
      try {
        gate.await();
      } catch (InterruptedException e) {
        throw new IOException("interrupted", e);
      }
      if (events.size() + packet.size() > room) {
        throw full;
      }
      events.append(packet, 0, packet.size());
    }

    @Override
    public void writeThrough() {
      flushed.countDown();
    }

    @Override
    public void finish() {
      calls.add("finish");
    }

    @Override
    public void close() {
      calls.add("close");
    }
  }

  private final Disk disk = new Disk();

  private static EventPacket packet(int events, long firstUs) {
    EventPacket packet = new EventPacket(events);
    for (int i = 0; i < events; i++) {
      packet.append(firstUs + i, 0, 0, true);
    }
    return packet;
  }

  private Recorder recorder(OverflowPolicy policy, int packets, Duration patience) {
    return new Recorder(disk, SENSOR, policy, packets, patience);
  }

  @Test
  void seekEndsTheRecordingAndLaterEventsAreCounted() throws IOException {
    try (Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, LONG)) {
      recorder.notified(new StreamStarted(SENSOR, "test"));
      recorder.notified(new Reset(Reset.Cause.SEEK));
      recorder.packet(packet(3, 0));
      recorder.notified(new Reset(Reset.Cause.CLOCK_RESTARTED));
      recorder.packet(packet(2, 0));
      recorder.notified(new Reset(Reset.Cause.REWIND));
      recorder.packet(packet(4, 0));
      recorder.notified(new EndOfStream(4));
      RecorderReport report = recorder.finish();
      assertEquals(5, report.received());
      assertEquals(5, report.written());
      assertEquals(0, report.lost());
      assertEquals(4, report.afterStop());
      assertEquals(Reset.Cause.REWIND, ((Reset) report.stoppedBy().orElseThrow()).cause());
    }
    assertEquals(List.of("finish", "close"), disk.calls);
    assertEquals(5, disk.events.size());
  }

  @Test
  void endOfStreamEndsTheRecording() throws IOException {
    try (Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, LONG)) {
      recorder.packet(packet(3, 0));
      recorder.notified(new EndOfStream(2));
      recorder.notified(new StreamStarted(SENSOR, "again"));
      recorder.packet(packet(3, 0));
      RecorderReport report = recorder.finish();
      assertEquals(3, report.written());
      assertEquals(3, report.afterStop());
    }
  }

  @Test
  void eventsLostToABlockedDiskAreCountedAndReported() throws Exception {
    disk.gate = new CountDownLatch(1);
    EventPacket all = packet(12 * Recorder.PACKET_EVENTS, 1000);
    int shown = 100;
    try (Recorder recorder = recorder(OverflowPolicy.DROP_NEWEST, 4, LONG)) {
      recorder.packet(EventPackets.part(all, 0, shown));
      assertTrue(disk.reached.await(20, TimeUnit.SECONDS));
      for (int from = shown; from < all.size(); from += 1000) {
        recorder.packet(EventPackets.part(all, from, Math.min(all.size(), from + 1000)));
      }
      disk.gate.countDown();
      RecorderReport report = recorder.finish();
      // The disk has one of the four packets in its hands; small ones were put together.
      int kept = shown + 3 * Recorder.PACKET_EVENTS;
      assertEquals(EventPackets.part(all, 0, kept), disk.events);
      assertEquals(all.size(), report.received());
      assertEquals(kept, report.written());
      assertEquals(all.size() - kept, report.lost());
      assertEquals(1, report.gaps().size());
      DataLost gap = report.gaps().get(0);
      assertEquals(all.size() - kept, gap.estimatedEvents());
      assertEquals(all.timeUs(kept - 1), gap.fromUs());
    }
  }

  @Test
  void playbackWaitsForTheDiskAndLosesNothing() throws IOException {
    EventPacket all = packet(50 * 1000, 0);
    try (Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, LONG)) {
      for (EventPacket part : EventPackets.cut(all, 5)) {
        recorder.packet(part);
      }
      RecorderReport report = recorder.finish();
      assertEquals(all, disk.events);
      assertEquals(0, report.lost());
      assertEquals(List.of(), report.gaps());
    }
  }

  @Test
  void eventsReachTheFileSoonWithoutSuccessors() throws Exception {
    try (Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, LONG)) {
      recorder.packet(packet(3, 0));
      assertTrue(disk.flushed.await(20, TimeUnit.SECONDS));
      assertEquals(List.of(), disk.calls);
    }
  }

  @Test
  void fullDisksFailTheProducerAndTheEnd() throws Exception {
    disk.room = 5;
    Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, LONG);
    recorder.packet(packet(5, 0));
    assertTrue(disk.flushed.await(20, TimeUnit.SECONDS));
    UncheckedIOException thrown =
        assertThrows(
            UncheckedIOException.class,
            () -> {
              while (true) {
                recorder.packet(packet(10, 10));
              }
            });
    assertTrue(thrown.getMessage().contains("No space left on device"), thrown.getMessage());
    assertThrows(IOException.class, recorder::finish);
    recorder.close();
    RecorderReport report = recorder.report();
    assertEquals(5, report.written());
    assertEquals(report.received(), report.written() + report.lost());
    assertTrue(report.failure().orElseThrow().contains("No space left on device"));
    assertEquals(List.of("close"), disk.calls);
  }

  @Test
  void problemThatNamesTheFileIsReportedAsItIs() throws Exception {
    disk.room = 0;
    disk.full = new RecordingProblem(Path.of("out.raw"), "cannot be written");
    try (Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, LONG)) {
      recorder.packet(packet(5, 0));
      assertEquals(
          "out.raw: cannot be written",
          assertThrows(IOException.class, recorder::finish).getMessage());
    }
  }

  @Test
  void hungDisksBlockNeitherTheProducerNorTheEnd() throws Exception {
    disk.gate = new CountDownLatch(1);
    Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, Duration.ofMillis(20));
    Thread producer =
        new Thread(
            () -> {
              try {
                recorder.packet(packet(10 * Recorder.PACKET_EVENTS, 0));
              } catch (UncheckedIOException e) {
                // It may come late enough to be told.
              }
            });
    producer.start();
    assertTrue(disk.reached.await(20, TimeUnit.SECONDS));
    IOException thrown = assertThrows(IOException.class, recorder::finish);
    assertTrue(thrown.getMessage().contains("the disk"), thrown.getMessage());
    producer.join();
    assertEquals(0, recorder.report().written());
  }

  @Test
  void interruptDuringTheEndLeavesNoRecording() throws Exception {
    disk.gate = new CountDownLatch(1);
    try (Recorder recorder = recorder(OverflowPolicy.BLOCK, 2, LONG)) {
      recorder.packet(packet(3, 0));
      assertTrue(disk.reached.await(20, TimeUnit.SECONDS));
      Thread.currentThread().interrupt();
      assertThrows(IOException.class, recorder::finish);
      assertTrue(Thread.interrupted());
    }
    assertEquals(List.of("close"), disk.calls);
  }

  @Test
  void unfinishedRecordingInPlaceIsReadable() throws IOException {
    Path file = folder.resolve("open.aedat4");
    EventPacket all = EventPackets.uniform(SENSOR, 1, 20_000, 0, 3);
    try (Recorder recorder =
        Recorder.inPlace(file, WriteOptions.of(SENSOR), OverflowPolicy.BLOCK)) {
      recorder.packet(all);
    }
    assertEquals(all, read(file).events());
  }

  @Test
  void finishedRecordingIsComplete() throws IOException {
    Path file = folder.resolve("whole.aedat4");
    EventPacket all = EventPackets.uniform(SENSOR, 2, 20_000, 0, 3);
    try (Recorder recorder =
        Recorder.inPlace(file, WriteOptions.of(SENSOR), OverflowPolicy.BLOCK)) {
      recorder.packet(all);
      recorder.finish();
      assertFalse(recorder.report().failure().isPresent());
    }
    assertEquals(all, read(file).events());
    assertThrows(
        IOException.class,
        () -> Recorder.inPlace(file, WriteOptions.of(SENSOR), OverflowPolicy.BLOCK));
  }

  private static StreamRecorder read(Path file) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(file)) {
      reader.drainTo(recorder);
    }
    return recorder;
  }
}
