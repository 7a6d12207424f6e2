package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterEdit;
import haltere.filters.wing.WingFilterEdit.Table;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.testing.wings.RandomFlies;
import haltere.testing.wings.WingScores;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WingTrackerTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final String STEADY = "disturbances.manoeuvres.everyS=0";

  @ParameterizedTest
  @ValueSource(longs = {11, 12})
  void steadyFlightIsTrackedWithinTheStatedAccuracy(long seed) {
    WingScores scores =
        new WingScores(
                Flies.scene(STEADY, "run.seed=" + seed, "fly.body.headingRad=" + seed % 6),
                WingTrackerSettings.defaults().with(Flies.LATENCY))
            .run(0.8);
    assertEquals(0, scores.losses());
    int buffered = WingTrackerSettings.defaults().search().windowUs();
    assertTrue(scores.foundAtUs() <= buffered + 20_000, "found at " + scores.foundAtUs());
    assertTrue(scores.frequencyHz() < 0.15, "frequency " + scores.frequencyHz());
    assertTrue(scores.angleOfStrokeDeg() < 1.2, "angle " + scores.angleDeg());
    assertTrue(scores.reversalDeg() < 2, "reversals " + scores.reversalDeg());
    assertTrue(Math.abs(scores.amplitudeBiasDeg()) < 0.5, "bias " + scores.amplitudeBiasDeg());
    assertTrue(scores.amplitudeDeg() < 1, "amplitude " + scores.amplitudeDeg());
    assertTrue(scores.lagDeg() < 1.5, "lag " + scores.lagDeg());
    assertTrue(scores.centrePx() < 1, "centre " + scores.centrePx());
    assertTrue(scores.headingDeg() < 3, "heading " + scores.headingDeg());
    assertEquals(1, scores.neesFrequency(), 0.35, "standard deviation of the frequency");
    assertTrue(scores.neesAngle() < 2.4, "that of the angle " + scores.neesAngle());
  }

  /** Its stroke was followed wrongly after the first beat, on the way into parts not yet seen. */
  @Test
  void flyWithDenseEventsIsTrackedFromItsFirstBeat() {
    FlyScene scene = new FlyScene(RandomFlies.random(7365));
    WingScores scores = new WingScores(scene, WingTrackerSettings.defaults()).run(0.12);
    assertTrue(scores.foundAtUs() >= 0, "found");
    assertEquals(0, scores.losses());
  }

  @Test
  void slowAndFastBeatsAreFoundWithoutAHint() {
    for (double hz : new double[] {80, 140, 350}) {
      TrackerOutput output =
          TrackerOutput.with(
              Flies.events(0.12, STEADY, "stroke.beat.frequencyHz=" + hz, "run.seed=3"));
      WingEstimate last = output.estimates.get(output.estimates.size() - 1);
      assertEquals(hz, last.frequencyHz(), 0.1 * hz);
    }
  }

  /** Each wing's events leave the place of its hinge along the body open in these scenes. */
  @ParameterizedTest
  @ValueSource(longs = {4126, 6192})
  void headingIsFoundFromEventsAtTheReversalsAlone(long seed) {
    FlyScene scene = new FlyScene(RandomFlies.random(seed));
    WingScores scores = new WingScores(scene, WingTrackerSettings.defaults()).run(0.06);
    assertEquals(0, scores.losses());
    assertTrue(scores.foundAtUs() >= 0, "found");
    double off =
        Angles.wrapPi(
            scores.geometry().headingRad() - scene.truthAt(scores.foundAtUs()).headingRad());
    assertEquals(0, Math.toDegrees(off), 3);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 2})
  void filterAtHalfOrDoubleFrequencyIsDetectedWithin50Ms(double multiple) {
    EventPacket events = Flies.events(0.3, STEADY, "stroke.beat.frequencyHz=190");
    int half = events.indexAtOrAfter(events.firstTimeUs() + 120_000);
    long provokedUs = events.timeUs(half);
    TrackerOutput output = new TrackerOutput();
    WingTracker tracker =
        new WingTracker(TrackerOutput.SENSOR, WingTrackerSettings.defaults(), output);
    tracker.track(part(events, 0, half));
    for (WingFilterState filter : tracker.filters()) {
      double omega = filter.value(Table.STATE, 3, 0);
      tracker.edit(new WingFilterEdit(filter.part(), Table.STATE, 3, 0, multiple * omega));
      // the filter is sure of it, so that it stays there
      tracker.edit(new WingFilterEdit(filter.part(), Table.COVARIANCE, 3, 3, 1e-6));
      tracker.edit(new WingFilterEdit(filter.part(), Table.PROCESS_NOISE, 3, 0, 0));
    }
    tracker.track(part(events, half, events.size()));
    assertTrue(output.phases().contains(Phase.LOST), "it was found out");
    long wrongUntilUs = provokedUs;
    int wrong = 0;
    int right = 0;
    for (WingEstimate e : output.estimates) {
      if (e.timeUs() > provokedUs) {
        if (Math.abs(e.frequencyHz() / 190 - 1) > 0.2) {
          wrong++;
          wrongUntilUs = e.timeUs();
        } else {
          right++;
        }
      }
    }
    assertTrue(wrong > 20, "it was on the wrong multiple");
    assertTrue(wrongUntilUs - provokedUs <= 50_000, "for " + (wrongUntilUs - provokedUs) + " us");
    assertTrue(right > 500, "and then on the right one");
  }

  @ParameterizedTest
  @ValueSource(strings = {"filter.model=WINGS", "filter.model=EDGES", "filter.method=WRA"})
  void wrongStartFrequencyIsDetectedAndTheSearchRepeated(String method) {
    EventPacket fly =
        Flies.events(0.4, STEADY, "stroke.beat.frequencyHz=203", "fly.wing.visibleShare=0.15");
    for (int startHz : new int[] {120, 300, 406}) {
      TrackerOutput output = TrackerOutput.with(fly, method, "search.startFrequencyHz=" + startHz);
      List<WingEstimate> late =
          output.of(WingPart.LEFT).stream().filter(e -> e.timeUs() > 120_000).toList();
      assertTrue(late.size() > 250, startHz + ": " + late.size() + " estimates");
      double mean = late.stream().mapToDouble(WingEstimate::frequencyHz).average().orElse(0);
      assertEquals(203, mean, 8, "started at " + startHz);
    }
  }

  @Test
  void estimatesHaveEventTimesUnlessADelayIsSet() {
    EventPacket fly = Flies.events(0.1, STEADY, "fly.wing.visibleShare=0.15");
    assertEquals(0, WingTrackerSettings.defaults().filter().latencyUs());
    TrackerOutput usual = TrackerOutput.with(fly);
    EventPacket later = new EventPacket(0);
    for (int i = 0; i < fly.size(); i++) {
      later.append(fly.timeUs(i) + 2000, fly.address(i));
    }
    TrackerOutput shifted = TrackerOutput.with(later, "filter.latencyUs=2000");
    WingEstimate now = usual.last(WingPart.LEFT);
    // a camera whose stamps are late by a known delay says the same of the same time
    WingEstimate same =
        shifted.of(WingPart.LEFT).stream()
            .filter(e -> e.timeUs() == now.timeUs())
            .findFirst()
            .orElseThrow();
    assertEquals(now.angleRad(), same.angleRad(), 0.05);
    assertEquals(now.phaseRad(), same.phaseRad(), 0.05);
  }

  private static EventPacket part(EventPacket events, int from, int to) {
    EventPacket part = new EventPacket(to - from);
    part.append(events, from, to);
    return part;
  }

  @Test
  void manualFilterEditsLastUntilItsRestart() {
    TrackerOutput output = new TrackerOutput();
    for (String model : new String[] {"WINGS", "EDGES"}) {
      WingTracker tracker =
          new WingTracker(
              TrackerOutput.SENSOR,
              WingTrackerSettings.defaults().with("filter.model=" + model),
              output);
      EventPacket events = Flies.events(0.09, STEADY);
      int half = events.size() / 2;
      tracker.track(part(events, 0, half));
      WingPart part = tracker.filters().get(0).part();
      tracker.edit(new WingFilterEdit(part, Table.PROCESS_NOISE, 1, 0, 0.25));
      tracker.edit(new WingFilterEdit(part, Table.MEASUREMENT_NOISE, 0, 0, 0.5));
      tracker.edit(new WingFilterEdit(part, Table.STATE, 0, 0, 1.25));
      tracker.edit(new WingFilterEdit(part, Table.COVARIANCE, 0, 0, 0.125));
      WingFilterState now = tracker.filters().get(0);
      assertEquals(1.25, now.x().get(0));
      assertEquals(0.125, now.p().get(0), 1e-12);
      tracker.track(part(events, half, half + 200));
      tracker.apply(tracker.settings().with("output.leftTrailing=false"));
      assertEquals(0.25, tracker.filters().get(0).q().get(1));
      assertEquals(0.5, tracker.filters().get(0).r());
      tracker.apply(tracker.withHeading(tracker.geometry().orElseThrow().headingRad() + 0.05));
      assertEquals(0.25, tracker.filters().get(0).q().get(1), "after the fly was placed by hand");
      assertThrows(
          IllegalArgumentException.class,
          () -> tracker.edit(new WingFilterEdit(part, Table.PROCESS_NOISE, 1, 0, -1)));
      assertThrows(
          IllegalArgumentException.class,
          () -> tracker.edit(new WingFilterEdit(part, Table.COVARIANCE, 0, 1, 1e9)));
      tracker.restart(part);
      assertEquals(
          tracker.settings().noise().amplitude(), tracker.filters().get(0).q().get(1), model);
    }
    WingTracker average =
        new WingTracker(
            TrackerOutput.SENSOR, WingTrackerSettings.defaults().with("filter.method=WRA"), output);
    average.track(Flies.events(0.05, STEADY));
    assertEquals(List.of(), average.filters());
    assertThrows(IllegalArgumentException.class, () -> average.restart(WingPart.LEFT));
  }

  @Test
  void searchStepsArePublishedInOrder() {
    TrackerOutput output = TrackerOutput.with(Flies.events(0.08, STEADY));
    List<Phase> phases = output.states.stream().map(WingTrackerState::phase).toList();
    assertEquals(
        List.of(
            Phase.COLLECTING,
            Phase.TWO_MEANS,
            Phase.BEAT,
            Phase.HINGES,
            Phase.HEAD_AND_TAIL,
            Phase.TRACKING),
        phases);
  }

  @Test
  void exchangedHeadAndTailMirrorSidesAndAngles() {
    EventPacket events = Flies.events(0.15, STEADY);
    TrackerOutput plain = TrackerOutput.with(events);
    TrackerOutput flipped = TrackerOutput.with(events, "position.flipHeading=true");
    assertEquals(
        Math.PI,
        Math.abs(Angles.wrapPi(plain.geometry.headingRad() - flipped.geometry.headingRad())),
        1e-9);
    double left = plain.last(WingPart.LEFT).angleRad();
    double right = flipped.last(WingPart.RIGHT).angleRad();
    assertEquals(Math.PI - left, right, 0.02);
  }

  @Test
  void userPositionsAreOffsetsThatSurviveAReset() {
    EventPacket events = Flies.events(0.1, STEADY);
    TrackerOutput output = new TrackerOutput();
    WingTracker tracker =
        new WingTracker(TrackerOutput.SENSOR, WingTrackerSettings.defaults(), output);
    tracker.track(EventPacket.of(events.timesUs(), events.addresses()));
    FlyGeometry found = output.geometry;
    tracker.apply(tracker.withBodyAt(found.centreX() + 2, found.centreY()));
    tracker.apply(tracker.withHeading(found.headingRad() + 0.1));
    tracker.apply(tracker.withRegion(30));
    tracker.reset();
    tracker.track(events);
    assertEquals(30, tracker.regionPx(), 1);
    assertEquals(found.centreX() + 2, output.geometry.centreX(), 0.5);
    assertEquals(0.1, Angles.wrapPi(output.geometry.headingRad() - found.headingRad()), 0.03);
  }

  @Test
  void manualBodyPositionIsKeptWhileHingesAreFollowed() {
    EventPacket events = Flies.events(0.6, STEADY, "fly.wing.visibleShare=0.15");
    WingTracker plain = TrackerOutput.with(events).tracker;
    FlyGeometry found = plain.geometry().orElseThrow();
    FlyGeometry put =
        TrackerOutput.with(events, "position.bodyOffsetXPx=3", "position.bodyOffsetYPx=-2")
            .tracker
            .geometry()
            .orElseThrow();
    assertEquals(found.centreX() + 3, put.centreX(), 0.7);
    assertEquals(found.centreY() - 2, put.centreY(), 0.7);
  }

  @Test
  void stopsAreDetectedAtEveryRateOfEstimates() {
    EventPacket fly = Flies.events(0.15, STEADY, "fly.wing.visibleShare=0.15");
    EventPacket packet = new EventPacket(0);
    packet.append(fly, 0, fly.size());
    for (int i = 1; i <= 100; i++) {
      packet.append(150_000 + i * 2000L, i % 7, 3, true);
    }
    for (int rateHz : new int[] {1, 70, 1000}) {
      TrackerOutput output = TrackerOutput.with(packet, "output.rateHz=" + rateHz);
      WingTrackerState last = output.states.get(output.states.size() - 1);
      assertEquals(Phase.LOST, last.phase(), rateHz + " Hz");
      assertTrue(last.timeUs() < 220_000, rateHz + " Hz: " + last.timeUs());
    }
  }

  @Test
  void estimateRateIsChangedInFlight() {
    EventPacket fly = Flies.events(0.25, STEADY, "fly.wing.visibleShare=0.15");
    TrackerOutput output = new TrackerOutput();
    WingTracker tracker =
        new WingTracker(TrackerOutput.SENSOR, WingTrackerSettings.defaults(), output);
    int third = fly.size() / 3;
    tracker.track(part(fly, 0, third));
    tracker.apply(tracker.settings().with("output.rateHz=100"));
    tracker.track(part(fly, third, 2 * third));
    tracker.apply(tracker.settings().with("output.rateHz=1000"));
    tracker.track(part(fly, 2 * third, fly.size()));
    List<WingEstimate> left = output.of(WingPart.LEFT);
    long slowFromUs = fly.timeUs(third);
    long slowToUs = fly.timeUs(2 * third);
    for (int i = 1; i < left.size(); i++) {
      long toUs = left.get(i).timeUs();
      long sinceUs = toUs - left.get(i - 1).timeUs();
      boolean slow = toUs > slowFromUs && toUs < slowToUs;
      assertTrue(sinceUs > 0 && sinceUs <= 10_000, sinceUs + " us before " + toUs);
      assertTrue(slow ? toUs % 10_000 == 0 : toUs % 1000 == 0, "on the clock: " + toUs);
    }
    assertTrue(left.stream().filter(e -> e.timeUs() > slowToUs).count() > 70);
  }

  @Test
  void searchStepsOfTheLastSearchAreAvailable() {
    EventPacket fly = Flies.events(0.06, STEADY, "fly.wing.visibleShare=0.15");
    WingTracker tracker = TrackerOutput.with(fly).tracker;
    assertEquals(
        List.of(Phase.TWO_MEANS, Phase.BEAT, Phase.HINGES, Phase.HEAD_AND_TAIL, Phase.TRACKING),
        tracker.searchSteps().stream().map(WingTrackerState::phase).toList());
    tracker.reset();
    assertEquals(List.of(), tracker.searchSteps());
    tracker.track(part(fly, 0, 10));
    assertEquals(
        List.of(Phase.COLLECTING),
        tracker.searchSteps().stream().map(WingTrackerState::phase).toList());
  }

  @Test
  void settingsChangedInFlightKeepTheTrack() {
    EventPacket fly = Flies.events(0.3, STEADY);
    TrackerOutput output = new TrackerOutput();
    WingTracker tracker =
        new WingTracker(TrackerOutput.SENSOR, WingTrackerSettings.defaults(), output);
    String[] changes = {
      "noise.frequency=500", "filter.harmonics=2", "filter.model=EDGES", "filter.model=WINGS"
    };
    int part = fly.size() / (changes.length + 1);
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i <= changes.length; i++) {
      packet.clear();
      packet.append(fly, i * part, (i + 1) * part);
      tracker.track(packet);
      assertEquals(Phase.TRACKING, tracker.phase(), "after " + i + " changes");
      if (i < changes.length) {
        tracker.apply(tracker.settings().with(changes[i]));
      }
    }
  }
}
