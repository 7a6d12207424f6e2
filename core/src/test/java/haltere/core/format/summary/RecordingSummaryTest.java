package haltere.core.format.summary;

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
import haltere.core.format.TimeSegment;
import haltere.core.format.Violation;
import haltere.core.format.WriteOptions;
import haltere.testing.EventPackets;
import haltere.testing.RecordedPackets;
import java.io.IOException;
import java.io.InterruptedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Summary of a recording: counts, times and rates. */
class RecordingSummaryTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(240, 180);

  @TempDir Path folder;

  static List<RecordedPackets> recordings() {
    return RecordedPackets.aedat();
  }

  private Path write(EventPacket... packets) throws IOException {
    Path file = folder.resolve("summary.aedat");
    WriteOptions options = WriteOptions.of(SENSOR).withOverwrite(true);
    try (RecordingWriter writer = Recordings.forWriting(file).create(file, options).orElseThrow()) {
      for (EventPacket packet : packets) {
        writer.write(packet);
      }
      writer.finish();
    }
    return file;
  }

  private RecordingSummary summary(EventPacket... packets) throws IOException {
    try (RecordingReader reader = Recordings.open(write(packets))) {
      return RecordingSummary.scan(reader, ProgressListener.NONE);
    }
  }

  private static EventPacket at(long... timesUs) {
    EventPacket packet = new EventPacket(timesUs.length);
    for (long timeUs : timesUs) {
      packet.append(timeUs, 3, 4, timeUs % 2 == 0);
    }
    return packet;
  }

  @ParameterizedTest
  @MethodSource("recordings")
  void summaryMatchesCountsOfOtherPrograms(RecordedPackets facts) throws IOException {
    try (RecordingReader reader = facts.open()) {
      RecordingSummary summary = RecordingSummary.scan(reader, ProgressListener.NONE);
      assertEquals(facts.format(), summary.format());
      assertEquals(facts.sensor(), summary.geometry());
      assertEquals(facts.events(), summary.events());
      assertEquals(facts.on(), summary.on());
      assertEquals(facts.off(), summary.off());
      assertEquals(facts.firstUs(), summary.firstUs());
      assertEquals(facts.lastUs(), summary.lastUs());
      double durationS = (facts.lastUs() - facts.firstUs()) / 1e6;
      assertEquals(durationS, summary.durationS(), 1e-9);
      assertEquals(facts.events() / durationS, summary.meanRateEps(), 1e-6);
      assertTrue(summary.peakRateEps() >= summary.meanRateEps());
      assertTrue(summary.timestampsMonotonic());
      assertEquals(List.of(), summary.gaps());
      assertEquals(List.of(new TimeSegment(facts.firstUs(), facts.lastUs())), summary.segments());
    }
  }

  @Test
  void warningsStateAssumptionsAndOmissions() throws IOException {
    try (RecordingReader reader = RecordedPackets.ROTATING_DISK.open()) {
      RecordingSummary summary = RecordingSummary.scan(reader, ProgressListener.NONE);
      assertEquals(List.of(), summary.warnings(), "its samples are no damage");
      assertEquals(51_688, reader.violations().count(Violation.OTHER_DATA));
    }
    try (RecordingReader reader = RecordedPackets.ROTATING_BAR.open()) {
      assertEquals(2, warnings(reader).size());
    }
    try (RecordingReader reader = RecordedPackets.WALKING.open()) {
      assertEquals(List.of(), warnings(reader));
    }
  }

  private static List<String> warnings(RecordingReader reader) throws IOException {
    return RecordingSummary.scan(reader, ProgressListener.NONE).warnings();
  }

  @Test
  void peakRateIsThatOfTheBusiestTenMilliseconds() throws IOException {
    RecordingSummary summary =
        summary(at(1000, 2000, 10_999, 11_000, 31_000, 31_001, 36_000, 40_999));
    assertEquals(400, summary.peakRateEps());
    assertEquals(8 / 0.039999, summary.meanRateEps(), 1e-9);
  }

  @Test
  void aRecordingWithoutEventsHasNoTimesAndNoRates() throws IOException {
    RecordingSummary summary = summary();
    assertEquals(0, summary.events());
    assertEquals(0, summary.firstUs());
    assertEquals(0, summary.lastUs());
    assertEquals(0, summary.meanRateEps());
    assertEquals(0, summary.peakRateEps());
    assertEquals(List.of(), summary.segments());
    assertTrue(summary.timestampsMonotonic());
  }

  @Test
  void aSingleEventHasNoMeanRate() throws IOException {
    RecordingSummary summary = summary(at(5));
    assertEquals(0, summary.durationS());
    assertEquals(0, summary.meanRateEps());
    assertEquals(100, summary.peakRateEps());
  }

  @Test
  void silencesOfOneSecondAreGaps() throws IOException {
    RecordingSummary summary = summary(at(0, 999_999, 2_000_000, 3_000_000, 3_000_001));
    assertEquals(
        List.of(new Gap(999_999, 2_000_000, false), new Gap(2_000_000, 3_000_000, false)),
        summary.gaps());
  }

  @Test
  void clockRestartsGiveSegmentsWhoseLengthsAddUp() throws IOException {
    RecordingSummary summary = summary(at(10_000, 20_000), at(100, 5100), at(200));
    assertFalse(summary.timestampsMonotonic());
    assertEquals(0.015, summary.durationS(), 1e-12);
    assertEquals(10_000, summary.firstUs());
    assertEquals(200, summary.lastUs());
    assertEquals(
        List.of(
            new TimeSegment(10_000, 20_000), new TimeSegment(100, 5100), new TimeSegment(200, 200)),
        summary.segments());
    assertEquals(List.of(), summary.gaps());
  }

  @Test
  void progressAscendsToTheSizeOfTheFile() throws IOException {
    Path file = write(EventPackets.uniform(SENSOR, 1, 200_000, 0, 10));
    List<Long> done = new ArrayList<>();
    try (RecordingReader reader = Recordings.open(file)) {
      RecordingSummary.scan(
          reader,
          (doneBytes, totalBytes) -> {
            assertEquals(reader.sizeBytes(), totalBytes);
            assertTrue(done.isEmpty() || done.get(done.size() - 1) < doneBytes);
            done.add(doneBytes);
          });
      assertEquals(reader.sizeBytes(), done.get(done.size() - 1));
    }
    assertTrue(done.size() > 10);
  }

  @Test
  void interruptCancelsAndTheReaderStaysUsable() throws IOException {
    Path file = write(EventPackets.uniform(SENSOR, 1, 200_000, 0, 10));
    try (RecordingReader reader = Recordings.open(file)) {
      assertThrows(
          InterruptedIOException.class,
          () -> RecordingSummary.scan(reader, (done, total) -> Thread.currentThread().interrupt()));
      assertThrows(InterruptedIOException.class, reader::segments);
      assertTrue(Thread.interrupted());
      reader.seek(0);
      assertEquals(200_000, RecordingSummary.scan(reader, ProgressListener.NONE).events());
    } finally {
      Thread.interrupted();
    }
  }

  @Test
  void rateProfileCountsEveryEventOnce() throws IOException {
    EventPacket first = EventPackets.uniform(SENSOR, 2, 30_000, 5_000_000, 10);
    EventPacket second = EventPackets.uniform(SENSOR, 3, 10_000, 1_000_000, 30);
    Path file = write(first, second);
    for (int bins : new int[] {1, 7, 1000}) {
      try (RecordingReader reader = Recordings.open(file)) {
        RateProfile profile = RateProfile.scan(reader, bins);
        long durationUs =
            first.lastTimeUs() - first.firstTimeUs() + second.lastTimeUs() - second.firstTimeUs();
        assertEquals(durationUs, profile.durationUs());
        assertEquals(bins, profile.bins());
        double events = 0;
        for (int bin = 0; bin < bins; bin++) {
          events += profile.eventsPerSecond(bin) * durationUs / 1e6 / bins;
        }
        assertEquals(40_000, events, 1e-6);
      }
    }
    try (RecordingReader reader = Recordings.open(file)) {
      RateProfile profile = RateProfile.scan(reader, 6);
      assertEquals(100_000, profile.eventsPerSecond(0), 5_000, "first segment");
      assertEquals(33_333, profile.eventsPerSecond(5), 2_000, "second segment");
    }
  }

  @Test
  void rateProfileOfAnEmptyRecordingIsZero() throws IOException {
    try (RecordingReader reader = Recordings.open(write())) {
      RateProfile profile = RateProfile.scan(reader, 3);
      assertEquals(0, profile.durationUs());
      assertEquals(0, profile.eventsPerSecond(2));
    }
  }
}
