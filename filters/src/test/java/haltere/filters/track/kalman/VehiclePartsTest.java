package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.VanishingPoint;
import haltere.filters.track.road.FoundLine;
import haltere.filters.track.road.GivenLine;
import haltere.filters.track.road.RoadEvents;
import org.junit.jupiter.api.Test;

/** A lorry that comes at 15 m/s and is 38 m away, seen from a bridge of 5 m. */
class VehiclePartsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final double Y_M = 38;
  private static final double SPEED_M_S = -15;

  private final RoadMapping road =
      new RoadMapping(new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127)), SENSOR);
  private final MeasurementPlane plane = new MeasurementPlane(road);
  private final RoadEvents events = new RoadEvents(road, SENSOR);
  private final FoundLine found = GivenLine.ofSpeed(SPEED_M_S);
  private final VehicleParts parts = new VehicleParts(road, events, found);
  private final Track lorry = GivenTrack.in(plane);

  private void find(double xM, double yM, double speedMS, double halfM) {
    GivenLine.set(found, xM, yM, speedMS, halfM, (int) Math.round(road.rowOf(yM)));
  }

  /** Begins to follow the lorry by a line, with so many rows that were passed since. */
  private void follow(int updates) {
    find(-1.9, Y_M, SPEED_M_S, 1.5);
    lorry.launchLine(found, 0);
    lorry.line.begin(found, 0);
    lorry.line.grounding.begin(false);
    lorry.updates = updates;
    double perColumnM = road.pixelAngle() * Math.hypot(5, Y_M);
    lorry.line.expect(lorry, plane, 0, perColumnM, SENSOR.width());
  }

  @Test
  void aVehicleThatPassedSomeRowsDoesNotGoOverToALineOfAnotherThatWouldBeFarBelowIt() {
    follow(6);
    find(-1.3, 8.7, -7.15, 1);
    assertFalse(parts.isPartOf(lorry, 0), "the tail of the car before it");
    assertEquals(Y_M, lorry.motion.y(), 0.1);
  }

  @Test
  void aLineThatWasJustFoundIsTheRoofOfWhatIsFarBelowIt() {
    follow(1);
    find(-0.95, 19, 0.5 * SPEED_M_S, 1.2);
    assertTrue(parts.isPartOf(lorry, 0));
    assertEquals(19, lorry.motion.y(), 0.1);
    assertEquals(0.5 * SPEED_M_S, lorry.motion.vy(), 0.1);
  }
}
