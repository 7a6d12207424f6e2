package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlyTruth;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingFilterState;
import haltere.filters.wing.WingModel;
import haltere.filters.wing.WingPair;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState.Phase;
import haltere.testing.wings.WingScores;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Effects of the settings of the methods. */
class WingMethodsTest {
  private static final String STEADY = "disturbances.manoeuvres.everyS=0";
  private static final String EVEN = "stroke.beat.frequencySdHz=0";
  private static final String SPARSE = "fly.wing.visibleShare=0.15";

  private static WingScores[] scores(FlyScene scene, double seconds, String... settings) {
    WingScores[] scores = new WingScores[settings.length];
    for (int i = 0; i < settings.length; i++) {
      scores[i] =
          new WingScores(
              scene,
              WingTrackerSettings.defaults().with(Flies.LATENCY).with(settings[i].split(";")));
    }
    WingScores.run(scene, seconds, scores);
    return scores;
  }

  @Test
  void harmonicsFollowANonSinusoidalStroke() {
    WingScores[] by =
        scores(
            Flies.scene(STEADY, SPARSE, "stroke.beat.waveform=CHEN_SUN"),
            0.6,
            "filter.harmonics=1",
            "filter.harmonics=2",
            "filter.harmonics=3",
            "filter.harmonics=4");
    assertTrue(by[0].angleDeg() > 3, "one harmonic " + by[0].angleDeg());
    assertTrue(by[1].angleDeg() < 0.7 * by[0].angleDeg(), "two " + by[1].angleDeg());
    assertTrue(by[2].angleDeg() < 0.7 * by[1].angleDeg(), "three " + by[2].angleDeg());
    assertTrue(by[3].angleDeg() < 1.2 * by[2].angleDeg(), "four " + by[3].angleDeg());
  }

