package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.format.ProgressListener;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.TimeSegment;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.pipeline.Conversion;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Contract of the times of every file format: seeking, ranges, and clocks that go back. */
abstract class RecordingTimeContract extends TestedFormat {
  @Test
  void seekYieldsExactlyTheEventsFromTheGivenTime() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 5, 100_000);
    Path file = file("seek");
    write(file, usualSensor(), events);
    SplittableRandom random = new SplittableRandom(6);
    long firstUs = events.firstTimeUs();
    long lastUs = events.lastTimeUs();
    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      assertEquals(List.of(new TimeSegment(firstUs, lastUs)), reader.segments());
      reader.next(new StreamRecorder());
      for (int i = 0; i < 60; i++) {
        long timeUs =
            switch (i) {
              case 0 -> firstUs;
              case 1 -> firstUs - 1;
              case 2 -> Long.MIN_VALUE;
              case 3 -> lastUs;
              case 4 -> lastUs + 1;
              case 5 -> Long.MAX_VALUE;
              default -> random.nextLong(firstUs - 10, lastUs + 10);
            };
        reader.seek(timeUs);
        int from = events.indexAtOrAfter(timeUs);
        StreamRecorder got = new StreamRecorder();
        for (int step = 0; step < 3; step++) {
          reader.next(got);
        }
        assertEquals(
            EventPackets.part(events, from, from + got.events().size()),
            got.events(),
            "from " + timeUs + " us");
        StreamNotification first = got.notifications().get(0).notification();
        boolean restarted = first instanceof StreamStarted;
        if (!restarted) {
          Reset reset = (Reset) first;
          assertSame(Reset.Cause.SEEK, reset.cause());
          assertEquals(
              from == events.size() ? StreamNotification.NO_TIME_US : events.timeUs(from),
              reset.nextUs());
        }
        if (i % 4 == 0) {
          reader.drainTo(got);
          assertEquals(events.size() - from, got.events().size(), "from " + timeUs + " us");
        }
      }
    }
  }

  @Test
  void seekBeforeTheStartStartsTheStreamAtTheGivenTime() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 7, 1000);
    Path file = file("seek-first");
    write(file, usualSensor(), events);
    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      reader.seek(events.timeUs(700) + 1);
      StreamRecorder stream = read(reader);
      int from = events.indexAtOrAfter(events.timeUs(700) + 1);
      assertEquals(EventPackets.part(events, from, events.size()), stream.events());
      assertEquals(List.of(), stream.notifications(Reset.class));
      reader.seek(events.firstTimeUs());
      assertEquals(events, read(reader).events(), "after the end the stream starts anew");
    }
  }

  @Test
  void timeRangeIsHalfOpen() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 8, 5000);
    Path file = file("range");
    write(file, usualSensor(), events);
    SplittableRandom random = new SplittableRandom(9);
    for (int i = 0; i < 30; i++) {
      int a = random.nextInt(events.size());
      int b = random.nextInt(events.size());
      long fromUs = Math.min(events.timeUs(a), events.timeUs(b)) - (i & 1);
      long toUs = Math.max(events.timeUs(a), events.timeUs(b)) + (i >> 1 & 1);
      EventPacket copied = new EventPacket(0);
      try (RecordingReader reader = format().open(file, options(usualSensor()))) {
        Conversion.Result result =
            new Conversion(fromUs, toUs, Optional.empty(), ProgressListener.NONE)
                .run(reader, new PacketWriter(copied));
        assertEquals(copied.size(), result.eventsWritten());
      }
      assertEquals(
          EventPackets.part(events, events.indexAtOrAfter(fromUs), events.indexAtOrAfter(toUs)),
          copied,
          fromUs + " to " + toUs + " us");
    }
  }

  @Test
  void backwardClockJumpStartsANewSegment() throws IOException {
    if (!clockCanGoBack()) {
      backwardClockJumpIsReportedAsLoss();
      return;
    }
    EventPacket first = randomEvents(usualSensor(), 12, 3000);
    EventPacket second = EventPackets.shifted(randomEvents(usualSensor(), 13, 2000), -50_000);
    Path file = file("restart");
    write(file, usualSensor(), first, second);
    List<TimeSegment> segments =
        List.of(
            new TimeSegment(first.firstTimeUs(), first.lastTimeUs()),
            new TimeSegment(second.firstTimeUs(), second.lastTimeUs()));
    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      StreamRecorder stream = read(reader);
      assertEquals(first, EventPackets.part(stream.events(), 0, first.size()));
      assertEquals(
          second, EventPackets.part(stream.events(), first.size(), stream.events().size()));
      Reset reset =
          new Reset(Reset.Cause.CLOCK_RESTARTED, first.lastTimeUs(), second.firstTimeUs());
      assertEquals(List.of(reset), stream.notifications(Reset.class));
      assertEquals(first.size(), stream.notifications().get(1).eventsBefore());
      assertEquals(1, reader.violations().count(Violation.CLOCK_WENT_BACK));

      assertEquals(segments, reader.segments());
      reader.seek(1, second.timeUs(1500));
      int from = second.indexAtOrAfter(second.timeUs(1500));
      assertEquals(EventPackets.part(second, from, second.size()), read(reader).events());
      reader.seek(0, first.lastTimeUs() + 1);
      assertEquals(second, read(reader).events(), "behind a segment's end is the next");
      assertEquals(1, reader.violations().count(Violation.CLOCK_WENT_BACK), "counted once");
    }
    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      RecordingSummary summary = RecordingSummary.scan(reader, ProgressListener.NONE);
      assertEquals(segments, summary.segments());
      assertFalse(summary.timestampsMonotonic());
    }
  }

  @Test
  void eventsLateByAMillisecondGetTheNewestTimeAndStartNoSegment() throws IOException {
    if (!clockCanGoBack()) {
      return;
    }
    SplittableRandom random = new SplittableRandom(14);
    List<EventPacket> written = new ArrayList<>();
    EventPacket ordered = new EventPacket(0);
    long newestUs = 1_000_000;
    for (int i = 0; i < 300; i++) {
      EventPacket piece = randomEvents(usualSensor(), 100 + i, 1 + random.nextInt(20));
      long lateUs = i == 0 ? 0 : random.nextInt(1001);
      piece = EventPackets.shifted(piece, newestUs - lateUs - piece.firstTimeUs());
      written.add(piece);
      for (int k = 0; k < piece.size(); k++) {
        newestUs = Math.max(newestUs, piece.timeUs(k));
        ordered.append(newestUs, piece.x(k), piece.y(k), piece.isOn(k));
      }
    }
    Path file = file("late");
    write(file, usualSensor(), written.toArray(EventPacket[]::new));
    for (int packetEvents : new int[] {1, 7, 4096}) {
      ReadOptions options = options(usualSensor()).withPacketEvents(packetEvents);
      try (RecordingReader reader = format().open(file, options)) {
        StreamRecorder stream = read(reader);
        assertEquals(ordered, stream.events(), "packets of " + packetEvents);
        assertEquals(List.of(), stream.notifications(Reset.class));
        assertTrue(reader.violations().count(Violation.OUT_OF_ORDER) > 100);
        assertEquals(0, reader.violations().count(Violation.CLOCK_WENT_BACK));
        assertEquals(
            List.of(new TimeSegment(ordered.firstTimeUs(), ordered.lastTimeUs())),
            reader.segments());
        for (int i = 0; i < 20; i++) {
          long timeUs = ordered.timeUs(random.nextInt(ordered.size()));
          reader.seek(0, timeUs);
          assertEquals(
              EventPackets.part(ordered, ordered.indexAtOrAfter(timeUs), ordered.size()),
              read(reader).events(),
              "from " + timeUs + " us");
        }
      }
    }
  }

  private void backwardClockJumpIsReportedAsLoss() throws IOException {
    EventPacket first = randomEvents(usualSensor(), 12, 3000);
    EventPacket second = EventPackets.shifted(randomEvents(usualSensor(), 13, 2000), -50_000);
    Path file = file("restart");
    try (RecordingWriter writer =
        format().create(file, WriteOptions.of(usualSensor())).orElseThrow()) {
      writer.write(first);
      writer.write(second);
      assertEquals(1, writer.losses().size(), writer.losses().toString());
      writer.finish();
    }
    EventPacket got = read(file, options(usualSensor())).events();
    assertEquals(first, EventPackets.part(got, 0, first.size()));
    long shiftUs = first.lastTimeUs() - second.firstTimeUs();
    assertEquals(
        EventPackets.shifted(second, shiftUs), EventPackets.part(got, first.size(), got.size()));
  }

  /** A writer to a packet. */
  private record PacketWriter(EventPacket target) implements RecordingWriter {
    @Override
    public void write(EventPacket packet) {
      target.append(packet, 0, packet.size());
    }

    @Override
    public void finish() {}

    @Override
    public void close() {}
  }
}
