package haltere.filters.road;

import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.SensorGeometry;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.PlanePoint;
import haltere.filters.plane.RoadMapping;
import haltere.filters.plane.RoadViewSettings;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class ObjectsOnPlaneTest {
  @Test
  void positionOfAnObjectIsThatOfItsCentre() {
    PlanePoint point =
        new ObjectsOnPlane(PlaneMapping.PICTURE)
            .apply(SeenVehicle.row(1000, 64, 60, 55, 0, 20))
            .orElseThrow();
    assertEquals(64, point.xM());
    assertEquals(60, point.yM());
    assertEquals(20, point.vyMS());
    assertEquals(SeenVehicle.ID, point.id());
  }

  @Test
  void velocitiesAndDeviationsAreMappedToThePlane() {
    RoadMapping road = new RoadMapping(RoadViewSettings.defaults(), new SensorGeometry(128, 128));
    PlanePoint point =
        new ObjectsOnPlane(road).apply(SeenVehicle.row(1000, 64, 60, 55, 0, 20)).orElseThrow();
    double metresPerRow = (road.planeY(64, 60.001) - road.planeY(64, 59.999)) / 0.002;
    assertEquals(20 * metresPerRow, point.vyMS(), 1e-3);
    assertEquals(SeenVehicle.SD_PX * metresPerRow, point.sdYM(), 1e-3);
  }

  @Test
  void pointsAboveTheHorizonAreNotOnThePlane() {
    RoadMapping road = new RoadMapping(RoadViewSettings.defaults(), new SensorGeometry(128, 128));
    assertEquals(
        Optional.empty(),
        new ObjectsOnPlane(road).apply(SeenVehicle.row(1000, 64, 140, 135, 0, 0)));
  }
}