  @Test
  void sameSettingsFollowManoeuvresAndSteadyFlight() {
    String[] both = {"filter.harmonics=3", "noise.manoeuvre=0"};
    String often = "disturbances.manoeuvres.everyS=1.3";
    String few = "fly.wing.visibleShare=0.04";
    WingScores usual = scores(Flies.scene(often, few, "run.seed=5"), 0.8, both[0])[0];
    assertTrue(usual.frequencyHz() < 0.6, "by 15 Hz " + usual.frequencyHz());
    WingScores[] large =
        scores(
            Flies.scene(often, few, "run.seed=5", "disturbances.manoeuvres.frequencyStepHz=45"),
            0.8,
            both);
    assertTrue(
        large[1].frequencyHz() > 1.4 * large[0].frequencyHz(),
        "by 45 Hz " + large[0].frequencyHz() + ", steady noise alone " + large[1].frequencyHz());
    WingScores[] steady = scores(Flies.scene(STEADY, few, "run.seed=5"), 0.7, both);
    assertTrue(steady[0].frequencyHz() < 0.15, "adaptive " + steady[0].frequencyHz());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 10})
  void edgeFiltersKeepTheFlyThroughAManoeuvre(int averaged) {
    WingScores scores =
        scores(
            Flies.scene(SPARSE, "disturbances.manoeuvres.everyS=1.3", "run.seed=5"),
            0.7,
            "filter.model=EDGES;filter.averagedEvents=" + averaged)[0];
    assertEquals(0, scores.losses());
    assertTrue(scores.frequencyHz() < 1.2, "frequency " + scores.frequencyHz());
    assertTrue(scores.angleDeg() < 6, "angle " + scores.angleDeg());
  }

  @Test
  void halfWidthOfTheWingIsEstimated() {
    TrackerOutput output = TrackerOutput.with(Flies.events(0.3, STEADY, SPARSE));
    for (WingFilterState filter : output.tracker.filters()) {
      assertEquals(0.03, filter.x().get(filter.names().indexOf("half width")), 0.012);
    }
  }

  @Test
  void knownLatencyShiftsThePhase() {
    EventPacket fly = Flies.events(0.15, STEADY, SPARSE);
    WingEstimate none = TrackerOutput.with(fly, "filter.latencyUs=0").last(WingPart.LEFT);
    WingEstimate known = TrackerOutput.with(fly, "filter.latencyUs=200").last(WingPart.LEFT);
    assertEquals(
        2 * Math.PI * none.frequencyHz() * 200e-6,
        Angles.wrapPi(known.phaseRad() - none.phaseRad()),
        1e-6);
    assertNotEquals(none.angleRad(), known.angleRad());
  }

  @Test
  void eventsAreAveragedBeforeAnEdgeUpdate() {
    EventPacket fly = Flies.events(0.12, STEADY, SPARSE);
    int most = fly.size() - 400;
    for (int averaged : new int[] {1, 100}) {
      TrackerOutput output = new TrackerOutput();
      WingTracker tracker =
          new WingTracker(
              TrackerOutput.SENSOR,
              WingTrackerSettings.defaults()
                  .with("filter.model=EDGES", "filter.averagedEvents=" + averaged),
              output);
      EventPacket part = new EventPacket(0);
      part.append(fly, 0, most);
      tracker.track(part);
      int updates = 0;
      double before = tracker.filters().get(0).x().get(0);
      long events = tracker.filters().get(0).events();
      for (int i = most; i < fly.size(); i++) {
        part.clear();
        part.append(fly, i, i + 1);
        tracker.track(part);
        double now = tracker.filters().get(0).x().get(0);
        updates += now == before ? 0 : 1;
        before = now;
      }
      events = tracker.filters().get(0).events() - events;
      assertTrue(events > 20, events + " events of the edge");
      assertEquals((double) events / averaged, updates, averaged == 1 ? 2 : 1);
    }
  }

  @Test
  void averagedUpdatesEqualSingleUpdates() {
    EventPacket fly = Flies.events(0.3, STEADY, SPARSE);
    WingEstimate each = TrackerOutput.with(fly, "filter.averagingUs=0").last(WingPart.RIGHT);
    WingEstimate together = TrackerOutput.with(fly, "filter.averagingUs=50").last(WingPart.RIGHT);
    assertEquals(each.frequencyHz(), together.frequencyHz(), 0.15);
    assertEquals(each.angleRad(), together.angleRad(), 0.01);
  }

  @Test
  void pairResultsAreDifferenceAndSumOfBothWings() {
    double lag = 0.2;
    TrackerOutput output =
        TrackerOutput.with(Flies.events(0.2, STEADY, "stroke.right.phaseLagRad=" + lag));
    WingPair pair = output.pairs.get(output.pairs.size() - 1);
    WingEstimate left = output.last(WingPart.LEFT);
    WingEstimate right = output.last(WingPart.RIGHT);
    assertEquals(left.angleRad() - right.angleRad(), pair.leftMinusRightRad(), 1e-9);
    assertEquals(left.angleRad() + right.angleRad(), pair.leftPlusRightRad(), 1e-9);
    assertEquals(
        left.amplitudeRad() - right.amplitudeRad(), pair.amplitudeLeftMinusRightRad(), 1e-9);
    assertEquals(
        left.amplitudeRad() + right.amplitudeRad(), pair.amplitudeLeftPlusRightRad(), 1e-9);
    assertEquals(-lag, pair.phaseLagRad(), 0.04);
    WingBeat beat = output.beats.get(output.beats.size() - 1);
    assertEquals(beat.side() == WingPart.RIGHT ? lag : -lag, beat.phaseLagRad(), 0.04);
  }

  @Test
  void runningAverageCountsBeatsOfWideAndNarrowStrokes() {
    for (double amplitude : new double[] {0.55, 1.3}) {
      String set = "stroke.%s.amplitudeRad=" + amplitude;
      EventPacket fly =
          Flies.events(0.4, STEADY, EVEN, String.format(set, "left"), String.format(set, "right"));
      TrackerOutput output = TrackerOutput.with(fly, "filter.method=WRA");
      List<WingBeat> late =
          output.beats.stream()
              .filter(b -> b.timeUs() > 100_000 && b.side() == WingPart.LEFT)
              .toList();
      assertEquals(60, late.size(), 1, "beats with an amplitude of " + amplitude);
      double mean = late.stream().mapToDouble(WingBeat::frequencyHz).average().orElse(0);
      assertEquals(200, mean, 1);
      double found = late.stream().mapToDouble(WingBeat::amplitudeRad).average().orElse(0);
      assertTrue(
          found > 0.7 * amplitude && found < 1.1 * amplitude, found + " rad for " + amplitude);
    }
  }

  @Test
  void averageByTimeDoesNotDependOnTheEventRate() {
    String[] byTime = {"filter.method=WRA", "average.timeConstantUs=300"};
    double few =
        TrackerOutput.with(Flies.events(0.3, STEADY, EVEN, SPARSE), byTime)
            .last(WingPart.LEFT)
            .amplitudeRad();
    double many =
        TrackerOutput.with(Flies.events(0.3, STEADY, EVEN, "fly.wing.visibleShare=0.6"), byTime)
            .last(WingPart.LEFT)
            .amplitudeRad();
    assertEquals(many, few, 0.06);
    double slow =
        TrackerOutput.with(
                Flies.events(0.3, STEADY, EVEN, SPARSE),
                "filter.method=WRA",
                "average.timeConstantUs=1500")
            .last(WingPart.LEFT)
            .amplitudeRad();
    assertTrue(slow < 0.8 * few, "a long time constant flattens the stroke: " + slow);
  }

  @Test
  void manualBodyOffsetIsKeptWhileBodyAndHeadingFollowBeats() {
    EventPacket fly = Flies.events(0.4, STEADY, SPARSE);
    String[] follow = {
      "filter.method=WRA", "average.bodyUpdate=true", "average.headingUpdate=true"
    };
    FlyGeometry plain = TrackerOutput.with(fly, follow).tracker.geometry().orElseThrow();
    WingTrackerSettings output =
        WingTrackerSettings.defaults().with(follow).with("position.bodyOffsetXPx=3");
    FlyGeometry put = TrackerOutput.of(fly, output).tracker.geometry().orElseThrow();
    assertEquals(plain.centreX() + 3, put.centreX(), 0.3);
    assertEquals(plain.centreY(), put.centreY(), 0.3);
    FlyGeometry still = TrackerOutput.with(fly, "filter.method=WRA").geometry;
    assertTrue(
        Math.hypot(still.centreX() - plain.centreX(), still.centreY() - plain.centreY()) > 0.5,
        "the body has moved between the mean places of the wings' events");
  }

  @Test
  void headingFollowsBeatsWhileTheBodyStays() {
    // wings that stroke about unlike centres are not across from each other
    EventPacket fly = Flies.events(0.4, STEADY, SPARSE, "stroke.left.centreRad=1.3");
    TrackerOutput still = TrackerOutput.with(fly, "filter.method=WRA");
    FlyGeometry follows =
        TrackerOutput.with(fly, "filter.method=WRA", "average.headingUpdate=true")
            .tracker
            .geometry()
            .orElseThrow();
    assertEquals(still.geometry.centreX(), follows.centreX(), 1e-9);
    assertEquals(still.geometry.centreY(), follows.centreY(), 1e-9);
    double found = still.geometry.headingRad();
    assertEquals(found, still.tracker.geometry().orElseThrow().headingRad(), 1e-9);
    assertTrue(
        Math.abs(Angles.wrapPi(follows.headingRad() - found)) > 0.005,
        "turned towards across the mean places of the wings' events");
  }

  @Test
  void originalPresetKeepsAFlyNearItsStart() {
    WingTrackerSettings original = WingTrackerSettings.original();
    assertEquals(WingModel.ORIGINAL, original.filter().model());
    assertEquals(2000, original.search().minEvents());
    assertEquals(240, original.search().startFrequencyHz());
    EventPacket fly = Flies.events(0.5, STEADY, EVEN, "stroke.beat.frequencyHz=235");
    TrackerOutput output = TrackerOutput.of(fly, original);
    assertEquals(Phase.TRACKING, output.lastPhase());
    List<WingFilterState> filters = output.tracker.filters();
    assertEquals(
        List.of(
            WingPart.LEFT_LEADING,
            WingPart.LEFT_TRAILING,
            WingPart.RIGHT_LEADING,
            WingPart.RIGHT_TRAILING),
        filters.stream().map(WingFilterState::part).toList());
    for (WingFilterState filter : filters) {
      assertEquals(List.of("centre", "amplitude", "phase", "angular frequency"), filter.names());
      assertEquals(1000, filter.r());
      assertEquals(2, filter.q().get(0));
      assertEquals(2, filter.q().get(3), "at each update");
    }
    FlyScene truth = Flies.scene(STEADY, EVEN, "stroke.beat.frequencyHz=235");
    double squares = 0;
    List<WingEstimate> late =
        output.of(WingPart.LEFT).stream().filter(e -> e.timeUs() > 335_000).toList();
    for (WingEstimate e : late) {
      FlyTruth now = truth.truthAt(e.timeUs());
      squares += Math.pow(Angles.wrapPi(e.angleRad() - now.leftAngleRad()), 2);
      assertEquals(235, e.frequencyHz(), 15);
    }
    double rms = Math.toDegrees(Math.sqrt(squares / late.size()));
    assertTrue(rms > 3 && rms < 15, "as good as the source, not as the defaults: " + rms);
  }
}
