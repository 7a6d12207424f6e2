package haltere.filters.plane;

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

  private static final List<RoadViewSettings> ROADS =
      List.of(
          RoadViewSettings.defaults(),
          new RoadViewSettings(8, 12, 150, VanishingPoint.at(-20, 140.5)),
          new RoadViewSettings(30, 2, 60, VanishingPoint.at(100, 90)));

  private interface Check {
    void of(RoadMapping mapping, double x, double y);
  }

  private static double topRow(RoadViewSettings road, SensorGeometry sensor) {
    return road.vanishingPoint().on(sensor).yPx();
  }

  /** On random pixels of the road that the sensor sees. */
  private static void everywhere(Check check) {
    SplittableRandom random = new SplittableRandom(2);
    for (SensorGeometry sensor : SENSORS) {
      for (RoadViewSettings road : ROADS) {
        RoadMapping mapping = new RoadMapping(road, sensor);
        double rows = Math.min(sensor.height() - 1, 0.999 * topRow(road, sensor));
        for (int i = 0; i < 200; i++) {
          double x = random.nextDouble(0, sensor.width() - 1);
          double y = random.nextDouble(0, rows);
          assertTrue(mapping.seesPlane(x, y));
          check.of(mapping, x, y);
        }
      }
    }
  }

  @Test
  void inverseMappingIsExact() {
    everywhere(Planes::assertWayBackIsInverse);
  }

  @Test
  void jacobianMatchesCentralDifferences() {
    everywhere(Planes::assertJacobianIsDerivative);
  }

  @Test
  void bottomRowIsNearestAndVanishingRowFarthest() {
    for (SensorGeometry sensor : SENSORS) {
      for (RoadViewSettings road : ROADS) {
        RoadMapping mapping = new RoadMapping(road, sensor);
        assertEquals(road.nearestM(), mapping.planeY(0, 0), 1e-9);
        assertEquals(
            road.farthestM(), mapping.planeY(0, topRow(road, sensor)), 1e-9 * road.farthestM());
      }
    }
  }

  @Test
  void distanceIncreasesWithTheRow() {
    for (SensorGeometry sensor : SENSORS) {
      for (RoadViewSettings road : ROADS) {
        RoadMapping mapping = new RoadMapping(road, sensor);
        double before = 0;
        for (double y = 0; y < topRow(road, sensor); y += 0.25) {
          assertTrue(mapping.planeY(0, y) > before);
          before = mapping.planeY(0, y);
        }
        assertTrue(before < road.farthestM());
      }
    }
  }

  @Test
  void rowsAtOrAboveTheVanishingPointHaveNoPosition() {
    RoadViewSettings road = new RoadViewSettings(5, 2, 300, VanishingPoint.at(64, 100));
    RoadMapping mapping = new RoadMapping(road, SENSORS.get(0));
    assertTrue(mapping.seesPlane(0, 0));
    assertTrue(mapping.seesPlane(0, Math.nextDown(100.0)));
    assertFalse(mapping.seesPlane(0, 100));
    assertFalse(mapping.seesPlane(0, 127));
    assertFalse(mapping.seesPlane(0, Double.NaN));
    assertFalse(mapping.seesPlane(Double.NaN, 0));
    assertFalse(mapping.isSeen(0, -1));
    assertFalse(mapping.isSeen(0, 1e9));
    assertTrue(mapping.isSeen(0, 20));
    // γ(y) reaches a right angle where the road below the camera is seen: not ahead any more.
    double below = mapping.pixelY(0, 1e-9);
    assertTrue(below < 0);
    assertTrue(mapping.seesPlane(0, below + 1e-3));
    assertFalse(mapping.seesPlane(0, below - 1e-3));
  }

  @Test
  void defaultVanishingPointIsTheMiddleOfTheTopRow() {
    assertEquals(
        VanishingPoint.at(172.5, 259), VanishingPoint.defaults().on(new SensorGeometry(346, 260)));
    assertThrows(
        SettingsProblem.class,
        () -> new RoadMapping(RoadViewSettings.defaults(), new SensorGeometry(128, 1)));
  }

  @Test
  void mappingMatchesACaseComputedByHand() {
    // h = 10, d₁ = 10, d_v = 10 √3: β = 45°, γ_v = 30°, over 15 rows δ = 1° = π/180.
    // Row 5 looks down by 40°: d = 10 / tan 40° = 11.917536, its slant range 10 / sin 40° =
    // 15.557238; 4 columns to the right of x_v = 7: X = 4 · π/180 · 15.557238 = 1.086100.
    RoadViewSettings road =
        new RoadViewSettings(10, 10, 10 * Math.sqrt(3), VanishingPoint.at(7, 15));
    RoadMapping mapping = new RoadMapping(road, new SensorGeometry(64, 32));
    assertEquals(11.917536, mapping.planeY(0, 5), 1e-6);
    assertEquals(1.086100, mapping.planeX(11, 5), 1e-6);
    assertEquals(-1.086100, mapping.planeX(3, 5), 1e-6);
    // ∂d/∂y = δ (h² + d²) / h = 0.01745329 · 15.557238² / 10 = 0.422418.
    assertEquals(0.422418, mapping.jacobian(11, 5).yv(), 1e-6);
  }

  @Test
  void sensorWidthDoesNotMatterWithAMarkedVanishingPoint() {
    // The way back of the original took the longer side for the height.
    RoadMapping square = new RoadMapping(ROADS.get(1), new SensorGeometry(128, 128));
    RoadMapping wide = new RoadMapping(ROADS.get(1), new SensorGeometry(640, 128));
    assertEquals(square.planeX(50, 30), wide.planeX(50, 30));
    assertEquals(square.planeY(50, 30), wide.planeY(50, 30));
    assertEquals(square.pixelY(3, 30), wide.pixelY(3, 30));
  }

  @Test
  void covarianceInMetresMatchesSampledPixels() {
    SplittableRandom random = new SplittableRandom(6);
    RoadMapping mapping = new RoadMapping(RoadViewSettings.defaults(), SENSORS.get(1));
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
      double a = mapping.planeX(x + dx, y + common) - mapping.planeX(x, y);
      double b = mapping.planeY(x, y + common) - mapping.planeY(x, y);
      lateral += a * a / n;
      cross += a * b / n;
      distance += b * b / n;
    }
    PlaneJacobian jacobian = mapping.jacobian(x, y);
    assertEquals(1, lateral / jacobian.xx(2 * s * s, s * s, s * s), 0.05);
    assertEquals(1, cross / jacobian.xy(2 * s * s, s * s, s * s), 0.05);
    assertEquals(1, distance / jacobian.yy(2 * s * s, s * s, s * s), 0.05);
  }

  @Test
  void distantPixelCoversManyMetres() {
    RoadMapping mapping = new RoadMapping(RoadViewSettings.defaults(), SENSORS.get(0));
    PlaneJacobian near = mapping.jacobian(63.5, 0);
    PlaneJacobian far = mapping.jacobian(63.5, 126);
    // One row of 127 below the end of the road. Standard deviations go with h² + d² along the road
    // (29 m² at the bottom row, 37,000 m² here), and with its root across.
    assertTrue(far.yy(1, 0, 1) > 1e4 * near.yy(1, 0, 1));
    assertTrue(far.xx(1, 0, 1) > 1e2 * near.xx(1, 0, 1));
  }
}
