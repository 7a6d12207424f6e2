package haltere.core.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.format.internal.aedat4.Aedat4Compression;
import haltere.core.format.internal.aedat4.Aedat4Writer;
import haltere.core.pipeline.SessionRecorder.Limits;
import haltere.core.pipeline.SessionRecorder.Part;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

@Timeout(60)
class SessionRecorderTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  @TempDir Path folder;
  private final AtomicLong free = new AtomicLong(Long.MAX_VALUE);
  private final AtomicInteger headers = new AtomicInteger();
  private final Random random = new Random(5);
  private final EventPacket sent = new EventPacket(1000);

  private SessionRecorder session(Limits limits) {
    return new SessionRecorder(
        folder.resolve("out.aedat4"),
        SENSOR,
        (file, metadata) ->
            Aedat4Writer.createInPlace(
                file,
                new WriteOptions(SENSOR, false, Optional.empty(), metadata),
                Aedat4Compression.LZ4),
        limits,
        () -> Map.of("part", Integer.toString(headers.incrementAndGet()), "biases", "a <1> &\"b\""),
        free::get);
  }

  private SessionRecorder session() {
    return session(new Limits(Long.MAX_VALUE, 1000));
  }

  private EventPacket events(long fromUs, int count) {
    EventPacket packet = new EventPacket(count);
    for (int i = 0; i < count; i++) {
      packet.append(fromUs + i, random.nextInt(128), random.nextInt(128), random.nextBoolean());
    }
    sent.append(packet, 0, count);
    return packet;
  }

  private static StreamRecorder read(Part part) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = Recordings.open(part.file())) {
      reader.drainTo(recorder);
      assertTrue(reader.violations().describe().isEmpty(), "a part is not whole");
    }
    return recorder;
  }

  /** Every event is in one part, in order. */
  private void assertHoldTogether(List<Part> parts) throws IOException {
    EventPacket together = new EventPacket(1000);
    for (Part part : parts) {
      EventPacket events = read(part).events();
      assertEquals(events.size(), part.report().written());
      together.append(events, 0, events.size());
    }
    assertEquals(sent.size(), together.size());
    for (int i = 0; i < sent.size(); i++) {
      assertEquals(sent.timeUs(i), together.timeUs(i));
      assertEquals(sent.address(i), together.address(i));
    }
  }

  private static List<String> names(List<Part> parts) {
    return parts.stream().map(part -> part.file().getFileName().toString()).toList();
  }

  @Test
  void newStreamsAndClockRestartsStartNewParts() throws IOException {
    List<Part> parts;
    try (SessionRecorder session = session()) {
      session.notified(new StreamStarted(SENSOR, "camera"));
      session.packet(events(1000, 500));
      session.notified(new EndOfStream(1499));
      session.notified(new StreamStarted(SENSOR, "camera"));
      session.packet(events(0, 300));
      session.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, 299, 0));
      session.packet(events(0, 200));
      session.notified(new Reset(Reset.Cause.USER));
      session.packet(events(300, 100));
      session.notified(new EndOfStream(399));
      parts = session.finish();
    }
    assertEquals(List.of("out.aedat4", "out-2.aedat4", "out-3.aedat4"), names(parts));
    assertHoldTogether(parts);
    assertEquals(3, headers.get());
    for (int i = 0; i < parts.size(); i++) {
      try (RecordingReader reader = Recordings.open(parts.get(i).file())) {
        assertEquals(
            Map.of("part", Integer.toString(i + 1), "biases", "a <1> &\"b\""), reader.metadata());
      }
    }
  }

  @Test
  void partsStayBelowTheLimitWithoutMissingEvents() throws IOException {
    List<Part> parts;
    try (SessionRecorder session = session(new Limits(Limits.MIN_PART_BYTES, 0))) {
      session.notified(new StreamStarted(SENSOR, "camera"));
      for (int i = 0; i < 300; i++) {
        session.packet(events(i * 2000L, 1500));
      }
      session.notified(new EndOfStream(StreamNotification.NO_TIME_US));
      parts = session.finish();
    }
    assertTrue(parts.size() > 2, parts.toString());
    for (Part part : parts) {
      assertTrue(Files.size(part.file()) <= Limits.MIN_PART_BYTES, part.toString());
      assertEquals(0, part.report().lost());
    }
    assertHoldTogether(parts);
  }

  @Test
  void recordingEndsWithACompleteFileBeforeTheDiskIsFull() throws IOException {
    try (SessionRecorder session = session()) {
      session.notified(new StreamStarted(SENSOR, "camera"));
      session.packet(events(0, 100));
      free.set(999);
      long fromUs = 1000;
      while (session.endedEarly().isEmpty()) {
        session.packet(events(fromUs, 10));
        fromUs += 100;
      }
      assertTrue(fromUs < 1000 + 200 * 100, "it looks at the disk often enough");
      EventPacket late = new EventPacket(7);
      for (int i = 0; i < 7; i++) {
        late.append(fromUs + i, 1, 1, true);
      }
      session.packet(late);
      assertEquals(7, session.afterEnd());
      List<Part> parts = session.finish();
      assertEquals(sent.size() + 7L, session.received());
      assertEquals(sent.size(), session.written());
      assertEquals(1, parts.size());
      assertHoldTogether(parts);
      assertTrue(session.endedEarly().orElseThrow().contains("it is complete up to there"));
    }
  }

  @Test
  void fullDisksAreNotWrittenTo() throws IOException {
    free.set(0);
    try (SessionRecorder session = session()) {
      session.packet(events(0, 10));
      assertTrue(session.endedEarly().orElseThrow().contains("nothing was written"));
      assertTrue(session.finish().isEmpty());
      assertEquals(10, session.received());
      assertEquals(0, session.written());
    }
    assertFalse(Files.exists(folder.resolve("out.aedat4")));
  }

  @Test
  void recordingsDoNotStartBelowTheReservedDiskSpace() throws IOException {
    free.set(999);
    try (SessionRecorder session = session()) {
      String refused = assertThrows(RecordingProblem.class, session::checkSpace).getMessage();
      assertTrue(refused.contains("--keep-free"), refused);
      free.set(1000);
      session.checkSpace();
    }
  }

  @Test
  void recordingWithoutEventsLeavesNoFile() throws IOException {
    try (SessionRecorder session = session()) {
      session.notified(new StreamStarted(SENSOR, "camera"));
      session.packet(new EventPacket(1));
      session.notified(new EndOfStream(StreamNotification.NO_TIME_US));
      assertTrue(session.finish().isEmpty());
    }
    assertFalse(Files.exists(folder.resolve("out.aedat4")));
  }

  @Test
  void failureToStartAPartIsReported() throws IOException {
    Files.writeString(folder.resolve("out.aedat4"), "mine");
    try (SessionRecorder session = session()) {
      EventPacket packet = events(0, 10);
      assertThrows(java.io.UncheckedIOException.class, () -> session.packet(packet));
      assertTrue(session.endedEarly().orElseThrow().contains("out.aedat4: it exists already"));
    }
    assertEquals("mine", Files.readString(folder.resolve("out.aedat4")));
  }

  @Test
  void partsAreNamedAfterTheFirst() {
    assertEquals(Path.of("a.b.csv"), SessionRecorder.part(Path.of("a.b.csv"), 1));
    assertEquals(Path.of("a.b-12.csv"), SessionRecorder.part(Path.of("a.b.csv"), 12));
    assertEquals(Path.of("a-2"), SessionRecorder.part(Path.of("a"), 2));
    assertThrows(IllegalArgumentException.class, () -> new Limits(5, 0));
    assertTrue(SessionRecorder.freeBytes(folder.resolve("out.aedat4")).getAsLong() > 0);
  }
}
