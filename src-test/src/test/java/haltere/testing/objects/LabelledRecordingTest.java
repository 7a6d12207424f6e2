package haltere.testing.objects;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EventSource;
import haltere.testing.Recorded;
import haltere.testing.SceneEvents;
import java.io.IOException;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class LabelledRecordingTest {
  static Stream<LabelledRecording> withObjectsInsideThePicture() {
    return LabelledRecording.all().stream().filter(one -> !one.file().startsWith("davis240c"));
  }

  @ParameterizedTest
  @MethodSource("withObjectsInsideThePicture")
  void eventsAreDenserInObjectBoxesThanElsewhere(LabelledRecording recording) throws IOException {
    Recorded.file(recording.file());
    double ratio = EventDensity.of(recording.scene()).ratio();
    assertTrue(ratio > 4, recording.file() + ": " + ratio);
  }

  @Test
  void boxesOfABackwardsRecordingAreWhereItsEventsAre() throws IOException {
    LabelledRecording recording = LabelledRecording.all().get(0);
    Recorded.file(recording.file());
    ObjectScene backwards = recording.backwards();
    double ratio = EventDensity.of(backwards).ratio();
    assertEquals(EventDensity.of(recording.scene()).ratio(), ratio, 0.05 * ratio);
    assertEquals(recording.scene().truth().size(), backwards.truth().size());
  }

  @Test
  void labelTimesAscend() throws IOException {
    for (LabelledRecording recording : LabelledRecording.all()) {
      List<TruthMoment> labels = LabelledBoxes.of(recording.file());
      for (int i = 1; i < labels.size(); i++) {
        assertTrue(labels.get(i).timeUs() > labels.get(i - 1).timeUs(), recording.file());
      }
      assertTrue(labels.size() >= 10, recording.file());
    }
  }

  @Test
  void partOfARecordingStartsLaterWithNineTenthsOfTheEvents() throws IOException {
    LabelledRecording recording = LabelledRecording.all().get(0);
    Recorded.file(recording.file());
    ObjectScene part = recording.part(1);
    EventPacket events;
    try (EventSource source = part.events().open()) {
      events = SceneEvents.of(source);
    }
    Footage whole = recording.footage();
    long fromUs = events.firstTimeUs();
    EventPacket rest = whole.between(fromUs, Long.MAX_VALUE).events();
    assertTrue(fromUs > whole.events().firstTimeUs());
    assertEquals(0.9, events.size() / (double) rest.size(), 0.01);
    assertTrue(part.truth().get(0).timeUs() >= fromUs);
    assertEquals(part.truth(), recording.part(1).truth());
  }

  @Test
  void stretchedAndMirroredFootageKeepsEventsInTheirBoxes() {
    Footage changed = twoEvents().stretched(2).mirrored();
    assertEquals(160, changed.events().timeUs(1));
    assertEquals(4, changed.events().x(1));
    assertEquals(120, changed.truth().get(0).timeUs());
    assertTrue(changed.truth().get(0).objects().get(0).box().contains(4, 4, 0));
  }

  @Test
  void noiseComesBetweenTheEventsAtItsRate() {
    EventPacket events = new EventPacket(2);
    events.append(0, 1, 2, true);
    events.append(10_000_000, 3, 4, false);
    Footage clean = new Footage(new SensorGeometry(8, 8), events, List.of());
    EventPacket noisy = clean.withNoise(2, new SplittableRandom(1)).events();
    assertEquals(2 * 64 * 10, noisy.size(), 100);
    for (int i = 1; i < noisy.size(); i++) {
      assertTrue(noisy.timeUs(i) >= noisy.timeUs(i - 1));
    }
  }

  private static Footage twoEvents() {
    EventPacket events = new EventPacket(2);
    events.append(100, 1, 2, true);
    events.append(130, 3, 4, false);
    TrueObject object = new TrueObject(0, new Box(2, 3, 4, 5));
    TruthMoment moment = new TruthMoment(110, List.of(object), List.of());
    return new Footage(new SensorGeometry(8, 8), events, List.of(moment));
  }

  @Test
  void reversedFootageMirrorsTimesAndPolarities() {
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
