package haltere.testing.formats;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.event.SensorGeometry;
import haltere.core.format.ProgressListener;
import haltere.core.format.ReadOptions;
import haltere.core.format.RecordingFormat;
import haltere.core.format.RecordingProblem;
import haltere.core.format.RecordingReader;
import haltere.core.format.RecordingWriter;
import haltere.core.format.Recordings;
import haltere.core.format.WriteOptions;
import haltere.core.pipeline.Conversion;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamStarted;
import haltere.testing.EventPackets;
import haltere.testing.MemoryRecording;
import haltere.testing.StreamRecorder;
import haltere.testing.formats.RandomRecordings.Recording;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * What is written comes back as it was, in every format that there is and from every one to every
 * other, or the writer says what it could not keep.
 */
class RoundTripTest {
  private static final Pattern LEFT_OUT = Pattern.compile("^(\\d+) events? .* left out");

  /** Warning of text writers, whose readers count rows from the top. */
  private static final String ROWS_UP =
      "rows count from the bottom, as in the source; most programs, including this one, read text"
          + " from the top: use --origin top for these";

  @TempDir Path folder;

  private int files;

  static Stream<String> writable() {
    return Recordings.formats().values().stream()
        .filter(RecordingFormat::writable)
        .map(RecordingFormat::name);
  }

  private Path newFile(String format) {
    return folder.resolve("recording-" + files++ + "." + format);
  }

  /** Written recording and its warnings; empty if the writer rejected it. */
  private record Written(Path file, Optional<List<String>> warnings) {}

  private Written convert(RecordingReader from, String to, Conversion conversion)
      throws IOException {
    Path file = newFile(to);
    try (RecordingWriter writer =
        Recordings.formats().get(to).create(file, WriteOptions.of(from.geometry())).orElseThrow()) {
      conversion.run(from, writer);
      return new Written(file, Optional.of(writer.losses()));
    } catch (RecordingProblem refused) {
      assertTrue(refused.getMessage().startsWith(file + ": "), refused.getMessage());
      assertEquals(1, refused.getMessage().lines().count(), refused.getMessage());
      return new Written(file, Optional.empty());
    }
  }

  private static Conversion everything() {
    return part(Long.MIN_VALUE, Long.MAX_VALUE, Optional.empty());
  }

  private static Conversion part(long fromUs, long toUs, Optional<StreamHandler> stage) {
    return new Conversion(fromUs, toUs, stage, ProgressListener.NONE);
  }

  private static RecordingReader open(Path file, SensorGeometry sensor) throws IOException {
    return Recordings.open(file, ReadOptions.DEFAULT.withSensor(sensor));
  }

  private static void assertSize(SensorGeometry sensor, RecordingReader reader, String what) {
    assertEquals(sensor.toString(), reader.geometry().toString(), what);
  }

  private static void assertSamePixels(EventPacket expected, EventPacket got, String what) {
    assertEquals(expected.size(), got.size(), what);
    for (int i = 0; i < expected.size(); i++) {
      assertEquals(expected.address(i), got.address(i), what + ", event " + i);
    }
  }

  /** Reads what was written and compares; times and rows may differ if the writer said so. */
  private void assertKept(Recording recording, Written written, String what) throws IOException {
    List<String> losses = written.warnings().orElseThrow();
    StreamRecorder got = new StreamRecorder();
    List<String> violations;
    try (RecordingReader reader = open(written.file(), recording.sensor())) {
      assertSize(recording.sensor(), reader, what);
      reader.drainTo(got);
      violations = reader.violations().describe();
    }
    EventPacket expected =
        losses.contains(ROWS_UP)
            ? turned(recording.events(), recording.sensor())
            : recording.events();
    long leftOut = leftOut(losses);
    if (leftOut > 0) {
      assertEquals(expected.size(), got.events().size() + leftOut, what + losses);
    } else if (losses.stream().noneMatch(line -> line.contains("read back"))) {
      assertEquals(expected, got.events(), what + losses);
      assertEquals(List.of(), violations, what);
    } else {
      assertSamePixels(expected, got.events(), what + losses);
    }
  }

  /** Number of events that the writer reported as skipped. */
  private static long leftOut(List<String> losses) {
    return losses.stream()
        .map(LEFT_OUT::matcher)
        .filter(Matcher::find)
        .mapToLong(found -> Long.parseLong(found.group(1)))
        .sum();
  }

  private static EventPacket turned(EventPacket events, SensorGeometry sensor) {
    EventPacket turned = new EventPacket(events.size());
    for (int i = 0; i < events.size(); i++) {
      int y = sensor.height() - 1 - events.y(i);
      turned.append(events.timeUs(i), events.x(i), y, events.isOn(i));
    }
    return turned;
  }

  /** Whether nothing is said but that rows count from the bottom, where they do. */
  private static void assertNothingSaid(SensorGeometry source, Written written, String what) {
    List<String> said = written.warnings().orElseThrow();
    boolean fromBottom = source.origin() == Origin.BOTTOM;
    assertTrue(said.isEmpty() || fromBottom && said.equals(List.of(ROWS_UP)), what + said);
  }

  private Written write(Recording recording, String format) throws IOException {
    EventPacket[] stretches =
        recording.events().isEmpty() ? new EventPacket[0] : new EventPacket[] {recording.events()};
    SplittableRandom sizes = new SplittableRandom(recording.events().size());
    return convert(
        new MemoryRecording(recording.sensor(), () -> sizes.nextInt(1, 100), stretches),
        format,
        everything());
  }

