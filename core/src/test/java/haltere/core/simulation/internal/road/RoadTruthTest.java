package haltere.core.simulation.internal.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.sensor.SensorSettings;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The truth of the vehicles: geometry, speeds and manoeuvres. */
class RoadTruthTest {
  private static final String[] NOTHING_BUT = {
    "traffic.encounters.cruise=0",
    "traffic.encounters.overtake=0",
    "traffic.encounters.sideBySide=0",
    "traffic.encounters.stop=0",
    "traffic.encounters.speedChange=0"
  };

  private static RoadScene only(String encounter, String... assignments) {
    return new RoadScene(
        RoadSceneSettings.defaults()
            .with(NOTHING_BUT)
            .with("traffic.encounters." + encounter + "=1")
            .with(assignments));
  }

  /** Rows by vehicle, in order of time. */
  private static Map<Integer, List<RoadTruth>> watch(RoadScene scene, double seconds) {
    Map<Integer, List<RoadTruth>> seen = new HashMap<>();
    for (long us = 0; us < seconds * 1e6; us += 50_000) {
      for (RoadTruth row : scene.truthRows(us)) {
        seen.computeIfAbsent(row.id(), id -> new ArrayList<>()).add(row);
      }
    }
    return seen;
  }

  @Test
  void bottomRowAndVanishingPointMatchTheSettings() {
    RoadCameraSettings settings = new RoadCameraSettings(5, 2, 300, 0.25, 0.75);
    RoadCamera camera = new RoadCamera(settings, new SensorSettings(129, 101));

    assertEquals(2, camera.groundDistance(0), 1e-9);
    assertEquals(300, camera.groundDistance(75), 1e-9);
    assertEquals(0, camera.groundX(32, 20), 1e-12);
    double beta = Math.atan(2.5);
    double delta = (beta - Math.atan(5.0 / 300)) / 75;
    double d = 5 / Math.tan(beta - delta * 30);
    assertEquals(d, camera.groundDistance(30), 1e-9);
    assertEquals((50 - 32) * delta * Math.sqrt(25 + d * d), camera.groundX(50, 30), 1e-9);
    assertTrue(Double.isNaN(camera.groundDistance(100)), "the sky is not on the road");
  }

  @ParameterizedTest
  @ValueSource(doubles = {3, 6.5, 20, 77, 250})
  void roadMappingAndItsInverseMatch(double d) {
    RoadCamera camera = new RoadCamera(RoadCameraSettings.defaults(), SensorSettings.defaults());
    for (double x = -7; x <= 7; x += 1.75) {
      double row = camera.row(d, 0);
      double column = camera.column(x, d, 0);

      assertEquals(d, camera.groundDistance(row), 1e-9 * d);
      assertEquals(x, camera.groundX(column, row), 1e-9);
    }
  }

  @Test
  void positionOfAFlatVehicleLiesOnItAndMovesAtItsSpeed() {
    RoadScene scene = only("cruise", "vehicles.heightShare=0");
    int far = 0;
    for (long us = 0; us < 20_000_000; us += 100_000) {
      for (RoadTruth row : scene.truthRows(us)) {
        assertEquals(row.yM(), row.spotYM(), 2.5, row.toString());
        if (row.yM() > 25 && row.kind() == VehicleKind.MOTORCYCLE) {
          assertEquals(row.yM(), row.spotYM(), 0.05);
          assertEquals(row.vyMS(), row.spotVyMS(), 0.005 * Math.abs(row.vyMS()));
          far++;
        }
      }
    }
    assertTrue(far > 20, far + " rows");
  }

  @Test
  void velocitiesAreDerivativesOfPositions() {
    RoadScene scene = new RoadScene(RoadSceneSettings.defaults());
    int rows = 0;
    for (long us = 0; us < 30_000_000; us += 97_003) {
      Map<Integer, RoadTruth> later = new HashMap<>();
      scene.truthRows(us + 200).forEach(row -> later.put(row.id(), row));
      for (RoadTruth row : scene.truthRows(us)) {
        RoadTruth then = later.get(row.id());
        if (then != null) {
          assertEquals(row.vyMS(), (then.yM() - row.yM()) / 2e-4, 1e-3);
          assertEquals(row.vxMS(), (then.xM() - row.xM()) / 2e-4, 1e-3);
          double pace = 1 + Math.hypot(row.vxPxS(), row.vyPxS());
          assertEquals(row.vyPxS(), (then.yPx() - row.yPx()) / 2e-4, 0.02 * pace);
          rows++;
        }
      }
    }
    assertTrue(rows > 1000, rows + " rows");
  }

