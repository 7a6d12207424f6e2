package haltere.core.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.Origin;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.testing.RecordedPackets;
import haltere.testing.RecordedPackets.EventRow;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every recording of the catalogue yields the events that other programs read. */
class RecordedCatalogueTest {
  static List<RecordedPackets> recordings() {
    return Stream.of(
            RecordedPackets.aedat(),
            RecordedPackets.dv(),
            RecordedPackets.hdf5(),
            RecordedPackets.ros(),
            RecordedPackets.prophesee(),
            RecordedPackets.dataSets())
        .flatMap(List::stream)
        .toList();
  }

  @ParameterizedTest
  @MethodSource("recordings")
  void recordingsYieldTheSameEventsAsInOtherPrograms(RecordedPackets facts) throws IOException {
    StreamRecorder recorder = new StreamRecorder();
    try (RecordingReader reader = facts.open()) {
      assertEquals(facts.format(), reader.formatName());
      assertEquals(facts.sensor(), reader.geometry());
      reader.drainTo(new StreamGrammar(recorder));
      assertEquals(
          facts.otherWords(), reader.violations().count(Violation.OTHER_DATA), "other words");
      assertEquals(0, reader.violations().count(Violation.CUT_OFF));
      assertEquals(reader.sizeBytes(), reader.positionBytes());
    }
    EventPacket events = recorder.events();
    int size = events.size();
    assertEquals(facts.events(), size);
    assertEquals(facts.on(), IntStream.range(0, size).filter(events::isOn).count(), "ON events");
    assertEquals(facts.head(), rows(facts, events, 0, 5));
    assertEquals(facts.tail(), rows(facts, events, size - 2, size));
    assertEquals(facts.firstUs(), events.firstTimeUs());
    assertEquals(facts.lastUs(), events.lastTimeUs());
    assertEquals(facts.minX(), IntStream.range(0, size).map(events::x).min().orElseThrow());
    assertEquals(facts.maxX(), IntStream.range(0, size).map(events::x).max().orElseThrow());
    assertEquals(
        facts.minY(), IntStream.range(0, size).map(i -> y(facts, events, i)).min().orElseThrow());
    assertEquals(
        facts.maxY(), IntStream.range(0, size).map(i -> y(facts, events, i)).max().orElseThrow());
    assertEquals(facts.crc32(), recorder.crc32(facts.sensor()));
    assertTrue(recorder.notifications(Reset.class).isEmpty());
  }

  /** The row as the source counts it. */
  private static int y(RecordedPackets facts, EventPacket events, int index) {
    int y = events.y(index);
    return facts.sensor().origin() == Origin.TOP ? facts.sensor().height() - 1 - y : y;
  }

  private static List<EventRow> rows(RecordedPackets facts, EventPacket events, int from, int to) {
    return IntStream.range(from, to)
        .mapToObj(
            i ->
                new EventRow(
                    events.timeUs(i), events.x(i), y(facts, events, i), events.isOn(i) ? 1 : 0))
        .toList();
  }
}
