package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.CountingLineSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.LineCrossing;
import haltere.filters.track.LineCrossing.Direction;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.RoadTracksSettings;
import haltere.filters.track.motion.MotionModes;
import haltere.filters.track.road.GivenLine;
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
    Track track = GivenTrack.in(new MeasurementPlane(null));
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
      counter.look(track, track.stateUs, null);
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
    counter.look(track, track.stateUs, null);
    for (int k = 0; k < 100; k++) {
      track.motion.launch(0, k % 2 == 0 ? 19.8 : 20.2, 0.04, 0, 0.04);
      counter.look(track, track.stateUs, null);
    }
    assertEquals(List.of(), crossings);
    track.motion.launch(0, 21, 0.01, 0, 0.01);
    counter.look(track, track.stateUs, null);
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

  private static final WayBack SEEN = new Past(true, false);
  private static final WayBack NOT_SEEN = new Past(false, false);
  private static final WayBack ON_OTHER = new Past(true, true);

  private record Past(boolean isSeen, boolean isHigher) implements WayBack {
    @Override
    public boolean leadsTo(Track track, MotionModes motion, double lineM, long timeUs) {
      return isSeen;
    }

    @Override
    public boolean isOnOther(Track track, MotionModes motion, long timeUs) {
      return isHigher;
    }
  }

  /** A vehicle that was found, with so many rows that it was seen to pass. */
  private static Track found(int id, double xM, double yM, double mS, int rows) {
    Track track = vehicle(id);
    track.line.last.begin();
    track.line.halfWidthM = 0.9;
    set(track, xM, yM, mS);
    track.updates = rows;
    return track;
  }

  private static void set(Track track, double xM, double yM, double mS) {
    track.motion.launch(xM, yM, 1e-4, 0, 1e-4);
    for (int k = 1; k <= 3; k++) {
      track.motion.coast(0.1, 1);
      track.motion.innovate(xM, yM + mS * 0.1 * k, 1e-4, 0, 1e-4);
      track.motion.correct();
    }
    track.motion.shift(-0.3 * mS, 0);
    track.stateUs = 10_000_000;
  }

  @Test
  void whatIsFoundBeyondALineIsCountedThereWhenItCrossedIfItWasSeenOnItsWay() {
    LineCounter counter = new LineCounter(lines(2), crossings::add);
    Track track = found(1, -1.75, 17, -15, 6);
    counter.look(track, 10_000_000, SEEN);
    assertEquals(List.of(), crossings, "not yet sure");
    track.updates = 7;
    counter.look(track, 10_000_000, NOT_SEEN);
    assertEquals(List.of(), crossings, "was not on its way");
    counter.look(found(2, -1.75, 17, -15, 7), 10_000_000, SEEN);
    assertEquals(
        List.of("2 at 20.0 TOWARDS lane 1: 0/1", "2 at 40.0 TOWARDS lane 1: 0/1"),
        crossings.stream().map(LineCounterTest::text).toList());
    assertEquals(10e6 - 3.0 / 15 * 1e6, crossings.get(0).timeUs(), 20_000);
    assertEquals(10e6 - 23.0 / 15 * 1e6, crossings.get(1).timeUs(), 50_000);
  }

  @Test
  void twoTracksOnOneVehicleCountOnceAndTheNextVehicleCountsToo() {
    LineCounter counter = new LineCounter(lines(1), crossings::add);
    counter.look(found(1, 1.2, 25, 15, 7), 10_000_000, SEEN);
    counter.look(found(2, 2.0, 23, 15, 7), 10_000_000, SEEN);
    assertEquals(1, crossings.size(), "within the car that was counted");
    counter.look(found(3, 5.2, 25, 15, 7), 10_000_000, SEEN);
    assertEquals(2, crossings.size(), "beside it");
    Track next = found(4, 1.2, 25, 15, 7);
    next.stateUs = 11_000_000;
    counter.look(next, 11_000_000, SEEN);
    assertEquals(3, crossings.size(), "15 m behind it");
    assertEquals(3, counter.lines().get(0).away());
  }

  @Test
  void whatIsBesideTheRoadOrAnywhereIsNotCounted() {
    LineCounter counter = new LineCounter(lines(1), crossings::add);
    counter.look(found(1, 9.5, 25, 15, 7), 10_000_000, SEEN);
    Track unsure = found(2, 1.75, 25, 15, 7);
    unsure.motion.shift(0, 9);
    counter.look(unsure, 10_000_000, SEEN);
    assertEquals(List.of(), crossings);
  }

  @Test
  void aLineAboveTheRoadIsCountedOnceItsVehicleIsFoundBelow() {
    LineCounter counter = new LineCounter(lines(1), crossings::add);
    RoadMapping road = new RoadMapping(RoadSettings.defaults(), new SensorGeometry(128, 128));
    SensorGeometry sensor = new SensorGeometry(128, 128);
    Track track = found(1, 7.4, 25, 20, 7);
    track.line.grounding.look(track.motion, track.line, road, sensor, LANES);
    counter.look(track, 10_000_000, SEEN);
    assertEquals(List.of(), crossings, "on the roof");
    set(track, 5.3, 21, 15);
    track.line.grounding.look(track.motion, track.line, road, sensor, LANES);
    counter.look(track, 10_000_000, SEEN);
    assertEquals(1, crossings.size());
  }

  @Test
  void theSpeedOfALineThatWasJustFoundIsUnsureUntilItHasPassedRows() {
    Track track = found(1, 1.75, 25, 15, 7);
    track.line.last.turnTo(GivenLine.ofSpeed(15), 10_000_000);
    double before = RoadSpeed.sdKmH(track, track.motion);
    assertTrue(before > 0.1 * 54);
    for (int row = 1; row <= 20; row++) {
      track.line.last.pass(row, 10_000_000, 70, 15);
    }
    assertTrue(RoadSpeed.sdKmH(track, track.motion) < before / 10);
  }

  @Test
  void whatPassesTooFewRowsForItsSpeedIsNotCounted() {
    LineCounter counter = new LineCounter(lines(1), crossings::add);
    Track track = found(1, 1.75, 25, 28, 7);
    for (int row = 10; row < 50; row += 4) {
      track.line.last.pass(row, 10_000_000, 70, 28);
    }
    counter.look(track, 10_000_000, SEEN);
    assertEquals(List.of(), crossings);
    for (int row = 50; row < 58; row++) {
      track.line.last.pass(row, 10_000_000, 70, 28);
    }
    counter.look(track, 10_000_000, SEEN);
    assertEquals(1, crossings.size());
  }

  @Test
  void whatMayBeOnAnotherVehicleIsCountedOnceItIsNot() {
    LineCounter counter = new LineCounter(lines(1), crossings::add);
    Track track = found(1, 1.75, 15, 15, 7);
    counter.look(track, 10_000_000, ON_OTHER);
    set(track, 1.75, 25, 15);
    counter.look(track, 10_000_000, ON_OTHER);
    assertEquals(List.of(), crossings);
    counter.look(track, 10_000_000, NOT_SEEN);
    assertEquals(1, crossings.size());
    assertEquals(10e6 - 5.0 / 15 * 1e6, crossings.get(0).timeUs(), 20_000);
  }
}
