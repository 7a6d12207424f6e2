package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.VanishingPoint;
import haltere.filters.track.motion.MotionModes;
import org.junit.jupiter.api.Test;

/** A vehicle 23 m away in the left lane, seen from a bridge of 5 m. */
class RoadLineTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final RoadSettings VIEW =
      new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127));
  private static final double X_M = -5.2;
  private static final double Y_M = 23;
  private static final double LORRY_M = 12;

  private final RoadMapping road = new RoadMapping(VIEW, SENSOR);
  private final MeasurementPlane plane = new MeasurementPlane(road);
  private final Track track = GivenTrack.in(plane);

  private boolean isBeside(double xM, double yM) {
    int row = (int) Math.round(road.rowOf(yM));
    int column = (int) Math.round(road.columnOf(xM, yM));
    double perColumnM = road.lateralPerX(row);
    double lateralM = (column - road.vanishingX()) * perColumnM;
    return Double.isNaN(
        track.line.above(0, column, row, lateralM, road.distanceM(row), perColumnM));
  }

  private void expectLorry() {
    track.motion.launch(X_M, Y_M, 1e-4, 0, 1e-4);
    track.line.halfWidthM = 1.25;
    double perColumnM = road.pixelAngle() * Math.hypot(5, Y_M);
    track.line.expect(track, plane, 0, perColumnM, SENSOR.width());
    track.line.setOwn(100, 100, Y_M + LORRY_M);
  }

  @Test
  void whatIsAsFarAwayAsAVehicleIsLongIsOnItFlatAndUpright() {
    expectLorry();
    assertFalse(isBeside(X_M, Y_M + 5), "flat");
    assertFalse(isBeside(X_M * (Y_M + 5) / Y_M, Y_M + 5), "upright");
    assertTrue(isBeside(X_M + 4, Y_M + 5), "in the next lane");
  }

  @Test
  void theVehicleBehindALorryIsNotOnItForTheRoofOfTheLorryIsFartherAside() {
    expectLorry();
    double behindM = 70;
    assertTrue(isBeside(X_M, behindM), "on the road behind it");
    assertFalse(isBeside(X_M * behindM / (Y_M + LORRY_M), behindM), "the far end of its roof");
    assertFalse(isBeside(X_M * behindM / Y_M, behindM), "the near end");
  }

  @Test
  void aVehicleThatIsHeldToStandDoesNotGoBackwards() {
    MotionModes motion = track.motion;
    motion.launch(X_M, Y_M, 1e-4, 0, 1e-4);
    for (int k = 1; k <= 5; k++) {
      motion.coast(0.1, 1);
      motion.innovate(X_M, Y_M - 0.1 * k, 1e-4, 0, 1e-4);
      motion.correct();
    }
    assertTrue(motion.vy() < -0.5);
    motion.goOnly(-1);
    assertTrue(motion.vy() < -0.5, "forwards");
    motion.goOnly(1);
    assertEquals(0, motion.vy());
    double place = motion.y();
    motion.coast(2, 1);
    assertEquals(place, motion.y(), 1e-6);
  }
}
