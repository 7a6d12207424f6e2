package haltere.filters.wing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.FlyTruth;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.WingFilterEdit.Table;
import haltere.filters.wing.WingTrackerFilterTest.Flies;
import haltere.filters.wing.WingTrackerState.Phase;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WingTrackerTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final String STEADY = "disturbances.manoeuvres.everyS=0";

  /** What a tracker has said. */
  private static final class Said implements WingListener {
    final List<WingTrackerState> states = new ArrayList<>();
    final List<WingEstimate> estimates = new ArrayList<>();
    final List<WingBeat> beats = new ArrayList<>();
    FlyGeometry geometry;

    @Override
    public void state(WingTrackerState state) {
      states.add(state);
    }

    @Override
    public void estimate(WingEstimate estimate) {
      assertTrue(
          Double.isFinite(
              estimate.angleRad()
                  + estimate.centreRad()
                  + estimate.amplitudeRad()
                  + estimate.phaseRad()
                  + estimate.frequencyHz()),
          estimate::toString);
      estimates.add(estimate);
    }

    @Override
    public void beat(WingBeat beat) {
      beats.add(beat);
    }

    @Override
    public void geometry(FlyGeometry found) {
      geometry = found;
    }

    Set<Phase> phases() {
      Set<Phase> phases = EnumSet.noneOf(Phase.class);
      states.forEach(state -> phases.add(state.phase()));
      return phases;
    }
  }

  private static Said track(EventPacket events, WingTrackerSettings settings) {
    Said said = new Said();
    new WingTracker(SENSOR, settings, said).track(events);
    return said;
  }

  private static Said track(EventPacket events) {
    return track(events, WingTrackerSettings.defaults());
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 12})
  void aSteadyFlyIsTrackedWithinTheFiguresThatTheProjectPromises(long seed) {
    WingScores scores =
        new WingScores(
                Flies.scene(STEADY, "run.seed=" + seed, "fly.body.headingRad=" + seed % 6),
                WingTrackerSettings.defaults())
            .run(0.8);
    assertEquals(0, scores.losses);
    assertTrue(scores.foundAtUs < 60_000, "found at " + scores.foundAtUs);
    assertTrue(scores.frequencyHz() < 0.15, "frequency " + scores.frequencyHz());
    assertTrue(scores.angleOfStrokeDeg() < 1.2, "angle " + scores.angleDeg());
    assertTrue(scores.reversalDeg() < 2, "reversals " + scores.reversalDeg());
    assertTrue(Math.abs(scores.amplitudeBiasDeg()) < 0.5, "bias " + scores.amplitudeBiasDeg());
    assertTrue(scores.amplitudeDeg() < 1, "amplitude " + scores.amplitudeDeg());
    assertTrue(scores.lagDeg() < 1.5, "lag " + scores.lagDeg());
    assertTrue(scores.centrePx() < 1, "centre " + scores.centrePx());
    assertTrue(scores.headingDeg() < 3, "heading " + scores.headingDeg());
  }

  @Test
  void slowAndFastBeatsAreFoundWithoutAHint() {
    for (double hz : new double[] {80, 140, 350}) {
      Said said = track(Flies.events(0.12, STEADY, "stroke.beat.frequencyHz=" + hz, "run.seed=3"));
      WingEstimate last = said.estimates.get(said.estimates.size() - 1);
      assertEquals(hz, last.frequencyHz(), 0.1 * hz);
    }
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.5, 2})
  void aFilterOnHalfOrTwiceTheFrequencyIsFoundOutWithin50Ms(double multiple) {
    EventPacket events = Flies.events(0.3, STEADY, "stroke.beat.frequencyHz=190");
    int half = events.indexAtOrAfter(events.firstTimeUs() + 120_000);
    long provokedUs = events.timeUs(half);
    Said said = new Said();
    WingTracker tracker = new WingTracker(SENSOR, WingTrackerSettings.defaults(), said);
    tracker.track(part(events, 0, half));
    for (WingFilterState filter : tracker.filters()) {
      double omega = filter.value(Table.STATE, 3, 0);
      tracker.edit(new WingFilterEdit(filter.part(), Table.STATE, 3, 0, multiple * omega));
      // the filter is sure of it, so that it stays there
      tracker.edit(new WingFilterEdit(filter.part(), Table.COVARIANCE, 3, 3, 1e-6));
      tracker.edit(new WingFilterEdit(filter.part(), Table.PROCESS_NOISE, 3, 0, 0));
    }
    tracker.track(part(events, half, events.size()));
    assertTrue(said.phases().contains(Phase.LOST), "it was found out");
    long wrongUntilUs = provokedUs;
    int wrong = 0;
    int right = 0;
    for (WingEstimate e : said.estimates) {
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

  private static EventPacket part(EventPacket events, int from, int to) {
    EventPacket part = new EventPacket(to - from);
    part.append(events, from, to);
    return part;
  }

  @Test
  void whatAPersonChangesInAFilterHoldsUntilItIsRestarted() {
    Said said = new Said();
    for (String model : new String[] {"WINGS", "EDGES"}) {
      WingTracker tracker =
          new WingTracker(
              SENSOR, WingTrackerSettings.defaults().with("filter.model=" + model), said);
      EventPacket events = Flies.events(0.09, STEADY);
      int half = events.size() / 2;
      tracker.track(part(events, 0, half));
      WingPart part = tracker.filters().get(0).part();
      tracker.edit(new WingFilterEdit(part, Table.PROCESS_NOISE, 1, 0, 0.25));
      tracker.edit(new WingFilterEdit(part, Table.MEASUREMENT_NOISE, 0, 0, 0.5));
      tracker.edit(new WingFilterEdit(part, Table.STATE, 0, 0, 1.25));
      tracker.edit(new WingFilterEdit(part, Table.COVARIANCE, 0, 0, 0.125));
      WingFilterState now = tracker.filters().get(0);
      assertEquals(1.25, now.x()[0]);
      assertEquals(0.125, now.p()[0], 1e-12);
      tracker.track(part(events, half, half + 200));
      tracker.apply(tracker.settings().with("output.leftTrailing=false"));
      assertEquals(0.25, tracker.filters().get(0).q()[1]);
      assertEquals(0.5, tracker.filters().get(0).r());
      assertThrows(
          IllegalArgumentException.class,
          () -> tracker.edit(new WingFilterEdit(part, Table.PROCESS_NOISE, 1, 0, -1)));
      assertThrows(
          IllegalArgumentException.class,
          () -> tracker.edit(new WingFilterEdit(part, Table.COVARIANCE, 0, 1, 1e9)));
      tracker.restart(part);
      assertEquals(tracker.settings().noise().amplitude(), tracker.filters().get(0).q()[1], model);
    }
    WingTracker average =
        new WingTracker(SENSOR, WingTrackerSettings.defaults().with("filter.method=WRA"), said);
    average.track(Flies.events(0.05, STEADY));
    assertEquals(List.of(), average.filters());
    assertThrows(IllegalArgumentException.class, () -> average.restart(WingPart.LEFT));
  }

  @Test
  void theStepsOfTheSearchArePublishedInOrder() {
    Said said = track(Flies.events(0.08, STEADY));
    List<Phase> phases = said.states.stream().map(WingTrackerState::phase).toList();
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
  void withHeadAndTailExchangedLeftIsRightAndTheAnglesAreMirrored() {
    EventPacket events = Flies.events(0.15, STEADY);
    Said plain = track(events);
    Said flipped = track(events, WingTrackerSettings.defaults().with("place.flipHeading=true"));
    assertEquals(
        Math.PI,
        Math.abs(Angles.wrapPi(plain.geometry.headingRad() - flipped.geometry.headingRad())),
        1e-9);
    double left = last(plain, WingPart.LEFT).angleRad();
    double right = last(flipped, WingPart.RIGHT).angleRad();
    assertEquals(Math.PI - left, right, 0.02);
  }

  private static WingEstimate last(Said said, WingPart part) {
    WingEstimate last = null;
    for (WingEstimate estimate : said.estimates) {
      last = estimate.edge() == part ? estimate : last;
    }
    return last;
  }

  @Test
  void whatAPersonSaysOfThePlaceIsAnOffsetThatOutlivesAReset() {
    EventPacket events = Flies.events(0.1, STEADY);
    Said said = new Said();
    WingTracker tracker = new WingTracker(SENSOR, WingTrackerSettings.defaults(), said);
    tracker.track(EventPacket.of(events.timesUs(), events.addresses()));
    FlyGeometry found = said.geometry;
    tracker.apply(tracker.withBodyAt(found.centreX() + 2, found.centreY()));
    tracker.apply(tracker.withHeading(found.headingRad() + 0.1));
    tracker.apply(tracker.withRegion(30));
    tracker.reset();
    tracker.track(events);
    assertEquals(found.centreX() + 2, said.geometry.centreX(), 0.5);
    assertEquals(0.1, Angles.wrapPi(said.geometry.headingRad() - found.headingRad()), 0.03);
  }

  @Test
  void anEmptyArenaIsWaitedIn() {
    Said said = track(new EventPacket(0));
    assertTrue(said.states.isEmpty());
    Said few = track(noise(400, 2_000_000, 5));
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
  void noiseAloneIsNoFly() {
    Said said = track(noise(60_000, 400_000, 7));
    assertTrue(said.estimates.isEmpty(), "tracked " + said.phases());
  }

  @Test
  void aCarIsNoFly() {
    SplittableRandom random = new SplittableRandom(8);
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < 60_000; i++) {
      long timeUs = i * 8L;
      int x = (int) (timeUs / 5000) + random.nextInt(12);
      packet.append(timeUs, Math.min(127, x), 50 + random.nextInt(25), random.nextBoolean());
    }
    Said said = track(packet);
    assertTrue(said.estimates.isEmpty(), "tracked " + said.phases());
  }

  @Test
  void aMillionEventsAtOneTimeAreNoFlyAndDoNotHarmOne() {
    EventPacket fly = Flies.events(0.2, STEADY);
    EventPacket packet = new EventPacket(0);
    packet.append(fly, 0, fly.size() / 2);
    long timeUs = packet.lastTimeUs();
    SplittableRandom random = new SplittableRandom(9);
    for (int i = 0; i < 1_000_000; i++) {
      packet.append(timeUs, random.nextInt(128), random.nextInt(128), random.nextBoolean());
    }
    packet.append(fly, fly.size() / 2, fly.size());
    Said said = track(packet);
    WingEstimate last = last(said, WingPart.LEFT);
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
    Said said = track(packet);
    WingEstimate last = last(said, WingPart.RIGHT);
    FlyTruth truth = Flies.scene(STEADY, "fly.body.hingeOffsetPx=0").truthAt(last.timeUs());
    assertEquals(truth.rightFrequencyHz(), last.frequencyHz(), 3);
  }

  @Test
  void aFlyThatStopsIsLostAndFoundAgainWhenItStarts() {
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
    Said said = track(packet);
    List<Phase> phases =
        said.states.stream()
            .map(WingTrackerState::phase)
            .filter(phase -> phase == Phase.TRACKING || phase == Phase.LOST)
            .toList();
    assertEquals(Phase.TRACKING, phases.get(0));
    assertTrue(phases.contains(Phase.LOST), "lost while it stood");
    assertEquals(Phase.TRACKING, phases.get(phases.size() - 1));
    assertTrue(
        said.estimates.stream().noneMatch(e -> e.timeUs() > 220_000 && e.timeUs() < 600_000),
        "says nothing while there are no wings");
  }

  @Test
  void aResetInFlightFindsTheFlyAgain() {
    EventPacket fly = Flies.events(0.15, STEADY);
    Said said = new Said();
    WingTracker tracker = new WingTracker(SENSOR, WingTrackerSettings.defaults(), said);
    tracker.track(fly);
    tracker.reset();
    int before = said.estimates.size();
    tracker.track(fly);
    assertEquals(2 * before, said.estimates.size());
    assertEquals(said.estimates.get(before - 1), said.estimates.get(2 * before - 1));
  }

  @Test
  void withOneWingHiddenTheOtherIsTracked() {
    EventPacket fly = Flies.events(0.2, STEADY);
    FlyTruth truth = Flies.scene(STEADY).truthAt(0);
    EventPacket half = new EventPacket(0);
    for (int i = 0; i < fly.size(); i++) {
      // the default fly looks up: its left wing is on the left of the picture
      if (fly.x(i) < truth.centreXPx()) {
        half.append(fly.timeUs(i), fly.address(i));
      }
    }
    Said said = track(half);
    assertTrue(said.phases().contains(Phase.ONE_WING), "tracked " + said.phases());
    WingEstimate last = said.estimates.get(said.estimates.size() - 1);
    assertEquals(
        Flies.scene(STEADY).truthAt(last.timeUs()).leftFrequencyHz(), last.frequencyHz(), 3);
  }

  @Test
  void aWingThatVanishesInFlightIsLostAndTheOtherKept() {
    EventPacket fly = Flies.events(0.4, STEADY);
    EventPacket packet = new EventPacket(0);
    for (int i = 0; i < fly.size(); i++) {
      boolean hidden = fly.timeUs(i) > 120_000 && fly.timeUs(i) < 250_000 && fly.x(i) > 63;
      if (!hidden) {
        packet.append(fly.timeUs(i), fly.address(i));
      }
    }
    Said said = track(packet);
    assertTrue(said.phases().contains(Phase.ONE_WING), "tracked " + said.phases());
    assertTrue(
        said.estimates.stream()
            .anyMatch(
                e -> e.edge() == WingPart.LEFT && e.timeUs() > 180_000 && e.timeUs() < 240_000));
    WingTrackerState last = said.states.get(said.states.size() - 1);
    assertEquals(Phase.TRACKING, last.phase(), "both again");
  }

  @Test
  void settingsAtTheirLimitsEndInNumbers() {
    EventPacket fly = Flies.events(0.12, STEADY);
    for (String limit :
        List.of(
            "noise.frequency=1000000",
            "noise.frequency=0",
            "noise.centre=1000",
            "noise.measurement=100000",
            "noise.hingePx2PerS=1000",
            "noise.rateSd=100000",
            "filter.harmonics=1",
            "filter.harmonics=4",
            "filter.latencyUs=2000",
            "filter.averagingUs=0",
            "filter.averagingUs=500",
            "filter.gateSd=2",
            "filter.gateSd=1000",
            "filter.firstOfRun=false",
            "filter.model=EDGES",
            "filter.method=WRA",
            "average.mixingFactor=1",
            "average.timeConstantUs=100000",
            "place.innerRadiusPx=200",
            "place.regionOffsetPx=-500",
            "place.bodyOffsetXPx=1000",
            "search.startFrequencyHz=1000",
            "output.rateHz=100000",
            "output.leftLeading=false")) {
      track(fly, WingTrackerSettings.defaults().with(limit));
    }
  }

  @Test
  void settingsChangedInFlightKeepTheTrack() {
    EventPacket fly = Flies.events(0.3, STEADY);
    Said said = new Said();
    WingTracker tracker = new WingTracker(SENSOR, WingTrackerSettings.defaults(), said);
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

  @Test
  void theRunningAverageCountsTheBeats() {
    Said said =
        track(
            Flies.events(0.5, STEADY, "stroke.beat.frequencySdHz=0"),
            WingTrackerSettings.defaults().with("filter.method=WRA"));
    List<WingBeat> late =
        said.beats.stream().filter(b -> b.timeUs() > 100_000 && b.side() == WingSide.LEFT).toList();
    assertEquals(80, late.size(), 3);
    double mean = late.stream().mapToDouble(WingBeat::frequencyHz).average().orElse(0);
    assertEquals(200, mean, 1);
  }

  @Test
  void theOriginalsMethodRunsWithItsOwnStart() {
    WingTrackerSettings original = WingTrackerSettings.original();
    assertEquals(WingModel.EDGES, original.filter().model());
    assertEquals(240, original.search().startFrequencyHz());
    Said said = track(Flies.events(0.2, STEADY, "stroke.beat.frequencyHz=235"), original);
    assertTrue(said.phases().contains(Phase.TRACKING));
  }
}
