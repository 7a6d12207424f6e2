package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.format.summary.RecordingSummary;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamNotification;
import haltere.testing.EventPackets;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Folders as recordings. */
class RecordingFolderTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(64, 48);

  @TempDir Path folder;
  private Path bag;

  @BeforeEach
  void makeBag() throws IOException {
    bag = Files.createDirectory(folder.resolve("bag"));
  }

  private static Path write(Path file, SensorGeometry sensor, EventPacket events)
      throws IOException {
    try (RecordingWriter writer =
        Recordings.forWriting(file).create(file, WriteOptions.of(sensor)).orElseThrow()) {
      writer.write(events);
      writer.finish();
    }
    return file;
  }

  private void list(String... parts) throws IOException {
    StringBuilder text =
        new StringBuilder("rosbag2_bagfile_information:\n  version: 5\n  relative_file_paths:\n");
    for (String part : parts) {
      text.append("    - ").append(part).append('\n');
    }
    text.append("  compression_mode: \"\"\n");
    Files.writeString(bag.resolve("metadata.yaml"), text);
  }

  /** A bag whose parts begin at some events of a stream. */
  private void cut(EventPacket events, int... starts) throws IOException {
    List<String> names = new ArrayList<>();
    for (int i = 0; i < starts.length; i++) {
      // The order of the list counts, not that of the names.
      names.add("part_" + (10 - i) + ".mcap");
      int to = i == starts.length - 1 ? events.size() : starts[i + 1];
      write(bag.resolve(names.get(i)), SENSOR, EventPackets.part(events, starts[i], to));
    }
    list(names.toArray(String[]::new));
  }

  private static StreamRecorder readOn(RecordingReader reader, int items) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    for (int i = 0; i < items && reader.next(recorder); i++) {
      // The recorder has it.
    }
    return recorder;
  }

  private static StreamRecorder all(RecordingReader reader) throws IOException {
    return readOn(reader, Integer.MAX_VALUE);
  }

  private String refusal(Path path) {
    return assertThrows(RecordingProblem.class, () -> Recordings.open(path).close()).getMessage();
  }

  @Test
  void folderWithOneRecordingIsThatRecording() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 1, 1_000, 500, 7);
    Path only = write(bag.resolve("fly.aedat4"), SENSOR, events);
    Files.writeString(bag.resolve("notes.md"), "of today");
    Files.writeString(bag.resolve("notes.txt"), "of yesterday");

    try (RecordingReader reader = Recordings.open(bag)) {
      assertEquals(only, reader.path());
      assertEquals(events, all(reader).events());
    }
    assertEquals("aedat4", Recordings.detect(bag).name());
  }

  @Test
  void folderWithSeveralRecordingsIsRejectedWithTheirNames() throws IOException {
    assertTrue(refusal(bag).contains("without any recording"), refusal(bag));
    Files.createFile(bag.resolve("b.raw"));
    Files.createFile(bag.resolve("a.raw"));
    assertTrue(refusal(bag).contains("2 recordings; name one: a.raw, b.raw"), refusal(bag));
  }

  @Test
  void splitBagIsOneStreamOfOneSegment() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 2, 30_000, 500, 7);
    cut(events, 0, 9_000, 9_001, 20_000);

    try (RecordingReader reader = Recordings.open(bag)) {
      assertEquals(
          List.of(new TimeSegment(events.firstTimeUs(), events.lastTimeUs())), reader.segments());
      StreamRecorder got = all(reader);
      assertEquals(events, got.events());
      assertEquals(2, got.notifications().size(), "a start and an end: " + got.notifications());
      assertEquals(reader.sizeBytes(), reader.positionBytes());
      assertEquals(List.of(), reader.violations().describe());
    }
    try (RecordingReader reader = Recordings.open(bag)) {
      RecordingSummary summary = RecordingSummary.scan(reader, ProgressListener.NONE);
      assertEquals(events.size(), summary.events());
      assertEquals(events.size(), reader.outline().map(RecordingOutline::events).orElse(30_000L));
    }
  }

  @Test
  void eventsOfAPartThatAreLateByAMillisecondGetTheNewestTime() throws IOException {
    EventPacket first = EventPackets.uniform(SENSOR, 2, 1_000, 500, 7);
    EventPacket second =
        EventPackets.shifted(
            EventPackets.uniform(SENSOR, 3, 1_000, 500, 7), first.lastTimeUs() - 500 - 600);
    write(bag.resolve("part_1.mcap"), SENSOR, first);
    write(bag.resolve("part_2.mcap"), SENSOR, second);
    list("part_1.mcap", "part_2.mcap");
    EventPacket ordered = EventPackets.part(first, 0, first.size());
    for (int i = 0; i < second.size(); i++) {
      long timeUs = Math.max(second.timeUs(i), first.lastTimeUs());
      ordered.append(timeUs, second.x(i), second.y(i), second.isOn(i));
    }
    assertTrue(second.firstTimeUs() < first.lastTimeUs());

    try (RecordingReader reader = Recordings.open(bag)) {
      StreamRecorder got = all(reader);
      assertEquals(ordered, got.events());
      assertEquals(2, got.notifications().size(), "a start and an end: " + got.notifications());
      assertEquals(
          List.of(new TimeSegment(ordered.firstTimeUs(), ordered.lastTimeUs())), reader.segments());
      reader.seek(first.lastTimeUs());
      int from = ordered.indexAtOrAfter(first.lastTimeUs());
      assertEquals(EventPackets.part(ordered, from, ordered.size()), all(reader).events());
    }
  }

  @Test
  void seekInASplitBagEqualsThatInAWholeOne() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 3, 20_000, 500, 7);
    cut(events, 0, 7_000, 14_000);
    SplittableRandom random = new SplittableRandom(4);
    try (RecordingReader reader = Recordings.open(bag)) {
      boolean started = false;
      for (int i = 0; i < 200; i++) {
        long timeUs = random.nextLong(events.firstTimeUs() - 1_000, events.lastTimeUs() + 1_000);
        int from = events.indexAtOrAfter(timeUs);
        long nextUs = from < events.size() ? events.timeUs(from) : StreamNotification.NO_TIME_US;

        reader.seek(timeUs);
        StreamRecorder got = readOn(reader, 1 + random.nextInt(7));

        StreamNotification first = got.notifications().get(0).notification();
        assertEquals(started, first instanceof Reset, "at " + i + ": " + first);
        if (first instanceof Reset reset) {
          assertEquals(nextUs, reset.nextUs(), "at " + i);
        }
        boolean ended = !got.notifications(EndOfStream.class).isEmpty();
        int to = ended ? events.size() : from + got.events().size();
        assertEquals(EventPackets.part(events, from, to), got.events(), "at " + i);
        started = !ended;
      }
    }
  }

  @Test
  void clockRestartsBetweenPartsAreReported() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 5, 5_000, 500, 7);
    write(bag.resolve("a.mcap"), SENSOR, events);
    write(bag.resolve("b.mcap"), SENSOR, events);
    list("a.mcap", "\"b.mcap\"");

    try (RecordingReader reader = Recordings.open(bag)) {
      assertEquals(2, reader.segments().size());
      for (int round = 0; round < 2; round++) {
        StreamRecorder got = all(reader);
        assertEquals(10_000, got.events().size());
        assertEquals(
            new Reset(Reset.Cause.CLOCK_RESTARTED, events.lastTimeUs(), events.firstTimeUs()),
            got.notifications().get(1).notification());
        reader.seek(0, Long.MIN_VALUE);
      }
      reader.seek(0, events.lastTimeUs() + 1);
      assertEquals(events, all(reader).events(), "behind the first segment's end is the second");
    }
  }

  @Test
  void missingMisplacedAndForeignPartsAreReported() throws IOException {
    EventPacket events = EventPackets.uniform(SENSOR, 6, 100, 500, 7);
    write(bag.resolve("a.mcap"), SENSOR, events);
    list("a.mcap", "b.mcap");
    assertTrue(refusal(bag).contains("names b.mcap, which is not in this folder"), refusal(bag));
    write(folder.resolve("outside.mcap"), SENSOR, events);
    list("a.mcap", "../outside.mcap");
    assertTrue(refusal(bag).contains("names ../outside.mcap"), refusal(bag));
    write(bag.resolve("b.mcap"), new SensorGeometry(80, 60), events);
    list("a.mcap", "b.mcap");
    assertTrue(refusal(bag).contains("different sensors (64x48 and 80x60)"), refusal(bag));
  }
}
