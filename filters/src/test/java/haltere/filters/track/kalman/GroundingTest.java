package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.LaneSettings;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.VanishingPoint;
import haltere.filters.track.motion.MotionModes;
import haltere.filters.track.motion.MotionNoise;
import haltere.filters.track.road.GivenLine;
import org.junit.jupiter.api.Test;

/** How sure it is that a line is on the road, seen from a bridge of 5 m over four lanes. */
class GroundingTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final LaneSettings LANES = new LaneSettings(4, -7, 3.5);

  private final RoadMapping road =
      new RoadMapping(new RoadSettings(5, 6, 300, VanishingPoint.at(63.5, 127)), SENSOR);
  private final RoadLine line = new RoadLine();

  private MotionModes at(double xM, double yM, double vyMS) {
    MotionModes motion =
        new MotionModes(MotionNoise.onRoad(KalmanTracksSettings.defaults().motion(), 0.02));
    motion.launch(xM, yM - vyMS, 1e-4, 0, 1e-4);
    motion.coast(1, 1);
    motion.innovate(xM, yM, 1e-6, 0, 1e-6);
    motion.correct();
    return motion;
  }

  private Grounding look(double xM, double yM, double halfM, LaneSettings lanes) {
    line.halfWidthM = halfM;
    line.grounding.begin(false);
    line.grounding.look(at(xM, yM, -15), line, road, SENSOR, lanes);
    return line.grounding;
  }

  @Test
  void aLineThatReachesFarBesideTheLanesIsAboveTheRoad() {
    assertFalse(look(-5.3, 40, 1.25, LANES).isBeside(), "a lorry in the outer lane");
    assertEquals(0, line.grounding.speedShare());
    assertTrue(look(-7.3, 55, 1.25, LANES).isBeside(), "the roof of a car in the outer lane");
    assertTrue(look(7.3, 55, 1.25, LANES).isBeside(), "the same at the other side");
    assertTrue(line.grounding.speedShare() >= 0.3);
    assertFalse(look(-7.3, 55, 1.25, LaneSettings.defaults()).isBeside(), "lanes are not known");
  }

  @Test
  void aLineThatIsWiderThanAnyVehicleIsAboveTheRoad() {
    assertTrue(look(0, 40, 1.9, LaneSettings.defaults()).isBeside());
    assertFalse(look(0, 40, 1.35, LaneSettings.defaults()).isBeside());
    assertFalse(look(0, 150, 1.7, LaneSettings.defaults()).isBeside(), "columns are wide there");
  }

  @Test
  void aPieceOfACarThatDrivesAwayMayBeAboveTheRoadUntilAllOfTheCarWouldBeInThePicture() {
    assertTrue(away(5.7, 17).isHidden(), "the side of the picture may hide the rest");
    assertFalse(away(5.7, 24).isHidden());
    assertFalse(away(1.75, 17).isHidden(), "in the middle of the picture");
  }

  @Test
  void theDoubtOfWhatDrivesAwayIsSmallOnceItHasPassedManyRows() {
    line.last.begin();
    line.last.turnTo(GivenLine.ofSpeed(15), 0);
    assertEquals(0.2, away(5.7, 17).speedShare(), 1e-9);
    for (int row = 1; row <= 8; row++) {
      line.last.pass(row, row, 64, 15);
    }
    assertEquals(0.05, away(5.7, 17).speedShare(), 1e-9);
  }

  private Grounding away(double xM, double yM) {
    line.halfWidthM = 0.27;
    line.grounding.begin(true);
    line.grounding.look(at(xM, yM, 15), line, road, SENSOR, LANES);
    return line.grounding;
  }

  @Test
  void aNarrowLineMayBeShouldersUntilItWasFollowedWhereWheelsWouldBeSeen() {
    line.last.begin();
    line.last.turnTo(GivenLine.ofSpeed(15), 0);
    Grounding grounding = look(1.75, 15, 0.2, LANES);
    assertTrue(grounding.speedShare() > 0);
    for (int row = 1; row <= 8; row++) {
      line.last.pass(row, row, 64, 15);
    }
    grounding.look(at(1.75, 40, 15), line, road, SENSOR, LANES);
    assertTrue(grounding.speedShare() > 0, "too far away to be sure");
    grounding.look(at(1.75, 15, 15), line, road, SENSOR, LANES);
    assertEquals(0, grounding.speedShare());
    grounding.look(at(1.75, 40, 15), line, road, SENSOR, LANES);
    assertEquals(0, grounding.speedShare(), "was seen before");
  }

  @Test
  void aLineBetweenTwoLanesIsDoubtedForItMayBeAHigherOneOfWhatIsNearer() {
    assertEquals(0, look(-1.5, 30, 0.9, LANES).speedShare(), "in its lane");
    assertEquals(0.07, look(-2.6, 30, 0.9, LANES).speedShare(), 1e-9);
    assertEquals(0, look(-2.6, 30, 0.9, LaneSettings.defaults()).speedShare(), "no lanes known");
  }

  @Test
  void aLineFasterThanMostVehiclesIsDoubtedUntilAllBelowItWouldHaveBeenSeen() {
    line.last.begin();
    line.last.turnTo(GivenLine.ofSpeed(-48), 0);
    line.halfWidthM = 0.9;
    line.grounding.begin(false);
    line.grounding.look(at(-1.75, 50, -48), line, road, SENSOR, LANES);
    assertEquals(0.3, line.grounding.speedShare(), 1e-9);
    for (int row = 100; row >= 90; row--) {
      line.last.pass(row, 1, 64, -48);
    }
    line.grounding.look(at(-1.75, 15, -48), line, road, SENSOR, LANES);
    assertEquals(0, line.grounding.speedShare(), 1e-9);
  }
}