  @Test
  void cruisingVehicleKeepsItsSpeedAndLane() {
    for (List<RoadTruth> rows : watch(only("cruise"), 30).values()) {
      RoadTruth first = rows.get(0);
      RoadTruth last = rows.get(rows.size() - 1);
      double seconds = (last.tUs() - first.tUs()) * 1e-6;

      assertEquals(first.yM() + first.vyMS() * seconds, last.yM(), 1e-9);
      assertEquals(first.vyMS(), last.vyMS());
      assertEquals(first.xM(), last.xM());
      assertEquals(first.lane(), last.lane());
      assertEquals(first.xM() > 0, first.vyMS() > 0, "traffic drives on the right");
    }
  }

  @Test
  void fastVehicleOvertakesInTheNextLaneAndReturns() {
    int passed = 0;
    Map<Integer, List<RoadTruth>> seen = watch(only("overtake", "traffic.roadM=200"), 60);
    for (List<RoadTruth> rows : seen.values()) {
      Set<Integer> lanes = new HashSet<>();
      rows.forEach(row -> lanes.add(row.lane()));
      if (lanes.size() == 2
          && rows.get(0).lane() == rows.get(rows.size() - 1).lane()
          && seen.values().stream().anyMatch(other -> isPassed(other, rows))) {
        passed++;
      }
    }

    assertTrue(passed >= 3, passed + " overtakes in a minute");
  }

  private static boolean isPassed(List<RoadTruth> slow, List<RoadTruth> fast) {
    Map<Long, RoadTruth> at = new HashMap<>();
    slow.forEach(row -> at.put(row.tUs(), row));
    boolean ahead = false;
    boolean behind = false;
    for (RoadTruth row : fast) {
      RoadTruth other = at.get(row.tUs());
      if (other != null && other.vyMS() * row.vyMS() > 0) {
        double lead = (row.yM() - other.yM()) * Math.signum(row.vyMS());
        ahead |= lead > 0;
        behind |= lead < 0;
      }
    }
    return ahead && behind;
  }

  @Test
  void vehicleStopsForTheConfiguredTime() {
    int stops = 0;
    for (List<RoadTruth> rows : watch(only("stop", "traffic.encounters.stopS=1.5"), 60).values()) {
      int first = -1;
      int last = -1;
      for (int i = 0; i < rows.size(); i++) {
        if (rows.get(i).vyMS() == 0) {
          first = first < 0 ? i : first;
          last = i;
        }
      }
      if (first > 0 && last < rows.size() - 1) {
        double stoodS = (rows.get(last).tUs() - rows.get(first).tUs()) * 1e-6;
        assertEquals(rows.get(first).yM(), rows.get(last).yM(), 1e-9);
        assertTrue(stoodS > 0.1 && stoodS < 4, stoodS + " s");
        stops += Math.abs(stoodS - 1.5) <= 0.051 ? 1 : 0;
      }
    }

    assertTrue(stops >= 3, stops + " stops in a minute");
  }

  @Test
  void motorcycleRidesBesideALorry() {
    RoadScene scene = only("sideBySide");
    int beside = 0;
    for (long us = 0; us < 20_000_000; us += 100_000) {
      List<RoadTruth> rows = scene.truthRows(us);
      for (RoadTruth lorry : rows) {
        for (RoadTruth motorcycle : rows) {
          beside +=
              lorry.kind() == VehicleKind.LORRY
                      && motorcycle.kind() == VehicleKind.MOTORCYCLE
                      && lorry.vyMS() * motorcycle.vyMS() > 0
                      && Math.abs(lorry.yM() - motorcycle.yM()) < 4.5
                  ? 1
                  : 0;
        }
      }
    }

    assertTrue(beside > 30, beside + " rows");
  }

