package haltere.core.simulation.internal.fly;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.SceneRuns;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.testing.Allocation;
import haltere.testing.StreamRecorder;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The event stream of the fly scene. */
class FlySceneTest {
  private static final StreamHandler NOBODY =
      new StreamHandler() {
        @Override
        public void packet(EventPacket packet) {}

        @Override
        public void notified(StreamNotification notification) {}
      };

  @Test
  void eventsAreReproducibleOnEveryMachine() {
    StreamRecorder events = SceneRuns.record(new FlyScene(SceneRuns.fly("run.durationS=0.1")));

    assertEquals("425650ad of 46450", events.crc32() + " of " + events.events().size());
  }

  @Test
  void eventsDifferBetweenSeeds() {
    assertNotEquals(
        SceneRuns.events(SceneRuns.fly("run.seed=1"), 0.02),
        SceneRuns.events(SceneRuns.fly("run.seed=2"), 0.02));
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 7, 1000})
  void eventsDoNotDependOnPacketBoundaries(int maxEvents) {
    FlySceneSettings settings = SceneRuns.fly("run.durationS=0.05");
    StreamRecorder cut = SceneRuns.record(new FlyScene(settings, maxEvents));

    assertEquals(SceneRuns.events(new FlyScene(settings)), cut.events());
    assertEquals(maxEvents, cut.largestPacket());
  }

  @Test
  void streamFollowsTheGrammarWithSmallPackets() {
    StreamRecorder stream =
        SceneRuns.record(
            new FlyScene(
                SceneRuns.fly("run.durationS=0.1", "run.startUs=1000000", "noise.shotHz=50")));

    assertTrue(stream.largestPacket() <= 4096);
    assertEquals(
        new SensorGeometry(128, 128), stream.notifications(StreamStarted.class).get(0).geometry());
    assertEquals(
        stream.events().lastTimeUs(), stream.notifications(EndOfStream.class).get(0).lastUs());
    assertTrue(stream.events().firstTimeUs() >= 1_000_000);
    assertTrue(stream.events().lastTimeUs() < 1_100_000);
    assertTrue(stream.events().lastTimeUs() > 1_099_900);
  }

  @Test
  void nothingFollowsTheEnd() {
    FlyScene scene = new FlyScene(SceneRuns.fly("run.durationS=0.01"));
    SceneRuns.events(scene);

    assertFalse(scene.next(NOBODY));
  }

  @Test
  void endlessSceneSendsEmptyPacketsDuringSilence() {
    FlyScene scene = new FlyScene(SceneRuns.empty());
    int[] packets = new int[1];
    StreamGrammar grammar =
        new StreamGrammar(
            new StreamHandler() {
              @Override
              public void packet(EventPacket packet) {
                assertTrue(packet.isEmpty());
                packets[0]++;
              }

              @Override
              public void notified(StreamNotification notification) {}
            });

    for (int i = 0; i < 4; i++) {
      assertTrue(scene.next(grammar));
    }
    assertEquals(3, packets[0]);
    assertEquals(OptionalLong.empty(), scene.durationUs());
  }

  @Test
  void streamTakesConstantMemory() {
    FlyScene scene = new FlyScene(SceneRuns.fly("disturbances.manoeuvres.turnRad=0.5"));

    long bytes =
        Allocation.bytesOf(
            () -> {
              for (int i = 0; i < 10; i++) {
                scene.next(NOBODY);
              }
            });

    assertTrue(bytes < 20_000, bytes + " bytes for 100 ms");
  }

  @Test
  void slowPixelsConcentrateEventsAtTheReversals() {
    double slow = reversalShare("pixel.bandwidthHz=500");
    double fast = reversalShare("pixel.bandwidthHz=20000");

    // a wing is within 5 % of its amplitude from a reversal during 20 % of the time
    assertTrue(slow > 2.5 * fast, slow + " against " + fast);
    assertTrue(fast < 0.12, "" + fast);
  }

  /** Share of the events of the left wing that lie within 5 % of the amplitude of a reversal. */
  private static double reversalShare(String bandwidth) {
    FlyScene scene =
        new FlyScene(
            SceneRuns.fly(
                bandwidth,
                "run.durationS=0.2",
                "noise.shotHz=0",
                "noise.leakHz=0",
                "noise.hotPixels=0",
                "fly.body.contrast=0",
                "stroke.beat.waveform=sinusoid"));
    EventPacket events = SceneRuns.events(scene);
    int all = 0;
    int there = 0;
    for (int i = 0; i < events.size(); i++) {
      FlyTruth truth = scene.truthAt(events.timeUs(i));
      if (SceneRuns.isLeft(truth, events.x(i), events.y(i))) {
        double angle = SceneRuns.strokeAngle(truth, true, events.x(i), events.y(i));
        double place = Math.abs(angle - truth.leftCentreRad()) / truth.leftAmplitudeRad();
        all++;
        there += place > 0.95 ? 1 : 0;
      }
    }
    return there / (double) all;
  }

  @Test
  void eventsPerEdgeAndBeatAreConfigurable() {
    double few = eventsPerEdgeAndBeat("fly.wing.visibleShare=0.012");
    double usual = eventsPerEdgeAndBeat("run.seed=1");
    double many =
        eventsPerEdgeAndBeat(
            "fly.wing.visibleShare=1",
            "fly.wing.contrast=1",
            "pixel.bandwidthHz=20000",
            "fly.wing.rootShare=0.2");

    assertTrue(few < 60, "few: " + few);
    assertTrue(usual > 300 && usual < 700, "usual: " + usual);
    assertTrue(many > 2000, "many: " + many);
  }

  private static double eventsPerEdgeAndBeat(String... assignments) {
    EventPacket events =
        SceneRuns.events(
            SceneRuns.fly("noise.hotPixels=0", "noise.shotHz=0").with(assignments), 0.1);
    return events.size() / (0.1 * 200 * 4);
  }

  @Test
  void defaultSceneHasARealisticEventRate() {
    double rate = SceneRuns.events(SceneRuns.fly(), 0.5).size() / 0.5;

    assertTrue(rate > 200_000 && rate < 500_000, rate + " events a second");
  }

  @Test
  void wiresHideWings() {
    FlySceneSettings settings =
        SceneRuns.pure(
            "disturbances.wire.widthPx=4",
            "disturbances.wire.angleRad=0",
            "disturbances.wire.offsetPx=10");
    EventPacket events = SceneRuns.events(settings, 0.05);

    assertEquals(0, SceneRuns.count(events, i -> Math.abs(events.y(i) - 73.5) < 2));
    assertTrue(SceneRuns.count(events, i -> Math.abs(events.y(i) - 73.5) < 4) > 100);
  }

  @Test
  void bodyHidesTheWings() {
    FlyScene scene =
        new FlyScene(SceneRuns.pure("stroke.beat.clapAndFling=true", "run.durationS=0.05"));
    BodyShape shape = new BodyShape(scene.settings().fly().body().lengthPx());
    EventPacket events = SceneRuns.events(scene);
    for (int i = 0; i < events.size(); i++) {
      // the fly is upright and at rest
      assertTrue(shape.distance(events.y(i) - 63.5, 63.5 - events.x(i)) >= 0);
    }
  }

  @Test
  void onlyASwayingBodyMakesContourEvents() {
    String[] noWings = {"fly.wing.visibleShare=0", "fly.body.contrast=1.5"};
    FlySceneSettings still = SceneRuns.pure(noWings);
    FlySceneSettings swaying = still.with("fly.body.wobblePx=0.5");
    EventPacket events = SceneRuns.events(swaying, 1);
    BodyShape shape = new BodyShape(44);

    assertTrue(SceneRuns.events(still, 1).isEmpty());
    assertTrue(events.size() > 500, "" + events);
    for (int i = 0; i < events.size(); i++) {
      double distance = shape.distance(events.y(i) - 63.5, 63.5 - events.x(i));
      assertTrue(Math.abs(distance) < 5, "distance from the outline " + distance);
    }
    double on = SceneRuns.count(events, events::isOn);
    assertEquals(0.5, on / events.size(), 0.1, "what gets dark gets bright again");
  }

  @Test
  void busLimitBoundsTheEventRate() {
    FlyScene scene =
        new FlyScene(
            SceneRuns.fly("run.durationS=0.1", "pixel.busLimitEps=100000", "noise.hotPixels=0"));
    EventPacket events = SceneRuns.events(scene);

    assertTrue(events.size() <= 10_001, "" + events);
    assertTrue(scene.lostOnBus() > 10_000, scene.lostOnBus() + " lost");
  }

  @Test
  void otherSensorSizesShowTheWholeFly() {
    FlySceneSettings settings =
        SceneRuns.fly(
            "sensor.widthPx=640",
            "sensor.heightPx=480",
            "fly.wing.lengthPx=180",
            "fly.body.lengthPx=180",
            "fly.wing.visibleShare=0.05");
    EventPacket events = SceneRuns.events(settings, 0.02);
    int[] quarters = new int[4];
    for (int i = 0; i < events.size(); i++) {
      quarters[(events.x(i) < 320 ? 0 : 1) + (events.y(i) < 240 ? 0 : 2)]++;
    }

    for (int quarter : quarters) {
      assertTrue(quarter > 500, "" + quarter);
    }
  }

  @Test
  void flyAtTheBorderIsClipped() {
    EventPacket events =
        SceneRuns.events(SceneRuns.pure("fly.body.offsetXPx=60", "fly.body.offsetYPx=-60"), 0.02);

    assertTrue(events.size() > 1000);
  }
}
