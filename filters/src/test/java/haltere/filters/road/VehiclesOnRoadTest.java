package haltere.filters.road;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.object.ObjectTrack;
import haltere.filters.plane.PlanePoint;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class VehiclesOnRoadTest {
  private static final double STEP_S = 0.01;
  private static final VehiclePrior PRIOR = VehiclePrior.defaults();
  private final VehiclesOnRoad road = new VehiclesOnRoad(SeenVehicle.ROAD, PRIOR);

  private PlanePoint follow(SeenVehicle vehicle, double untilS, SeenVehicle.Errors errors) {
    Optional<PlanePoint> last = Optional.empty();
    for (double s = 0; s < untilS; s += STEP_S) {
      last = road.apply(vehicle.seenAt(s, STEP_S, errors));
    }
    return last.orElseThrow();
  }

  private static SeenVehicle usual(double xM, double yM, double vyMS) {
    return new SeenVehicle(
        xM, yM, vyMS, PRIOR.lowEdgeM(), PRIOR.heightM() / 2, PRIOR.lengthM() / 2);
  }

  @Test
  void vehicleOfUsualHeightHasItsPositionAndSpeed() {
    SeenVehicle vehicle = usual(-3, 45, -15);
    PlanePoint point = follow(vehicle, 1.5, new SeenVehicle.Errors(1, 1e-3));
    assertEquals(vehicle.yAt(1.49), point.yM(), 0.1);
    assertEquals(-15, point.vyMS(), 0.15);
    assertEquals(-3, point.xM(), 0.05);
    assertEquals(54, point.speedKmH(), 0.6);
  }

  @Test
  void recedingVehiclesHaveAPositiveVelocity() {
    PlanePoint point = follow(usual(3, 9, 20), 1, new SeenVehicle.Errors(2, 1e-3));
    assertEquals(20, point.vyMS(), 0.2);
  }

  @Test
  void highVehicleIsNotTakenForAFastOne() {
    // the middle of a lorry, 2 m high, seems to move 1.67 times as fast on the road
    SeenVehicle lorry = new SeenVehicle(3, 9, 15, PRIOR.lowEdgeM(), 2, 6);
    PlanePoint point = follow(lorry, 1.5, new SeenVehicle.Errors(3, 1e-3));
    assertEquals(15, point.vyMS(), 0.45);
  }

  @Test
  void speedDeviationIncludesTheUnknownHeightOfTheLowerEdge() {
    PlanePoint point = follow(usual(3, 9, 20), 2, new SeenVehicle.Errors(4, 1e-3));
    double byHeight = 20 * PRIOR.lowEdgeM() / SeenVehicle.HEIGHT_M;
    assertTrue(point.sdVyMS() > 0.8 * byHeight, point.sdVyMS() + " m/s");
  }

  @Test
  void vehicleIsLocatedOnceItsExtentIsKnown() {
    SeenVehicle vehicle = usual(3, 9, 20);
    SeenVehicle.Errors errors = new SeenVehicle.Errors(5, 0.1);
    for (double s = 0; s < 0.295; s += STEP_S) {
      assertTrue(road.apply(vehicle.seenAt(s, STEP_S, errors)).isEmpty(), s + " s");
    }
    assertTrue(road.apply(vehicle.seenAt(0.31, STEP_S, errors)).isPresent());
  }

  @Test
  void vehicleClippedByTheBorderContinuesUnchanged() {
    SeenVehicle vehicle = usual(3, 20, -15);
    SeenVehicle.Errors errors = new SeenVehicle.Errors(6, 0.1);
    PlanePoint before = follow(vehicle, 0.8, errors);
    PlanePoint cut = before;
    for (int i = 1; i <= 20; i++) {
      long timeUs = before.timeUs() + 10_000L * i;
      cut = road.apply(SeenVehicle.row(timeUs, 80, 3, 0, 0, 0)).orElseThrow();
    }
    assertEquals(before.vyMS(), cut.vyMS(), 1e-9);
    assertEquals(before.yM() + 0.2 * before.vyMS(), cut.yM(), 1e-6);
    assertTrue(cut.sdYM() > before.sdYM());
  }

  @Test
  void brakingVehicleIsFollowed() {
    SeenVehicle.Errors errors = new SeenVehicle.Errors(7, 0.1);
    PlanePoint point = follow(usual(3, 60, -20), 1, errors);
    assertEquals(-20, point.vyMS(), 1.5);
    for (double s = STEP_S; s < 2; s += STEP_S) {
      // from 20 m/s at 40 m with 8 m/s²
      double y = 40 - 20 * s + 4 * s * s;
      SeenVehicle now = usual(3, y, -20 + 8 * s);
      point = road.apply(now.seen(point.timeUs() + 10_000, STEP_S, errors)).orElseThrow();
    }
    assertEquals(-4, point.vyMS(), 1.5);
  }

  @Test
  void trackThatGoesOverToAnotherVehicleHasTheSpeedOfThatVehicle() {
    SeenVehicle.Errors errors = new SeenVehicle.Errors(8, 0.1);
    PlanePoint away = follow(usual(3, 20, 14), 2, errors);
    assertEquals(14, away.vyMS(), 1.5);
    SeenVehicle other = usual(3, 50, -14);
    Optional<PlanePoint> point = Optional.empty();
    int withoutRow = 0;
    for (double s = STEP_S; s < 1.5; s += STEP_S) {
      long timeUs = away.timeUs() + Math.round(s * 1e6);
      ObjectTrack seen = other.at(other.yAt(s), -14).seen(timeUs, STEP_S, errors);
      // the velocity of the track is still that of the first vehicle
      double vy = -seen.vyPxS();
      point = road.apply(SeenVehicle.row(timeUs, seen.xPx(), seen.yPx(), seen.lowYPx(), 0, vy));
      withoutRow += point.isEmpty() ? 1 : 0;
    }
    assertTrue(withoutRow > 0, "a row although the extent of the vehicle is not known");
    assertEquals(-14, point.orElseThrow().vyMS(), 2 * point.orElseThrow().sdVyMS());
    assertTrue(point.orElseThrow().sdVyMS() < 4, point.toString());
  }
}