  @Test
  void vehicleBrakesAndAccelerates() {
    int changes = 0;
    for (List<RoadTruth> rows : watch(only("speedChange"), 40).values()) {
      double least = rows.stream().mapToDouble(row -> Math.abs(row.vyMS())).min().orElseThrow();
      double first = Math.abs(rows.get(0).vyMS());
      double last = Math.abs(rows.get(rows.size() - 1).vyMS());
      changes += least < 0.8 * first && Math.abs(last - first) < 1e-9 ? 1 : 0;
    }

    assertTrue(changes >= 3, changes + " changes");
  }

  @Test
  void vehiclesNeverCollideAndNearerOnesHideFartherOnes() {
    RoadScene scene = new RoadScene(RoadSceneSettings.defaults());
    int hidden = 0;
    int most = 0;
    for (long us = 0; us < 200_000_000; us += 200_000) {
      List<RoadTruth> rows = scene.truthRows(us);
      most = Math.max(most, rows.size());
      for (RoadTruth a : rows) {
        boolean whole =
            Math.abs(a.xPx() - 63.5) + a.widthPx() / 2 < 63
                && Math.abs(a.yPx() - 63.5) + a.heightPx() / 2 < 63;
        hidden += whole && a.visibleShare() < 0.9 ? 1 : 0;
        for (RoadTruth b : rows) {
          if (a.id() < b.id()) {
            double aside = (a.kind().widthM() + b.kind().widthM()) / 2 * 0.92;
            double along = (a.kind().lengthM() + b.kind().lengthM()) / 2 * 0.92;
            assertTrue(
                Math.abs(a.xM() - b.xM()) > aside || Math.abs(a.yM() - b.yM()) > along,
                () -> a + " and " + b);
          }
        }
      }
    }

    assertTrue(hidden > 50, hidden + " rows of hidden vehicles");
    assertTrue(most >= 6, most + " vehicles at once");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "traffic.speedMS=100",
        "traffic.speedMS=3",
        "traffic.roadM=30",
        "traffic.roadM=400",
        "traffic.laneWidthM=2.5",
        "traffic.pauseS=0.1",
        "traffic.lanesAway=1",
        "camera.vanishingY=0.2",
        "camera.bridgeHeightM=100",
        "vehicles.sizeSpread=0.2"
      })
  void trafficExistsForAllSettings(String extreme) {
    RoadScene scene = new RoadScene(RoadSceneSettings.defaults().with(extreme));
    double roadM = scene.settings().traffic().roadM();
    Set<Integer> vehicles = new HashSet<>();
    for (long us = 0; us < 60_000_000; us += 500_000) {
      for (RoadTruth row : scene.truthRows(us)) {
        vehicles.add(row.id());
        assertTrue(row.yM() > -6 && row.yM() < roadM + 6, row::toString);
        assertTrue(row.visibleShare() >= 0 && row.visibleShare() <= 1, row::toString);
        assertTrue(row.widthPx() > 0 && row.heightPx() > 0, row::toString);
      }
    }

    assertTrue(vehicles.size() > 5, vehicles.size() + " vehicles in a minute");
  }

  @Test
  void timeOfADistanceInvertsTheDrive() {
    Drive drive = Drive.steady(10).then(2, 4.5, -4).then(6, 10, 2.5);

    assertEquals(0, drive.speed(5));
    assertEquals(32.5, drive.distanceM(5), 1e-12);
    for (double way : new double[] {1, 19.9, 20, 25, 32, 32.6, 40, 52.5, 53, 200}) {
      assertEquals(way, drive.distanceM(drive.timeOf(way)), 1e-9);
    }
  }

  @Test
  void truthDoesNotDependOnEarlierQueries() {
    RoadScene scene = new RoadScene(RoadSceneSettings.defaults());
    List<RoadTruth> late = scene.truthRows(7_200_000_000L);
    List<RoadTruth> early = scene.truthRows(5_000_000);

    assertEquals(late, scene.truthRows(7_200_000_000L));
    assertEquals(early, new RoadScene(RoadSceneSettings.defaults()).truthRows(5_000_000));
    assertTrue(late.size() > 1, "there is traffic after two hours");
  }
}
