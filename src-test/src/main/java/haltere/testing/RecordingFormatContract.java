package haltere.testing;

import static org.junit.jupiter.api.Assertions.assertDoesNotThrow;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.Conversion;
import haltere.core.format.FileHead;
import haltere.core.format.ProgressListener;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingOutline;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingSummary;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Support;
import haltere.core.format.TimeSegment;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What every file format keeps. A format's test extends this and says how to make the format, which
 * sensors it holds, and how a file of it comes about if it cannot be written.
 */
public abstract class RecordingFormatContract {
  private static final int[] PACKET_SIZES = {1, 7, 1000, 8192, 1 << 20};

  /** Places in which a file is cut, at the most; a longer one is cut in every second, third... */
  private static final int MOST_CUTS = 2500;

  /** Bytes at the start of a file of which none is passed over. */
  private static final int EVERY_BYTE = 500;

  /** Files that the tests make. */
  @TempDir protected Path folder;

  /** For subclasses. */
  protected RecordingFormatContract() {}

  /**
   * The format.
   *
   * @return the one that is tested
   */
  protected abstract RecordingFormat format();

  /**
   * Sensors of which the format can hold events.
   *
   * @return the smallest, the largest and the usual ones
   */
  protected abstract List<SensorGeometry> sensors();

  /**
   * The earliest time that the format can hold.
   *
   * @return microseconds
   */
  protected abstract long earliestUs();

  /**
   * A time that lies behind {@link #earliestUs()} and up to which the format can hold any time.
   *
   * @return microseconds
   */
  protected abstract long latestUs();

  /**
   * Makes a file of the format, by its writer; a format that is only read says here how else. Times
   * may go back from one packet to the next.
   *
   * @param file where
   * @param sensor of the events
   * @param packets what it holds
   * @throws IOException if that fails
   */
  protected void write(Path file, SensorGeometry sensor, EventPacket... packets)
      throws IOException {
    try (RecordingWriter writer = format().create(file, WriteOptions.of(sensor)).orElseThrow()) {
      for (EventPacket packet : packets) {
        writer.write(packet);
      }
      assertEquals(List.of(), writer.losses());
      writer.finish();
    }
  }

  /**
   * Whether each byte of a file belongs to an event or stands before one.
   *
   * @return false if something else, such as a table, follows the last event
   */
  protected boolean endsInEvents() {
    return true;
  }

  /**
   * Whether the format can say that its clock goes back.
   *
   * @return false for formats that only say how far time goes on
   */
  protected boolean clockCanGoBack() {
    return true;
  }

  /**
   * How sure the format is of a file of its own.
   *
   * @return less than certain for formats without any mark
   */
  protected Support certainty() {
    return Support.CERTAIN;
  }

  /**
   * What a user has to say about a file of the format.
   *
   * @param sensor of its events
   * @return the options to read it with
   */
  protected ReadOptions options(SensorGeometry sensor) {
    return ReadOptions.DEFAULT;
  }

  /**
   * Files whose lengths, counts or sizes cannot be true, made from a true one.
   *
   * @param file bytes of a file with events of the first of {@link #sensors()}
   * @return damaged copies
   */
  protected abstract List<byte[]> lyingFiles(byte[] file);

  private SensorGeometry usualSensor() {
    return sensors().get(0);
  }

