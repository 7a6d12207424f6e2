package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.LifeSettings;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.VanishingPoint;
import org.junit.jupiter.api.Test;

/** Tracks that stand and are not heard, 25 m from a bridge of 5 m. */
class VehicleEndsTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final LaneSettings LANES = new LaneSettings(4, -7, 3.5);

  private final RoadMapping road =
      new RoadMapping(new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127)), SENSOR);
  private final MeasurementPlane plane = new MeasurementPlane(road);
  private final VehicleEnds ends = new VehicleEnds(road, SENSOR, plane);
  private final Track track = GivenTrack.in(plane);

  /** Whether it is gone when it has stood for so long. */
  private boolean isOverAfter(double seconds, int updates, double xM) {
    ends.apply(LifeSettings.defaults());
    long timeUs = Math.round(seconds * 1e6);
    track.stateUs = timeUs;
    track.motion.launch(xM, 25, 1e-4, 0, 1e-4);
    track.updates = updates;
    track.line.halfWidthM = 0.9;
    track.line.grounding.look(track.motion, track.line, road, SENSOR, LANES);
    ends.look(track, timeUs);
    assertTrue(track.stands);
    return ends.isOver(track, timeUs);
  }

  @Test
  void aVehicleThatHasStoppedIsRememberedForLong() {
    assertFalse(isOverAfter(6, 20, 1.75));
  }

  @Test
  void whatPassedHardlyAnyRowsHasNotStoppedAndIsSoonGone() {
    assertFalse(isOverAfter(1, 2, 1.75));
    assertTrue(isOverAfter(6, 2, 1.75));
  }

  @Test
  void nothingStandsBesideTheRoad() {
    assertTrue(isOverAfter(6, 20, 8));
  }
}
