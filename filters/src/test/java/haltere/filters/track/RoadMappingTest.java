package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.settings.SettingsProblem;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class RoadMappingTest {
  private static final List<SensorGeometry> SENSORS =
      List.of(
          new SensorGeometry(128, 128),
          new SensorGeometry(346, 260),
          new SensorGeometry(1280, 720),
          new SensorGeometry(240, 320));

  private static final List<RoadSettings> ROADS =
      List.of(
          RoadSettings.defaults(),
          new RoadSettings(8, 12, 150, VanishingPoint.at(-20, 140.5)),
          new RoadSettings(30, 2, 60, VanishingPoint.at(100, 90)));

  private interface Check {
    void of(RoadMapping mapping, SensorGeometry sensor, double x, double y);
  }

  /** On random places of the road that the sensor sees. */
  private static void everywhere(Check check) {
    SplittableRandom random = new SplittableRandom(2);
    for (SensorGeometry sensor : SENSORS) {
      for (RoadSettings road : ROADS) {
        RoadMapping mapping = new RoadMapping(road, sensor);
        double rows = Math.min(sensor.height() - 1, 0.999 * mapping.vanishingY());
        for (int i = 0; i < 200; i++) {
          double x = random.nextDouble(0, sensor.width() - 1);
          double y = random.nextDouble(0, rows);
          assertTrue(mapping.onRoad(y));
          check.of(mapping, sensor, x, y);
        }
      }
    }
  }

  @Test
  void theWayBackIsTheInverse() {
    everywhere(
        (mapping, sensor, x, y) -> {
          double lateral = mapping.lateralM(x, y);
          double distance = mapping.distanceM(y);
          assertEquals(y, mapping.rowOf(distance), 1e-9);
          assertEquals(x, mapping.columnOf(lateral, distance), 1e-9);
        });
  }

  @Test
  void theWayThereIsTheInverseOfTheWayBack() {
    RoadMapping mapping = new RoadMapping(RoadSettings.defaults(), SENSORS.get(0));
    for (double distance = 2; distance < 300; distance += 0.7) {
      for (double lateral = -12; lateral <= 12; lateral += 3) {
        double y = mapping.rowOf(distance);
        assertEquals(distance, mapping.distanceM(y), 1e-9);
        assertEquals(lateral, mapping.lateralM(mapping.columnOf(lateral, distance), y), 1e-9);
      }
    }
  }

  @Test
  void theJacobianIsThatOfCentralDifferences() {
    everywhere(
        (mapping, sensor, x, y) -> {
          double h = 1e-4;
          near(
              (mapping.lateralM(x + h, y) - mapping.lateralM(x - h, y)) / (2 * h),
              mapping.lateralPerX(y));
          near(
              (mapping.lateralM(x, y + h) - mapping.lateralM(x, y - h)) / (2 * h),
              mapping.lateralPerY(x, y));
          near(
              (mapping.distanceM(y + h) - mapping.distanceM(y - h)) / (2 * h),
              mapping.distancePerY(y));
        });
  }

  private static void near(double expected, double actual) {
    assertEquals(expected, actual, 1e-6 * Math.max(1, Math.abs(expected)));
  }

  @Test
  void theBottomRowSeesD1AndTheVanishingRowDv() {
    for (SensorGeometry sensor : SENSORS) {
      for (RoadSettings road : ROADS) {
        RoadMapping mapping = new RoadMapping(road, sensor);
        assertEquals(road.nearestM(), mapping.distanceM(0), 1e-9);
        assertEquals(
            road.farthestM(), mapping.distanceM(mapping.vanishingY()), 1e-9 * road.farthestM());
      }
    }
  }

  @Test
  void higherRowsSeeFartherOnTheWholeRoad() {
    for (SensorGeometry sensor : SENSORS) {
      for (RoadSettings road : ROADS) {
        RoadMapping mapping = new RoadMapping(road, sensor);
        double before = 0;
        for (double y = 0; y < mapping.vanishingY(); y += 0.25) {
          assertTrue(mapping.distanceM(y) > before);
          before = mapping.distanceM(y);
        }
        assertTrue(before < road.farthestM());
      }
    }
  }

  @Test
  void rowsAtOrAboveTheVanishingPointAreOffTheRoad() {
    RoadSettings road = RoadSettings.defaults().withVanishingPoint(VanishingPoint.at(64, 100));
    RoadMapping mapping = new RoadMapping(road, SENSORS.get(0));
    assertTrue(mapping.onRoad(0));
    assertTrue(mapping.onRoad(Math.nextDown(100.0)));
    assertFalse(mapping.onRoad(100));
    assertFalse(mapping.onRoad(127));
    assertFalse(mapping.onRoad(Double.NaN));
    // γ(y) reaches a right angle where the road below the camera is seen: not ahead any more.
    double below = mapping.rowOf(1e-9);
    assertTrue(below < 0);
    assertTrue(mapping.onRoad(below + 1e-3));
    assertFalse(mapping.onRoad(below - 1e-3));
  }

  @Test
  void withoutAMarkTheRoadVanishesInTheMiddleOfTheTopRow() {
    RoadMapping mapping = new RoadMapping(RoadSettings.defaults(), new SensorGeometry(346, 260));
    assertEquals(172.5, mapping.vanishingX());
    assertEquals(259, mapping.vanishingY());
    assertThrows(
        SettingsProblem.class,
        () -> new RoadMapping(RoadSettings.defaults(), new SensorGeometry(128, 1)));
  }

  @Test
  void aCaseByHand() {
    // h = 10, d₁ = 10, d_v = 10 √3: β = 45°, γ_v = 30°, over 15 rows δ = 1° = π/180.
    // Row 5 looks down by 40°: d = 10 / tan 40° = 11.917536, its slant range 10 / sin 40° =
    // 15.557238; 4 columns to the right of x_v = 7: X = 4 · π/180 · 15.557238 = 1.086100.
    RoadSettings road = new RoadSettings(10, 10, 10 * Math.sqrt(3), VanishingPoint.at(7, 15));
    RoadMapping mapping = new RoadMapping(road, new SensorGeometry(64, 32));
    assertEquals(Math.PI / 180, mapping.pixelAngle(), 1e-15);
    assertEquals(11.917536, mapping.distanceM(5), 1e-6);
    assertEquals(1.086100, mapping.lateralM(11, 5), 1e-6);
    assertEquals(-1.086100, mapping.lateralM(3, 5), 1e-6);
    // ∂d/∂y = δ (h² + d²) / h = 0.01745329 · 15.557238² / 10 = 0.422418.
    assertEquals(0.422418, mapping.distancePerY(5), 1e-6);
  }

  @Test
  void theSidesOfTheSensorChangeNothingWhereTheVanishingPointIsMarked() {
    RoadSettings road = ROADS.get(1);
    RoadMapping square = new RoadMapping(road, new SensorGeometry(128, 128));
    RoadMapping wide = new RoadMapping(road, new SensorGeometry(640, 128));
    assertEquals(square.lateralM(50, 30), wide.lateralM(50, 30));
    assertEquals(square.distanceM(30), wide.distanceM(30));
  }

  @Test
  void theCovarianceInMetresIsThatOfDrawnPixels() {
    SplittableRandom random = new SplittableRandom(6);
    RoadMapping mapping = new RoadMapping(RoadSettings.defaults(), SENSORS.get(1));
    double x = 300;
    double y = 90;
    double s = 0.05;
    int n = 40_000;
    double lateral = 0;
    double cross = 0;
    double distance = 0;
    for (int i = 0; i < n; i++) {
      // Column and row with variance 2 s² and s², covariance s².
      double common = s * random.nextGaussian();
      double dx = common + s * random.nextGaussian();
      double a = mapping.lateralM(x + dx, y + common) - mapping.lateralM(x, y);
      double b = mapping.distanceM(y + common) - mapping.distanceM(y);
      lateral += a * a / n;
      cross += a * b / n;
      distance += b * b / n;
    }
    GroundCovariance expected = mapping.covariance(x, y, 2 * s * s, s * s, s * s);
    assertEquals(1, lateral / expected.lateralM2(), 0.05);
    assertEquals(1, cross / expected.crossM2(), 0.05);
    assertEquals(1, distance / expected.distanceM2(), 0.05);
  }

  @Test
  void aPixelFarAwayIsWorthManyMetres() {
    RoadMapping mapping = new RoadMapping(RoadSettings.defaults(), SENSORS.get(0));
    GroundCovariance near = mapping.covariance(63.5, 0, 1, 0, 1);
    GroundCovariance far = mapping.covariance(63.5, 126, 1, 0, 1);
    // One row of 127 below the end of the road. Standard deviations go with h² + d² along the road
    // (29 m² at the bottom row, 37,000 m² here), and with its root across.
    assertTrue(far.distanceM2() > 1e4 * near.distanceM2());
    assertTrue(far.lateralM2() > 1e2 * near.lateralM2());
  }
}
