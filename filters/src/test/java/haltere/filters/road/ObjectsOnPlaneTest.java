package haltere.filters.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.PlanePoint;
import haltere.filters.plane.RoadMapping;
import haltere.filters.plane.RoadViewSettings;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ObjectsOnPlaneTest {
  private static ObjectTrack at(double x, double y, double vy, double minor) {
    return new ObjectTrack(1000, 4, x, y, 0, vy, 1, 1, 10, 10, 500, 8, minor, 0, 0.99, 1e4, 1.5);
  }

  @Test
  void anObjectStandsWhereItsExtentIsLowest() {
    RoadMapping road = new RoadMapping(RoadViewSettings.defaults(), new SensorGeometry(128, 128));
    PlanePoint point = new ObjectsOnPlane(road).locate(at(64, 60, 20, 5)).orElseThrow();
    assertEquals(road.planeY(64, 55), point.yM(), 1e-9);
    double metres = road.planeY(64, 55.001) - road.planeY(64, 54.999);
    assertEquals(20 * metres / 0.002, point.vyMS(), 1e-3);
    assertEquals(metres / 0.002, point.sdYM(), 1e-3);
    assertEquals(4, point.id());
  }

  @Test
  void whatIsAboveTheHorizonIsNotOnTheRoad() {
    RoadMapping road = new RoadMapping(RoadViewSettings.defaults(), new SensorGeometry(128, 128));
    assertEquals(Optional.empty(), new ObjectsOnPlane(road).locate(at(64, 140, 0, 5)));
    assertTrue(new ObjectsOnPlane(PlaneMapping.PICTURE).locate(at(64, 140, 0, 5)).isPresent());
  }
}
