package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.settings.Parameter;
import haltere.core.settings.SettingsSchema;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.core.stream.Reset;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Inputs without a complete fly lead to a stated phase, and wings are found again. */
class WingBadInputTest {
  private static final String STEADY = "disturbances.manoeuvres.everyS=0";

  @Test
  void emptyArenaKeepsTheTrackerWaiting() {
    TrackerOutput output = TrackerOutput.with(new EventPacket(0));
    assertTrue(output.states.isEmpty());
    TrackerOutput few = TrackerOutput.with(noise(400, 2_000_000, 5));
    assertEquals(Set.of(Phase.COLLECTING), few.phases());
    assertTrue(few.estimates.isEmpty());
  }

  private static EventPacket noise(int events, long lengthUs, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    EventPacket packet = new EventPacket(events);
    for (int i = 0; i < events; i++) {
      packet.append(
          i * (lengthUs / events), random.nextInt(128), random.nextInt(128), random.nextBoolean());
    }
    return packet;
  }

  @Test
  void noiseIsNoFly() {
    TrackerOutput output = TrackerOutput.with(noise(60_000, 400_000, 7));
    assertTrue(output.estimates.isEmpty(), "tracked " + output.phases());
  }

  @Test
  void carIsNoFly() {
    SplittableRandom random = new SplittableRandom(8);
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < 60_000; i++) {
      long timeUs = i * 8L;
      int x = (int) (timeUs / 5000) + random.nextInt(12);
      packet.append(timeUs, Math.min(127, x), 50 + random.nextInt(25), random.nextBoolean());
    }
    TrackerOutput output = TrackerOutput.with(packet);
    assertTrue(output.estimates.isEmpty(), "tracked " + output.phases());
  }

  @Test
  void simultaneousEventsAreNoFlyAndDoNotDisturbTracking() {
    EventPacket fly = Flies.events(0.2, STEADY);
    EventPacket packet = new EventPacket(0);
    packet.append(fly, 0, fly.size() / 2);
    long timeUs = packet.lastTimeUs();
    SplittableRandom random = new SplittableRandom(9);
    for (int i = 0; i < 1_000_000; i++) {
      packet.append(timeUs, random.nextInt(128), random.nextInt(128), random.nextBoolean());
    }
    packet.append(fly, fly.size() / 2, fly.size());
    TrackerOutput output = TrackerOutput.with(packet);
    WingEstimate last = output.last(WingPart.LEFT);
    FlyTruth truth = Flies.scene(STEADY).truthAt(last.timeUs());
    assertEquals(truth.leftFrequencyHz(), last.frequencyHz(), 3);
  }

  @Test
  void eventsOnTheBodyPixelChangeNothing() {
    EventPacket fly = Flies.events(0.2, STEADY, "fly.body.hingeOffsetPx=0");
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < fly.size(); i++) {
      packet.append(fly.timeUs(i), fly.address(i));
      if (i % 20 == 0) {
        packet.append(fly.timeUs(i), 63, 63, i % 40 == 0);
        packet.append(fly.timeUs(i), 64, 64, i % 40 == 0);
      }
    }
    TrackerOutput output = TrackerOutput.with(packet);
    WingEstimate last = output.last(WingPart.RIGHT);
    FlyTruth truth = Flies.scene(STEADY, "fly.body.hingeOffsetPx=0").truthAt(last.timeUs());
    assertEquals(truth.rightFrequencyHz(), last.frequencyHz(), 3);
  }

  @Test
  void stoppedFliesAreLostAndFoundAgain() {
    EventPacket fly = Flies.events(0.15, STEADY);
    EventPacket packet = new EventPacket(0);
    packet.append(fly, 0, fly.size());
    SplittableRandom random = new SplittableRandom(10);
    for (int i = 0; i < 2000; i++) {
      packet.append(150_000 + i * 200L, random.nextInt(128), random.nextInt(128), true);
    }
    for (int i = 0; i < fly.size(); i++) {
      packet.append(600_000 + fly.timeUs(i), fly.address(i));
    }
    TrackerOutput output = TrackerOutput.with(packet);
    List<Phase> phases =
        output.states.stream()
            .map(WingTrackerState::phase)
            .filter(phase -> phase == Phase.TRACKING || phase == Phase.LOST)
            .toList();
    assertEquals(Phase.TRACKING, phases.get(0));
    assertTrue(phases.contains(Phase.LOST), "lost while it stood");
    assertEquals(Phase.TRACKING, phases.get(phases.size() - 1));
    assertTrue(
        output.estimates.stream().noneMatch(e -> e.timeUs() > 220_000 && e.timeUs() < 600_000),
        "says nothing while there are no wings");
  }

  @Test
  void flyIsFoundAgainAfterAReset() {
    EventPacket fly = Flies.events(0.15, STEADY);
    TrackerOutput output = new TrackerOutput();
    WingTracker tracker =
        new WingTracker(TrackerOutput.SENSOR, WingTrackerSettings.defaults(), output);
    tracker.track(fly);
    tracker.reset();
    int before = output.estimates.size();
    tracker.track(fly);
    assertEquals(2 * before, output.estimates.size());
    assertEquals(output.estimates.get(before - 1), output.estimates.get(2 * before - 1));
  }

  @Test
  void otherWingIsTrackedIfOneIsHidden() {
    EventPacket fly = Flies.events(0.2, STEADY);
    FlyTruth truth = Flies.scene(STEADY).truthAt(0);
    EventPacket half = new EventPacket(0);
    for (int i = 0; i < fly.size(); i++) {
      // the default fly looks up: its left wing is on the left of the picture
      if (fly.x(i) < truth.centreXPx()) {
        half.append(fly.timeUs(i), fly.address(i));
      }
    }
    TrackerOutput output = TrackerOutput.with(half);
    assertTrue(output.phases().contains(Phase.ONE_WING), "tracked " + output.phases());
    WingEstimate last = output.estimates.get(output.estimates.size() - 1);
    assertEquals(
        Flies.scene(STEADY).truthAt(last.timeUs()).leftFrequencyHz(), last.frequencyHz(), 3);
  }

  @Test
  void vanishedWingIsLostAndTheOtherStaysTracked() {
    EventPacket fly = Flies.events(0.4, STEADY);
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < fly.size(); i++) {
      boolean hidden = fly.timeUs(i) > 120_000 && fly.timeUs(i) < 250_000 && fly.x(i) > 63;
      if (!hidden) {
        packet.append(fly.timeUs(i), fly.address(i));
      }
    }
    TrackerOutput output = TrackerOutput.with(packet);
    assertTrue(output.phases().contains(Phase.ONE_WING), "tracked " + output.phases());
    assertTrue(
        output.estimates.stream()
            .anyMatch(
                e -> e.edge() == WingPart.LEFT && e.timeUs() > 180_000 && e.timeUs() < 240_000));
    WingTrackerState last = output.states.get(output.states.size() - 1);
    assertEquals(Phase.TRACKING, last.phase(), "both again");
  }

  @Test
  void settingsAtTheirLimitsGiveFiniteResults() {
    EventPacket fly = Flies.events(0.06, STEADY, "fly.wing.visibleShare=0.15");
    for (Parameter parameter : SettingsSchema.of(WingTrackerSettings.class).parameters()) {
      List<?> limits =
          !parameter.choices().isEmpty()
              ? parameter.choices()
              : parameter.type() == boolean.class
                  ? List.of(true, false)
                  : parameter.type() == int.class
                      ? List.of((int) parameter.min(), (int) parameter.max())
                      : List.of(parameter.min(), parameter.max());
      for (Object limit : limits) {
        TrackerOutput output = TrackerOutput.with(fly, parameter.name() + "=" + limit);
        assertTrue(
            EnumSet.of(Phase.COLLECTING, Phase.TRACKING, Phase.UNLOCKED, Phase.ONE_WING, Phase.LOST)
                .contains(output.tracker.phase()),
            parameter.name() + "=" + limit + " ends as " + output.tracker.phase());
      }
    }
  }

  @Test
  void clockRestartsAreDetectedAndTheFlyIsFoundAgain() {
    EventPacket fly = Flies.events(0.1, STEADY, "run.startUs=9000000000");
    EventPacket again = Flies.events(0.1, STEADY, "run.startUs=0");
    WingTrackerFilter filter =
        new WingTrackerFilter(TrackerOutput.SENSOR, WingTrackerSettings.defaults());
    List<WingEstimate> rows = new ArrayList<>();
    filter.outlets().stream()
        .filter(outlet -> outlet.name().equals("wings"))
        .forEach(outlet -> outlet.subscribe(row -> rows.add((WingEstimate) row)));
    filter.process(fly);
    filter.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, fly.lastTimeUs(), again.firstTimeUs()));
    assertEquals(Phase.COLLECTING, filter.tracker().phase());
    filter.process(again);
    assertEquals(Phase.TRACKING, filter.tracker().phase());
    List<WingEstimate> after = rows.stream().filter(e -> e.timeUs() < 1_000_000).toList();
    assertTrue(after.size() > 100, after.size() + " estimates on the new clock");
    WingEstimate last = after.get(after.size() - 1);
    assertEquals(200, last.frequencyHz(), 15);
  }

  @ParameterizedTest
  @ValueSource(strings = {"filter.model=WINGS", "filter.model=EDGES", "filter.method=WRA"})
  void eventsExactlyOnTheHingeChangeNoEstimate(String method) {
    EventPacket fly = Flies.events(0.09, STEADY, "fly.wing.visibleShare=0.15");
    List<WingEstimate> without = withEventsOnTheHinge(fly, method, false);
    assertTrue(without.size() > 100);
    assertEquals(without, withEventsOnTheHinge(fly, method, true));
  }

  private static List<WingEstimate> withEventsOnTheHinge(
      EventPacket fly, String method, boolean with) {
    TrackerOutput output = new TrackerOutput();
    WingTracker tracker =
        new WingTracker(
            TrackerOutput.SENSOR,
            WingTrackerSettings.defaults()
                .with(method, "position.innerRadiusPx=0", "position.followsHinges=false"),
            output);
    int half = fly.size() / 2;
    tracker.track(part(fly, 0, half));
    // a click puts the body on whole pixels
    FlyGeometry now = tracker.geometry().orElseThrow();
    int x = (int) Math.round(now.leftHingeX());
    int y = (int) Math.round(now.leftHingeY());
    tracker.apply(
        tracker.withBodyAt(
            now.centreX() + x - now.leftHingeX(), now.centreY() + y - now.leftHingeY()));
    EventPacket packet = new EventPacket(0);
    for (int i = half; i < fly.size(); i++) {
      packet.append(fly.timeUs(i), fly.address(i));
      if (with) {
        packet.append(fly.timeUs(i), x, y, i % 2 == 0);
      }
    }
    tracker.track(packet);
    return output.estimates;
  }

  private static EventPacket part(EventPacket events, int from, int to) {
    EventPacket part = new EventPacket(to - from);
    part.append(events, from, to);
    return part;
  }
}
