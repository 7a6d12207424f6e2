package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.testing.Recorded;
import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class LabelledRecordingTest {
  private static final long NEAR_US = 50_000;

  static Stream<LabelledRecording> withObjectsInsideThePicture() {
    return LabelledRecording.all().stream().filter(one -> !one.file().startsWith("davis240c"));
  }

  @ParameterizedTest
  @MethodSource("withObjectsInsideThePicture")
  void eventsAreDenserInBoxesThanElsewhere(LabelledRecording recording) throws IOException {
    Recorded.file(recording.file());
    Footage footage = recording.footage();
    EventPacket events = footage.events();
    long inside = 0;
    long outside = 0;
    double insideArea = 0;
    double outsideArea = 0;
    for (TruthMoment moment : footage.truth()) {
      if (moment.objects().isEmpty()) {
        continue;
      }
      for (int i = events.indexAtOrAfter(moment.timeUs() - NEAR_US);
          i < events.size() && events.timeUs(i) < moment.timeUs() + NEAR_US;
          i++) {
        int x = events.x(i);
        int y = events.y(i);
        if (moment.objects().stream().anyMatch(o -> o.box().contains(x, y, 0.5))) {
          inside++;
        } else if (moment.ignored().stream().noneMatch(box -> box.contains(x, y, 0.5))) {
          outside++;
        }
      }
      double boxes =
          moment.objects().stream()
              .mapToDouble(o -> (o.box().width() + 1) * (o.box().height() + 1))
              .sum();
      insideArea += boxes;
      outsideArea += footage.geometry().pixels() - boxes;
    }
    double ratio = inside / insideArea * outsideArea / outside;
    assertTrue(ratio > 4, recording.file() + ": " + ratio);
  }

  @Test
  void labelsAscendInTime() throws IOException {
    for (LabelledRecording recording : LabelledRecording.all()) {
      List<TruthMoment> labels = LabelledBoxes.of(recording.file());
      for (int i = 1; i < labels.size(); i++) {
        assertTrue(labels.get(i).timeUs() > labels.get(i - 1).timeUs(), recording.file());
      }
      assertTrue(labels.size() >= 10, recording.file());
    }
  }

  @Test
  void footageThatRunsBackAndForthMirrorsItsTimesAndPolarities() {
    EventPacket events = new EventPacket(2);
    events.append(100, 1, 2, true);
    events.append(130, 3, 4, false);
    TruthMoment early = new TruthMoment(110, List.of(), List.of());
    TruthMoment late = new TruthMoment(120, List.of(), List.of());
    Footage once = new Footage(new SensorGeometry(8, 8), events, List.of(early, late));
    Footage both = once.then(once.reversed(140));
    assertEquals(4, both.events().size());
    assertEquals(150, both.events().timeUs(2));
    assertEquals(3, both.events().x(2));
    assertTrue(both.events().isOn(2));
    assertEquals(180, both.events().timeUs(3));
    assertEquals(
        List.of(110L, 120L, 160L, 170L), both.truth().stream().map(TruthMoment::timeUs).toList());
  }
}