  @ParameterizedTest
  @MethodSource("writable")
  void plainRecordingsAreReadBackUnchangedWithoutWarnings(String format) throws IOException {
    for (Recording recording : RandomRecordings.plain()) {
      Written written = write(recording, format);
      String what = format + ", " + recording;
      assertNothingSaid(recording.sensor(), written, what);
      assertKept(recording, written, what);
    }
  }

  @ParameterizedTest
  @MethodSource("writable")
  void lossesOfExtremeRecordingsAreReported(String format) throws IOException {
    for (Recording recording : RandomRecordings.extreme()) {
      Written written = write(recording, format);
      if (written.warnings().isPresent()) {
        assertKept(recording, written, format + ", " + recording);
      }
    }
  }

  @ParameterizedTest
  @MethodSource("writable")
  void guessedSensorSizeIsReported(String format) throws IOException {
    for (Recording recording : RandomRecordings.plain()) {
      Written written = write(recording, format);
      try (RecordingReader reader = Recordings.open(written.file())) {
        boolean same = reader.geometry().toString().equals(recording.sensor().toString());
        boolean said = reader.remarks().stream().anyMatch(line -> line.contains("--sensor"));
        assertTrue(same || said, format + ", " + recording + ": " + reader.remarks());
      }
    }
  }

  @ParameterizedTest
  @MethodSource("writable")
  void recordingsConvertToEveryOtherFormatUnchanged(String format) throws IOException {
    for (Recording original : RandomRecordings.plain()) {
      Recording recording = fromTheTop(original);
      Written first = write(recording, format);
      for (String other : writable().toList()) {
        String what = format + " to " + other + ", " + recording;
        Written second;
        SensorGeometry source;
        try (RecordingReader reader = open(first.file(), recording.sensor())) {
          source = reader.geometry();
          second = convert(reader, other, everything());
        }
        assertNothingSaid(source, second, what);
        assertKept(recording, second, what);
      }
    }
  }

  private static Recording fromTheTop(Recording recording) {
    SensorGeometry sensor = recording.sensor();
    return new Recording(
        recording.name(),
        recording.plain(),
        new SensorGeometry(sensor.width(), sensor.height(), Origin.TOP),
        recording.events());
  }

  @ParameterizedTest
  @MethodSource("writable")
  void timeRangeIsHalfOpenAndFiltersSeeOnlyItsEvents(String format) throws IOException {
    SensorGeometry sensor = new SensorGeometry(240, 180, Origin.TOP);
    EventPacket events = RandomRecordings.random(sensor, 31, 3000, 5000);
    Recording recording = new Recording("to be cut", true, sensor, events);
    Written whole = write(recording, format);
    SplittableRandom random = new SplittableRandom(32);
    long passed = 0;
    long kept = 0;
    for (int i = 0; i < 10; i++) {
      long fromUs = events.timeUs(random.nextInt(events.size())) + random.nextInt(-1, 2);
      long toUs = Math.max(fromUs, events.timeUs(random.nextInt(events.size())));
      EventPacket expected =
          EventPackets.part(events, events.indexAtOrAfter(fromUs), events.indexAtOrAfter(toUs));
      String what = format + ", " + fromUs + " to " + toUs + " us";
      assertKept(
          new Recording("cut", true, sensor, expected),
          cut(whole, sensor, format, part(fromUs, toUs, Optional.empty())),
          what);
      EventPacket left = filtered(sensor, expected);
      passed += expected.size();
      kept += left.size();
      FilterChain chain = chain(sensor);
      assertKept(
          new Recording("cut and filtered", true, sensor, left),
          cut(whole, sensor, format, part(fromUs, toUs, Optional.of(chain))),
          what + ", filtered");
      chain.close();
    }
    assertTrue(kept > 0 && kept < passed, kept + " of " + passed + " events are left");
  }

  private Written cut(Written whole, SensorGeometry sensor, String format, Conversion conversion)
      throws IOException {
    try (RecordingReader reader = open(whole.file(), sensor)) {
      return convert(reader, format, conversion);
    }
  }

  /** Events that a new chain passes; the originals are unchanged. */
  private static EventPacket filtered(SensorGeometry sensor, EventPacket events) {
    EventPacket left = EventPackets.copy(events);
    FilterChain chain = chain(sensor);
    chain.notified(new StreamStarted(sensor, "test"));
    if (!left.isEmpty()) {
      chain.packet(left);
    }
    chain.close();
    return left;
  }

  private static FilterChain chain(SensorGeometry sensor) {
    FilterChain chain = new FilterChain(sensor);
    chain.add(Filters.named("refractory"));
    chain.add(Filters.named("background-activity"));
    return chain;
  }

  @ParameterizedTest
  @MethodSource("writable")
  void rowOriginDoesNotChangeEventsReadBack(String format) throws IOException {
    SensorGeometry sensor = new SensorGeometry(240, 180, Origin.BOTTOM);
    EventPacket events = RandomRecordings.random(sensor, 33, 500, 5000);
    Path file = newFile(format);
    WriteOptions fromTop =
        new WriteOptions(sensor, false, Optional.of(Origin.TOP), Map.of("remark", "none"));
    try (RecordingWriter writer =
        Recordings.formats().get(format).create(file, fromTop).orElseThrow()) {
      writer.write(events);
      assertEquals(List.of(), writer.losses());
      writer.finish();
    }
    StreamRecorder got = new StreamRecorder();
    try (RecordingReader reader = open(file, sensor)) {
      reader.drainTo(got);
    }
    assertEquals(events, got.events(), format);
  }
}
