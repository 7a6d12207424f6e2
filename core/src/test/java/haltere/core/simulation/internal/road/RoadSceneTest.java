package haltere.core.simulation.internal.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.SceneRuns;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.testing.Allocation;
import haltere.testing.StreamRecorder;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The event stream of the road scene. */
class RoadSceneTest {
  private static final StreamHandler NOBODY =
      new StreamHandler() {
        @Override
        public void packet(EventPacket packet) {}

        @Override
        public void notified(StreamNotification notification) {}
      };

  private static RoadSceneSettings road(String... assignments) {
    return RoadSceneSettings.defaults().with(assignments);
  }

  /** No noise, and pixels without delay. */
  private static RoadSceneSettings pure(String... assignments) {
    return road(
            "noise.leakHz=0",
            "noise.shotHz=0",
            "noise.hotPixels=0",
            "pixel.bandwidthHz=0",
            "pixel.latencyUs=0",
            "pixel.jitterUs=0")
        .with(assignments);
  }

  @Test
  void eventsAreReproducibleOnEveryMachine() {
    StreamRecorder events =
        SceneRuns.record(new RoadScene(road("run.durationS=0.5", "rain.streaksPerS=100")));

    assertEquals("95b31924 of 8435", events.crc32() + " of " + events.events().size());
  }

