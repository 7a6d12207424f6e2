package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.track.CountingLineSettings;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.LineCrossing;
import haltere.filters.track.LineCrossing.Direction;
import haltere.filters.track.MeasurementSettings;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.RoadTracksSettings;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class LineCounterTest {
  private static final LaneSettings LANES = new LaneSettings(4, -7, 3.5);

  private final List<LineCrossing> crossings = new ArrayList<>();

  private static RoadTracksSettings lines(int lines) {
    return new RoadTracksSettings(
        true, RoadSettings.defaults(), 0.05, LANES, new CountingLineSettings(lines, 20, 20));
  }

  private static Track vehicle(int id) {
    MotionNoise noise =
        MotionNoise.onRoad(KalmanTracksSettings.defaults().motion(), lines(0).processVariance());
    Track track = new Track(noise, new MeasurementPlane(null), MeasurementSettings.defaults());
    track.id = id;
    return track;
  }

  /** Drives at a speed, seen well, and looks at the lines ten times a second. */
  private static void drive(LineCounter counter, Track track, double xM, double fromM, double mS) {
    for (int k = 0; k <= 50; k++) {
      track.bornUs = 0;
      if (k == 0) {
        track.motion.launch(xM, fromM, 1e-4, 0, 1e-4);
      } else {
        track.motion.coast(0.1, 1);
        track.motion.innovate(xM, fromM + mS * 0.1 * k, 1e-4, 0, 1e-4);
        track.motion.correct();
      }
      track.stateUs = 100_000L * k;
      counter.look(track);
    }
  }

  @Test
  void eachVehicleCountsOnceAtEachLineInItsLaneAndDirection() {
    LineCounter counter = new LineCounter(lines(2), crossings::add);
    drive(counter, vehicle(1), 1, 10, 15);
    drive(counter, vehicle(2), -5, 60, -15);
    drive(counter, vehicle(3), 2, 15, 15);
    assertEquals(
        List.of(
            "1 at 20.0 AWAY lane 2: 1/0",
            "1 at 40.0 AWAY lane 2: 1/0",
            "2 at 40.0 TOWARDS lane 0: 0/1",
            "2 at 20.0 TOWARDS lane 0: 0/1",
            "3 at 20.0 AWAY lane 2: 2/0",
            "3 at 40.0 AWAY lane 2: 2/0"),
        crossings.stream().map(LineCounterTest::text).toList());
    LineCrossing first = crossings.get(0);
    assertEquals(1e6 * 10 / 15, first.timeUs(), 20_000);
    assertEquals(54, first.speedKmH(), 1);
    assertTrue(first.sdSpeedKmH() > 0 && first.sdSpeedKmH() < 1);
  }

  private static String text(LineCrossing crossing) {
    return crossing.id()
        + " at "
        + crossing.lineM()
        + " "
        + crossing.direction()
        + " lane "
        + crossing.lane()
        + ": "
        + crossing.countAway()
        + "/"
        + crossing.countTowards();
  }

  @Test
  void aVehicleThatStandsOnALineIsNotCountedAgainAndAgain() {
    LineCounter counter = new LineCounter(lines(1), crossings::add);
    Track track = vehicle(1);
    track.motion.launch(0, 19, 0.01, 0, 0.01);
    counter.look(track);
    for (int k = 0; k < 100; k++) {
      track.motion.launch(0, k % 2 == 0 ? 19.8 : 20.2, 0.04, 0, 0.04);
      counter.look(track);
    }
    assertEquals(List.of(), crossings);
    track.motion.launch(0, 21, 0.01, 0, 0.01);
    counter.look(track);
    assertEquals(1, crossings.size());
    assertEquals(Direction.AWAY, crossings.get(0).direction());
  }

  @Test
  void beginningBeyondALineIsNoCrossing() {
    LineCounter counter = new LineCounter(lines(1), crossings::add);
    drive(counter, vehicle(1), 0, 25, 10);
    assertEquals(List.of(), crossings);
  }

  @Test
  void lanesAreCountedFromTheLeft() {
    assertEquals(0, LANES.laneAt(-7));
    assertEquals(1, LANES.laneAt(-0.01));
    assertEquals(2, LANES.laneAt(0));
    assertEquals(3, LANES.laneAt(6.99));
    assertEquals(LaneSettings.BESIDE, LANES.laneAt(7));
    assertEquals(LaneSettings.BESIDE, LANES.laneAt(-7.01));
    assertEquals(LaneSettings.BESIDE, LANES.laneAt(Double.NaN));
    assertEquals(LaneSettings.BESIDE, LaneSettings.defaults().laneAt(0));
  }
}
