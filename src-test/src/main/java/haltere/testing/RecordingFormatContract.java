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
import haltere.core.format.FileHead;
import haltere.core.format.RecordingOutline;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/**
 * The contract of every file format. The test of a format extends this class and defines the
 * format, its sensors, and how to create a file if there is no writer.
 */
public abstract class RecordingFormatContract extends RecordingTimeContract {
  private static final int[] PACKET_SIZES = {1, 7, 1000, 8192, 1 << 20};

  /** Places in which a file is cut, at most; a longer one is cut in every second, third... */
  private static final int MAX_CUTS = 2500;

  /** Bytes at the start of a file of which none is passed over. */
  private static final int EVERY_BYTE = 500;

  /** For subclasses. */
  protected RecordingFormatContract() {}

  @Test
  void randomEventsAreReadBackUnchanged() throws IOException {
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
  void cornerPixelsAndExtremeTimesAreReadBackUnchanged() throws IOException {
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
  void recordingWithoutEventsIsReadAsAStreamWithoutPackets() throws IOException {
    Path file = file("empty");
    write(file, usualSensor());

    try (RecordingReader reader = format().open(file, options(usualSensor()))) {
      assertEquals(List.of(), reader.segments());
      StreamRecorder stream = read(reader);
      assertEquals(0, stream.events().size());
      assertEquals(
          List.of(new EndOfStream(StreamNotification.NO_TIME_US)),
          stream.notifications(EndOfStream.class));
      reader.seek(5);
      assertEquals(0, read(reader).events().size());
    }
  }

  @Test
  void completeFileAcceptsNothingMore() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 3, 60);
    Path file = file("complete");
    Optional<RecordingWriter> created = format().create(file, WriteOptions.of(usualSensor()));
    assertEquals(format().writable(), created.isPresent());
    if (created.isPresent()) {
      try (RecordingWriter writer = created.get()) {
        writer.write(events);
        writer.finish();
        assertThrows(IllegalStateException.class, () -> writer.write(events));
        assertThrows(IllegalStateException.class, writer::finish);
      }
      assertEquals(events, read(file, options(usualSensor())).events());
    }
  }

  @Test
  void truncatedFileYieldsTheEventsBeforeTheCut() throws IOException {
    EventPacket events = randomEvents(usualSensor(), 3, 60);
    Path whole = file("whole");
    write(whole, usualSensor(), events);
    byte[] bytes = Files.readAllBytes(whole);
    int cutsNoticed = 0;
    int cutsRead = 0;
    Path cut = file("cut");
    int step = 1 + (bytes.length - 1) / MAX_CUTS;
    for (int length = 0; length < bytes.length; length += length < EVERY_BYTE ? 1 : step) {
      ReplacedFile.write(cut, Arrays.copyOf(bytes, length));
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
  void fileWithFalseSizesIsRejectedOrReadInBoundedMemory() throws IOException {
    Path whole = file("truth");
    write(whole, usualSensor(), randomEvents(usualSensor(), 4, 500));
    List<byte[]> lies = lyingFiles(Files.readAllBytes(whole));
    assertFalse(lies.isEmpty());
    Path file = file("lie");
    for (byte[] lie : lies) {
      ReplacedFile.write(file, lie);
      try (RecordingReader reader = format().open(file, options(usualSensor()))) {
        StreamRecorder stream = read(reader);
        assertTrue(stream.events().size() <= lie.length, stream.events().toString());
      } catch (RecordingProblem problem) {
        assertTrue(problem.getMessage().startsWith(file.toString()), problem.getMessage());
      }
    }
  }

  @Test
  void eventsDoNotDependOnThePacketSize() throws IOException {
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
      assertEquals(usual.notifications(), stream.notifications());
    }
  }

  @Test
  void packetsModifiedByAHandlerDoNotAffectLaterPackets() throws IOException {
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
  void formatIsDetectedByContentWhateverTheFileName() throws IOException {
    Path file = file("named");
    write(file, usualSensor(), randomEvents(usualSensor(), 15, 500));
    Path other = folder.resolve("no-ending-at-all");
    Files.move(file, other);

    assertSame(certainty(), format().probe(FileHead.read(other)).support());
    assertEquals(format().name(), Recordings.detect(other).name());
  }

  @Test
  void closingTwiceIsAllowed() throws IOException {
    Path file = file("closed");
    write(file, usualSensor(), randomEvents(usualSensor(), 16, 5));
    RecordingReader reader = format().open(file, options(usualSensor()));
    reader.close();
    assertDoesNotThrow(reader::close);
  }

  @Test
  void writtenFileAppearsCompleteOrNotAtAll() throws IOException {
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
}
