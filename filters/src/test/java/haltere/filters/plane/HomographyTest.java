package haltere.filters.plane;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class HomographyTest {
  /** A square of 200 mm on a table, seen at a slant. */
  private static final List<PointPair> TABLE =
      List.of(
          new PointPair(20, 10, 0, 0),
          new PointPair(110, 14, 200, 0),
          new PointPair(92, 80, 200, 200),
          new PointPair(41, 77, 0, 200));

  @Test
  void fourPixelsMapToTheirPositions() {
    Homography table = new Homography(TABLE);
    for (PointPair point : TABLE) {
      assertEquals(point.x(), table.planeX(point.xPx(), point.yPx()), 1e-9);
      assertEquals(point.y(), table.planeY(point.xPx(), point.yPx()), 1e-9);
      assertEquals(point.xPx(), table.pixelX(point.x(), point.y()), 1e-9);
      assertEquals(point.yPx(), table.pixelY(point.x(), point.y()), 1e-9);
    }
  }

  @Test
  void inverseMappingAndJacobianAreCorrect() {
    Homography table = new Homography(TABLE);
    SplittableRandom random = new SplittableRandom(3);
    for (int i = 0; i < 500; i++) {
      double x = random.nextDouble(0, 128);
      double y = random.nextDouble(0, 100);
      assertTrue(table.seesPlane(x, y));
      Planes.assertWayBackIsInverse(table, x, y);
      Planes.assertJacobianIsDerivative(table, x, y);
    }
  }

  @Test
  void pinholeCameraIsRecoveredFromFourPoints() {
    Pinhole camera = new Pinhole(700, 0.6, 4);
    Homography found =
        new Homography(
            List.of(camera.see(-3, 8), camera.see(3, 8), camera.see(2, 30), camera.see(-4, 25)));
    for (double x = -8; x <= 8; x += 2) {
      for (double y = 6; y < 60; y += 5) {
        PointPair seen = camera.see(x, y);
        assertEquals(x, found.planeX(seen.xPx(), seen.yPx()), 1e-6);
        assertEquals(y, found.planeY(seen.xPx(), seen.yPx()), 1e-6);
      }
    }
    assertFalse(found.seesPlane(320, camera.horizonY() + 1), "above the horizon");
    assertTrue(found.seesPlane(320, camera.horizonY() - 1), "below the horizon");
    assertFalse(found.isSeen(0, -50), "behind the camera");
  }

  /** Looks ahead and down by an angle from a height; the middle of its picture is (320, 240). */
  private record Pinhole(double focalPx, double downRad, double heightM) {
    PointPair see(double x, double y) {
      double depth = y * Math.cos(downRad) + heightM * Math.sin(downRad);
      double up = y * Math.sin(downRad) - heightM * Math.cos(downRad);
      return new PointPair(320 + focalPx * x / depth, 240 + focalPx * up / depth, x, y);
    }

    double horizonY() {
      return 240 + focalPx * Math.tan(downRad);
    }
  }

  @Test
  void degeneratePointsAreRejected() {
    List<PointPair> line =
        List.of(
            TABLE.get(0), TABLE.get(1), new PointPair(65, 12, 100, 90), new PointPair(3, 90, 7, 8));
    List<PointPair> crossed =
        List.of(
            TABLE.get(0),
            TABLE.get(1),
            new PointPair(92, 80, 0, 200),
            new PointPair(41, 77, 200, 200));
    for (List<PointPair> points : List.of(TABLE.subList(0, 3), line, crossed)) {
      assertThrows(IllegalArgumentException.class, () -> new Homography(points));
    }
    assertThrows(IllegalArgumentException.class, () -> new PointPair(1, Double.NaN, 0, 0));
  }

  @Test
  void identityMappingYieldsPixels() {
    PlaneMapping picture = PlaneMapping.PICTURE;
    Planes.assertWayBackIsInverse(picture, -3, 77);
    Planes.assertJacobianIsDerivative(picture, 4, 5);
    assertFalse(picture.seesPlane(Double.NaN, 0));
    RoadMapping road = new RoadMapping(RoadViewSettings.defaults(), new SensorGeometry(128, 128));
    assertTrue(road.seesPlane(5, 5) && picture.seesPlane(5, 500));
  }
}