  private static StreamRecorder read(RecordingReader reader) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    reader.drainTo(new StreamGrammar(recorder));
    return recorder;
  }

  private StreamRecorder read(Path file, ReadOptions options) throws IOException {
    try (RecordingReader reader = format().open(file, options)) {
      return read(reader);
    }
  }

  private EventPacket randomEvents(SensorGeometry sensor, long seed, int count) {
    return EventPackets.uniform(sensor, seed, count, 1_000_000 + 977 * seed, 37);
  }

  private Path file(String name) {
    return folder.resolve(name + "." + format().extensions().iterator().next());
  }

  @Test
  void randomEventsComeBackAsTheyWereWritten() throws IOException {
    long seed = 1;
    for (SensorGeometry sensor : sensors()) {
      for (int count : new int[] {1, 2, 1023, 20_000}) {
        EventPacket events = randomEvents(sensor, seed++, count);
        Path file = file("random-" + seed);
        write(file, sensor, EventPackets.cut(events, seed).toArray(EventPacket[]::new));

        try (RecordingReader reader = format().open(file, options(sensor))) {
          assertEquals(sensor.width(), reader.geometry().width());
          assertEquals(sensor.height(), reader.geometry().height());
          assertNotEquals("", reader.clock().describe());
          RecordingOutline whole =
              new RecordingOutline(count, events.firstTimeUs(), events.lastTimeUs());
          assertEquals(whole, reader.outline().orElse(whole));
          assertEquals(events, read(reader).events(), sensor + ", " + count + " events");
          assertEquals(List.of(), reader.violations().describe());
        }
      }
    }
  }

  @Test
  void cornersAndTheEndsOfTheClockComeBackAsTheyWereWritten() throws IOException {
    for (SensorGeometry sensor : sensors()) {
      EventPacket events = new EventPacket(16);
      long[] times = {earliestUs(), earliestUs(), earliestUs() + 1, 0, 0, 1, latestUs()};
      Arrays.sort(times);
      for (long timeUs : times) {
        for (int corner = 0; corner < 8; corner++) {
          events.append(
              timeUs,
              (corner & 1) * (sensor.width() - 1),
              (corner >> 1 & 1) * (sensor.height() - 1),
              corner >= 4);
        }
      }
      Path file = file("extremes-" + sensor);
      write(file, sensor, events);

      assertEquals(events, read(file, options(sensor)).events(), sensor.toString());
    }
  }

  @Test
  void aRecordingWithoutEventsIsAStreamWithoutPackets() throws IOException {
    Path file = file("empty");
    write(file, usualSensor());

    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      assertEquals(List.of(), reader.segments());
      StreamRecorder stream = read(reader);
      assertEquals(0, stream.events().size());
      assertEquals(
          List.of(new EndOfStream(StreamNotification.NO_TIME_US)),
          stream.notices(EndOfStream.class));
      reader.seek(5);
      assertEquals(0, read(reader).events().size());
    }
  }

  @Test
  void aFileCutAnywhereGivesTheEventsBeforeTheCut() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 3, 60);
    Path whole = file("whole");
    write(whole, usualSensor(), events);
    byte[] bytes = Files.readAllBytes(whole);
    int cutsNoticed = 0;
    int cutsRead = 0;
    Path cut = file("cut");
    int step = 1 + (bytes.length - 1) / MOST_CUTS;
    for (int length = 0; length < bytes.length; length += length < EVERY_BYTE ? 1 : step) {
      Files.write(cut, Arrays.copyOf(bytes, length));
      try (RecordingReader reader = format().open(cut, options(usualSensor()))) {
        EventPacket got = read(reader).events();
        cutsRead++;
        cutsNoticed += reader.violations().count(Violation.CUT_OFF) > 0 ? 1 : 0;
        assertTrue(got.size() < events.size() || !endsInEvents(), "cut to " + length + " bytes");
        assertEquals(EventPackets.part(events, 0, got.size()), got, "cut to " + length + " bytes");
      } catch (RecordingProblem problem) {
        assertTrue(problem.getMessage().startsWith(cut.toString()), problem.getMessage());
      }
    }
    assertTrue(cutsRead > 60, "only " + cutsRead + " of the cuts could be read");
    // of a large file not every byte is tried, and of Event Stream most bytes are silence
    int least = step == 1 ? 60 : 20;
    assertTrue(cutsNoticed > least, "only " + cutsNoticed + " of the cuts were noticed");
  }

  @Test
  void aFileThatLiesAboutSizesIsRefusedOrReadInBoundedMemory() throws IOException {
    Path whole = file("truth");
    write(whole, usualSensor(), randomEvents(usualSensor(), 4, 500));
    List<byte[]> lies = lyingFiles(Files.readAllBytes(whole));
    assertFalse(lies.isEmpty());
    Path file = file("lie");
    for (byte[] lie : lies) {
      Files.write(file, lie);
      try (RecordingReader reader = format().open(file, options(usualSensor()))) {
        StreamRecorder stream = read(reader);
        assertTrue(stream.events().size() <= lie.length, stream.events().toString());
      } catch (RecordingProblem problem) {
        assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      }
    }
  }

  @Test
  void seekingGivesExactlyTheEventsFromThatTimeOn() throws IOException {
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
        StreamNotification first = got.notices().get(0).notification();
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
  void seekingBeforeTheStartOfTheStreamStartsItThere() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 7, 1000);
    Path file = file("seek-first");
    write(file, usualSensor(), events);
    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      reader.seek(events.timeUs(700) + 1);
      StreamRecorder stream = read(reader);
      int from = events.indexAtOrAfter(events.timeUs(700) + 1);
      assertEquals(EventPackets.part(events, from, events.size()), stream.events());
      assertEquals(List.of(), stream.notices(Reset.class));
      reader.seek(events.firstTimeUs());
      assertEquals(events, read(reader).events(), "after the end the stream starts anew");
    }
  }

  @Test
  void aStretchOfTimeIsHalfOpen() throws IOException {
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
  void readingNeverDependsOnTheSizeOfPackets() throws IOException {
    Path file = file("packets");
    EventPacket first = randomEvents(usualSensor(), 10, 3000);
    EventPacket second =
        EventPackets.shifted(
            randomEvents(usualSensor(), 11, 2500), clockCanGoBack() ? -60_000 : 200_000);
    write(file, usualSensor(), first, second);
    StreamRecorder usual = read(file, options(usualSensor()));
    for (int packetEvents : PACKET_SIZES) {
      StreamRecorder stream = read(file, options(usualSensor()).withPacketEvents(packetEvents));
      assertTrue(stream.largestPacket() <= packetEvents, "packets of " + stream.largestPacket());
      assertEquals(usual.events(), stream.events());
      assertEquals(usual.notices(), stream.notices());
    }
  }

  @Test
  void aClockThatGoesBackStartsANewSegment() throws IOException {
    if (!clockCanGoBack()) {
      aClockThatCannotGoBackIsTold();
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
      assertEquals(List.of(reset), stream.notices(Reset.class));
      assertEquals(first.size(), stream.notices().get(1).eventsBefore());
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

  private void aClockThatCannotGoBackIsTold() throws IOException {
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

  @Test
  void whatAHandlerDoesToAPacketDoesNotChangeWhatFollows() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 14, 30_000);
    Path file = file("spoiled");
    write(file, usualSensor(), events);
    EventPacket got = new EventPacket(0);
    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      reader.drainTo(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              got.append(packet, 0, packet.size());
              Arrays.fill(packet.timesUs(), Long.MAX_VALUE);
              Arrays.fill(packet.addresses(), -1);
              packet.clear();
            }

            @Override
            public void notified(StreamNotification notification) {}
          });
    }
    assertEquals(events, got);
  }

  @Test
  void theContentTellsTheFormatWhateverTheNameIs() throws IOException {
    Path file = file("named");
    write(file, usualSensor(), randomEvents(usualSensor(), 15, 500));
    Path other = folder.resolve("no-ending-at-all");
    Files.move(file, other);

    assertSame(certainty(), format().probe(FileHead.read(other)).support());
    assertEquals(format().name(), Recordings.detect(other).name());
  }

  @Test
  void closingTwiceDoesNoHarm() throws IOException {
    Path file = file("closed");
    write(file, usualSensor(), randomEvents(usualSensor(), 16, 5));
    RecordingReader reader = format().open(file, options(usualSensor()));
    reader.close();
    assertDoesNotThrow(reader::close);
  }

  @Test
  void whatIsWrittenAppearsWholeOrNotAtAll() throws IOException {
    Path file = file("whole-or-not");
    if (!format().writable()) {
      assertTrue(format().create(file, WriteOptions.of(usualSensor())).isEmpty());
      return;
    }
    EventPacket events = randomEvents(usualSensor(), 17, 5000);
    EventPacket untouched = EventPackets.copy(events);
    try (RecordingWriter writer =
        format().create(file, WriteOptions.of(usualSensor())).orElseThrow()) {
      writer.write(events);
      assertFalse(Files.exists(file), "there before it is finished");
    }
    assertEquals(untouched, events, "the writer changed a packet");
    try (Stream<Path> left = Files.list(folder)) {
      assertEquals(List.of(), left.toList(), "closed without finishing, but something is left");
    }
    write(file, usualSensor(), events);
    RecordingProblem refused =
        assertThrows(
            RecordingProblem.class, () -> format().create(file, WriteOptions.of(usualSensor())));
    assertTrue(refused.getMessage().contains("--overwrite"), refused.getMessage());
    try (RecordingWriter writer =
        format().create(file, WriteOptions.of(usualSensor()).withOverwrite(true)).orElseThrow()) {
      writer.finish();
    }
    assertEquals(0, read(file, options(usualSensor())).events().size());
    try (Stream<Path> left = Files.list(folder)) {
      assertEquals(List.of(file), left.toList());
    }
  }

  /** Takes what is written into a packet. */
  private record PacketWriter(EventPacket target) implements RecordingWriter {
    @Override
    public void write(EventPacket packet) {
      target.append(packet, 0, packet.size());
    }

    @Override
    public List<String> losses() {
      return List.of();
    }

    @Override
    public void finish() {}

    @Override
    public void close() {}
  }
}
