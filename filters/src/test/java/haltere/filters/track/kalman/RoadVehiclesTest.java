package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.road.RoadScene;
import haltere.core.simulation.road.RoadSceneSettings;
import haltere.core.simulation.road.RoadTruth;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.track.CountingLineSettings;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.LineCrossing;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.RoadTrackPoint;
import haltere.filters.track.RoadTracksSettings;
import haltere.filters.track.TrackPoint;
import haltere.filters.track.VanishingPoint;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Vehicles of simulated roads, without noise. */
class RoadVehiclesTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final RoadSettings VIEW =
      new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127));
  private static final String[] CARS = {
    "vehicles.heightShare=0",
    "vehicles.lorries=0",
    "vehicles.motorcycles=0",
    "noise.leakHz=0",
    "noise.shotHz=0",
    "noise.hotPixels=0",
    "traffic.encounters.overtake=0",
    "traffic.encounters.sideBySide=0",
    "traffic.encounters.speedChange=0",
    "traffic.pauseS=4"
  };

  /** The row of the counting line. */
  private static final double LINE_ROW = new RoadMapping(VIEW, SENSOR).rowOf(25);

  private final List<RoadTrackPoint> points = new ArrayList<>();
  private final List<TrackPoint> inPicture = new ArrayList<>();
  private final List<LineCrossing> crossings = new ArrayList<>();
  private RoadScene scene;
  private KalmanTracksFilter filter;

  private static RoadSceneSettings cars(String... settings) {
    return RoadSceneSettings.defaults().with(CARS).with(settings);
  }

  /** Lets the filter see a scene, in packets of at most so many events. */
  private void watch(RoadSceneSettings settings, int mostEvents) {
    scene = new RoadScene(settings);
    RoadTracksSettings road =
        new RoadTracksSettings(
            true,
            VIEW,
            RoadTracksSettings.defaults().processVariance(),
            new LaneSettings(4, -7, 3.5),
            new CountingLineSettings(1, 25, 10));
    filter = new KalmanTracksFilter(SENSOR, KalmanTracksSettings.defaults().onRoad(road));
    points.clear();
    inPicture.clear();
    crossings.clear();
    filter.points().subscribe(inPicture::add);
    filter.roadPoints().subscribe(points::add);
    filter.crossings().subscribe(crossings::add);
    StreamHandler handler =
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            for (int from = 0; from < packet.size(); from += mostEvents) {
              EventPacket part = new EventPacket(mostEvents);
              part.append(packet, from, Math.min(packet.size(), from + mostEvents));
              filter.process(part);
            }
          }

          @Override
          public void notified(StreamNotification notification) {
            filter.notified(notification);
          }
        };
    while (scene.next(handler)) {
      // the handler has seen it
    }
  }

  private RoadTruth vehicleAt(RoadTrackPoint point) {
    for (RoadTruth vehicle : scene.truthRows(point.timeUs())) {
      boolean beside = Math.abs(vehicle.xM() - point.xM()) < 1.5;
      if (beside && Math.abs(vehicle.yM() - point.yM()) < 4) {
        return vehicle;
      }
    }
    return null;
  }

  @Test
  void carsThatCruiseHaveTheirSpeed() {
    watch(cars("traffic.encounters.stop=0", "run.seed=11", "run.durationS=12"), 4096);
    Map<Integer, double[]> passages = new HashMap<>();
    for (RoadTrackPoint point : points) {
      RoadTruth vehicle = vehicleAt(point);
      if (vehicle != null && vehicle.visibleShare() > 0.95) {
        double weight = 1 / (point.sdSpeedKmH() * point.sdSpeedKmH());
        double[] sums = passages.computeIfAbsent(vehicle.id(), id -> new double[2]);
        sums[0] += weight * point.speedKmH();
        sums[1] += weight * 3.6 * Math.hypot(vehicle.vxMS(), vehicle.vyMS());
      }
    }
    assertTrue(passages.size() > 5);
    passages.values().forEach(sums -> assertEquals(1, sums[0] / sums[1], 0.03));
    assertEquals(
        1,
        passages.values().stream().mapToDouble(sums -> sums[0] / sums[1]).average().orElseThrow(),
        0.005);
  }

  @Test
  void aCarThatStopsIsStillThereAndGoesOnAsTheSame() {
    watch(
        cars(
            "traffic.encounters.cruise=0",
            "traffic.lanesTowards=0",
            "traffic.lanesAway=1",
            "run.seed=3",
            "run.durationS=13"),
        4096);
    Map<Integer, Set<Integer>> standing = new HashMap<>();
    Map<Integer, Set<Integer>> again = new HashMap<>();
    for (RoadTrackPoint point : points) {
      RoadTruth vehicle = vehicleAt(point);
      if (vehicle == null || vehicle.yM() > 45) {
        continue;
      }
      boolean stands = Math.abs(vehicle.vyMS()) < 0.01;
      if (stands) {
        standing.computeIfAbsent(vehicle.id(), id -> new TreeSet<>()).add(point.id());
      } else if (standing.containsKey(vehicle.id()) && Math.abs(vehicle.vyMS()) > 4) {
        again.computeIfAbsent(vehicle.id(), id -> new TreeSet<>()).add(point.id());
      }
    }
    assertFalse(again.isEmpty());
    again.forEach((vehicle, ids) -> assertEquals(standing.get(vehicle), ids));
  }

  @Test
  void eachCarIsCountedOnceAtTheLineInItsLane() {
    watch(cars("traffic.encounters.stop=0", "run.seed=11", "run.durationS=12"), 4096);
    Map<Integer, Double> nearEnds = new HashMap<>();
    List<Integer> truth = new ArrayList<>();
    for (long timeUs = 0; timeUs < 11_500_000; timeUs += 10_000) {
      for (RoadTruth vehicle : scene.truthRows(timeUs)) {
        double near = vehicle.yM() - 2.2 - 25;
        Double before = nearEnds.put(vehicle.id(), near);
        if (timeUs > 1_500_000 && before != null && before * near < 0) {
          truth.add(vehicle.vyMS() > 0 ? vehicle.lane() : -1 - vehicle.lane());
        }
      }
    }
    List<Integer> counted =
        crossings.stream()
            .filter(crossing -> crossing.timeUs() > 1_500_000 && crossing.timeUs() < 11_500_000)
            .map(
                crossing ->
                    crossing.direction() == LineCrossing.Direction.AWAY
                        ? crossing.lane()
                        : -1 - crossing.lane())
            .sorted()
            .toList();
    assertTrue(truth.size() > 4);
    assertEquals(truth.stream().sorted().toList(), counted);
  }

  @Test
  void highLorriesThatDriveAwayAreCountedAtTheirOwnSpeedAndTheirRoofsAreNot() {
    watch(
        cars(
            "vehicles.heightShare=1",
            "vehicles.cars=0",
            "vehicles.lorries=1",
            "traffic.lanesAway=1",
            "traffic.lanesTowards=0",
            "traffic.encounters.stop=0",
            "run.seed=21",
            "run.durationS=14"),
        4096);
    // What was on the road before the scene began has an end that nobody has seen.
    List<LineCrossing> seen = crossings.stream().filter(one -> one.timeUs() > 1_500_000).toList();
    assertTrue(seen.size() > 1, "crossings: " + seen);
    for (LineCrossing crossing : seen) {
      List<RoadTruth> near =
          scene.truthRows(crossing.timeUs()).stream()
              .filter(lorry -> Math.abs(lorry.yM() - 4.5 - 25) < 3)
              .toList();
      assertEquals(1, near.size(), "nobody is at the line: " + crossing);
      assertEquals(3.6 * Math.abs(near.get(0).vyMS()), crossing.speedKmH(), 5);
    }
  }

  @Test
  void behindNoiseEachVehicleOfAMixedRoadIsCountedOnceInItsDirectionAndNobodyElse() {
    watch(
        cars(
            "vehicles.lorries=2",
            "vehicles.motorcycles=4",
            "traffic.encounters.overtake=1",
            "noise.shotHz=0.1",
            "run.seed=600021",
            "run.durationS=16"),
        4096);
    Map<String, Integer> passed = new TreeMap<>();
    Map<Integer, Double> ends = new HashMap<>();
    Set<String> kinds = new TreeSet<>();
    for (long timeUs = 0; timeUs < 15_500_000; timeUs += 10_000) {
      for (RoadTruth vehicle : scene.truthRows(timeUs)) {
        double end = vehicle.yPx() - vehicle.heightPx() / 2 - LINE_ROW;
        Double before = ends.put(vehicle.id(), end);
        if (timeUs > 1_500_000 && before != null && before * end < 0) {
          kinds.add(vehicle.kind() + " " + (end > 0));
          passed.merge(end > 0 ? "AWAY" : "TOWARDS", 1, Integer::sum);
        }
      }
    }
    Map<String, Integer> counted = new TreeMap<>();
    crossings.stream()
        .filter(one -> one.timeUs() > 1_500_000 && one.timeUs() < 15_500_000)
        .forEach(one -> counted.merge(one.direction().name(), 1, Integer::sum));
    assertTrue(kinds.containsAll(Set.of("MOTORCYCLE true", "MOTORCYCLE false")), "" + kinds);
    assertEquals(passed, counted);
  }

  @Test
  void whatIsWhereNoVehicleCanBeHasAPlaceInThePictureButNoneOnTheRoad() {
    watch(
        cars(
            "vehicles.heightShare=1",
            "vehicles.cars=0",
            "vehicles.lorries=1",
            "traffic.encounters.stop=0",
            "run.seed=600015",
            "run.durationS=6"),
        4096);
    assertTrue(points.size() > 100);
    assertTrue(inPicture.size() > points.size());
    assertEquals(List.of(), points.stream().filter(one -> Math.abs(one.xM()) > 7.6).toList());
  }

  @Test
  void whereTheStreamIsCutDoesNotMatter() {
    RoadSceneSettings settings = cars("run.seed=5", "run.durationS=3");
    watch(settings, 4096);
    List<RoadTrackPoint> whole = List.copyOf(points);
    assertFalse(whole.isEmpty());
    watch(settings, 1);
    assertEquals(whole, points);
  }

  @Test
  void afterAnHourWithoutEventsNoVehicleIsLeft() {
    watch(cars("run.seed=5", "run.durationS=3"), 4096);
    points.clear();
    EventPacket late = new EventPacket(2);
    late.append(3_600_000_000L, 60, 60, true);
    late.append(3_600_500_000L, 60, 60, true);
    filter.process(late);
    assertEquals(List.of(), points.stream().filter(point -> point.timeUs() > 60_000_000).toList());
  }
}