  @Test
  void trafficDiffersBetweenSeeds() {
    assertNotEquals(
        new RoadScene(road("run.seed=1")).truthRows(0).toString(),
        new RoadScene(road("run.seed=2")).truthRows(0).toString());
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 7, 1000})
  void eventsDoNotDependOnPacketBoundaries(int maxEvents) {
    RoadSceneSettings settings = road("run.durationS=0.3", "noise.shotHz=20");
    StreamRecorder cut = SceneRuns.record(new RoadScene(settings, maxEvents));

    assertEquals(SceneRuns.events(new RoadScene(settings)), cut.events());
    assertEquals(maxEvents, cut.largestPacket());
  }

  @Test
  void eventsDoNotDependOnQueriesOfTheTruth() {
    RoadSceneSettings settings = road("run.durationS=0.2");
    RoadScene asked = new RoadScene(settings);
    asked.truthRows(3_600_000_000L);
    asked.truthRows(0);

    assertEquals(SceneRuns.events(new RoadScene(settings)), SceneRuns.events(asked));
  }

  @Test
  void streamFollowsTheGrammarWithSmallPackets() {
    StreamRecorder stream =
        SceneRuns.record(
            new RoadScene(
                road(
                    "run.durationS=0.1",
                    "run.startUs=1000000",
                    "noise.shotHz=50",
                    "sensor.widthPx=320",
                    "sensor.heightPx=240")));

    assertTrue(stream.largestPacket() <= 4096);
    assertEquals(
        new SensorGeometry(320, 240), stream.notifications(StreamStarted.class).get(0).geometry());
    assertEquals(
        stream.events().lastTimeUs(), stream.notifications(EndOfStream.class).get(0).lastUs());
    assertTrue(stream.events().firstTimeUs() >= 1_000_000);
    assertTrue(stream.events().lastTimeUs() < 1_100_000);
    assertTrue(stream.events().lastTimeUs() > 1_099_900);
    assertTrue(stream.events().firstTimeUs() < 1_000_100);
  }

  @Test
  void nothingFollowsTheEnd() {
    RoadScene scene = new RoadScene(road("run.durationS=0.01"));
    SceneRuns.events(scene);

    assertFalse(scene.next(NOBODY));
  }

  @Test
  void streamTakesConstantMemory() {
    RoadScene scene = new RoadScene(road());
    for (int i = 0; i < 50; i++) {
      scene.next(NOBODY);
    }

    long bytes =
        Allocation.bytesOf(
            () -> {
              for (int i = 0; i < 20; i++) {
                scene.next(NOBODY);
              }
            });

    assertTrue(bytes < 40_000, bytes + " bytes for 200 ms");
  }

  @Test
  void eventsLieInTheBoxesOfVehicles() {
    RoadScene scene = new RoadScene(pure("run.durationS=6"));
    EventPacket events = SceneRuns.events(scene);
    int outside = 0;
    RecentTruth truth = new RecentTruth(scene);
    for (int i = 0; i < events.size(); i++) {
      outside += isIn(truth.rows(events.timeUs(i)), events.x(i), events.y(i), 1) ? 0 : 1;
    }

    assertTrue(events.size() > 15_000, events.size() + " events");
    // a vehicle that is gone behind the far end of the road is no longer in the truth
    assertTrue(outside <= events.size() / 1000, outside + " of " + events.size());
  }

  /** The truth at most half a millisecond ago, in which a vehicle moves by less than a pixel. */
  private static final class RecentTruth {
    private final RoadScene scene;
    private List<RoadTruth> rows = List.of();
    private long timeUs = -1;

    RecentTruth(RoadScene scene) {
      this.scene = scene;
    }

    List<RoadTruth> rows(long nowUs) {
      if (timeUs < 0 || nowUs - timeUs > 500) {
        timeUs = nowUs;
        rows = scene.truthRows(nowUs);
      }
      return rows;
    }
  }

  private static boolean isIn(List<RoadTruth> rows, int x, int y, double margin) {
    for (RoadTruth row : rows) {
      if (Math.abs(x - row.xPx()) <= row.widthPx() / 2 + margin
          && Math.abs(y - row.yPx()) <= row.heightPx() / 2 + margin) {
        return true;
      }
    }
    return false;
  }

  @Test
  void eventsOfAVehicleAreSpreadAboutTheCentreOfItsBox() {
    RoadScene scene =
        new RoadScene(
            pure(
                "run.durationS=20",
                "traffic.lanesTowards=0",
                "traffic.lanesAway=1",
                "traffic.pauseS=6",
                "vehicles.lorries=0",
                "vehicles.motorcycles=0",
                "traffic.encounters.overtake=0",
                "traffic.encounters.sideBySide=0"));
    EventPacket events = SceneRuns.events(scene);
    double sumX = 0;
    double sumY = 0;
    int inside = 0;
    int front = 0;
    RecentTruth truth = new RecentTruth(scene);
    for (int i = 0; i < events.size(); i++) {
      List<RoadTruth> rows = truth.rows(events.timeUs(i));
      if (rows.size() == 1 && rows.get(0).visibleShare() == 1) {
        RoadTruth row = rows.get(0);
        double fromX = (events.x(i) - row.xPx()) / row.widthPx();
        double fromY = (events.y(i) - row.yPx()) / row.heightPx();
        sumX += fromX;
        sumY += fromY;
        front += fromY > 0.25 ? 1 : 0;
        inside++;
      }
    }

    assertTrue(inside > 2000, inside + " events of lonely vehicles");
    assertEquals(0, sumX / inside, 0.1, "offset across in widths");
    assertEquals(0, sumY / inside, 0.25, "offset along in heights");
    assertTrue(front > inside / 20, "the far edge is seen too");
  }

  @Test
  void roadWithoutLanesHasOnlyNoise() {
    EventPacket events =
        SceneRuns.events(
            new RoadScene(
                road(
                    "traffic.lanesAway=0",
                    "traffic.lanesTowards=0",
                    "run.durationS=2",
                    "noise.leakHz=0",
                    "noise.shotHz=2",
                    "noise.hotPixels=5",
                    "noise.hotRateHz=300")));
    double expected = 2 * (128 * 128 * 2 + 5 * 300);

    assertEquals(expected, events.size(), 5 * Math.sqrt(expected));
  }

  @Test
  void rainMakesShortStreaksOfBothPolarities() {
    EventPacket events =
        SceneRuns.events(
            new RoadScene(
                pure(
                    "traffic.lanesAway=0",
                    "traffic.lanesTowards=0",
                    "run.durationS=4",
                    "rain.streaksPerS=200",
                    "rain.lengthPx=10")));
    int on = SceneRuns.count(events, events::isOn);

    // 800 streaks of 10.5 pixels, of which the border cuts some
    assertEquals(800 * 10.5 * 0.93, on, 800 * 10.5 * 0.1);
    assertEquals(on, events.size() - on, 0.05 * on);
  }

  @Test
  void vehiclesWithoutContrastMakeNoEvents() {
    EventPacket events =
        SceneRuns.events(
            new RoadScene(pure("vehicles.contrast=0", "vehicles.texture=0", "run.durationS=1")));

    assertEquals(0, events.size());
  }

  @Test
  void largerSensorSeesTheSameTraffic() {
    RoadTruth small = new RoadScene(road()).truthRows(1_000_000).get(0);
    RoadScene scene =
        new RoadScene(road("sensor.widthPx=1280", "sensor.heightPx=720", "run.durationS=0.02"));
    RoadTruth large = scene.truthRows(1_000_000).get(0);

    assertEquals(small.id(), large.id());
    assertEquals(small.yM(), large.yM());
    assertEquals(719.0 / 127, large.heightPx() / small.heightPx(), 1e-9);
    assertTrue(SceneRuns.events(scene).size() > 10_000);
  }
}
