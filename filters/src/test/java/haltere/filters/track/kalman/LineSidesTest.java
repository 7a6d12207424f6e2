package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class LineSidesTest {
  private static final int AWAY = 1;
  private static final int TOWARDS = -1;
  private final LineSides sides = lines();

  private static LineSides lines() {
    LineSides sides = new LineSides();
    sides.setLines(2);
    return sides;
  }

  /** Goes to a side; counts what crosses. */
  private static boolean cross(LineSides sides, int line, int side, int way) {
    boolean crosses = sides.cross(line, side, way, false);
    if (crosses) {
      sides.count(line, side);
    }
    return crosses;
  }

  @Test
  void whatGoesOverALineIsCountedOnceThere() {
    assertFalse(cross(sides, 0, -1, AWAY));
    assertTrue(cross(sides, 0, 1, AWAY));
    assertFalse(cross(sides, 0, 1, AWAY));
  }

  @Test
  void whatIsFirstSeenBeyondALineHasNotCrossedIt() {
    assertTrue(sides.isNew(0));
    assertFalse(cross(sides, 0, 1, AWAY));
    assertFalse(sides.isNew(0));
  }

  @Test
  void aPlaceThatIsMendedBackOverTheLineIsNoCrossingAndTheLineIsNotCrossedTwice() {
    cross(sides, 0, -1, AWAY);
    assertTrue(cross(sides, 0, 1, AWAY));
    assertFalse(cross(sides, 0, -1, AWAY));
    assertFalse(cross(sides, 0, 1, AWAY));
  }

  @Test
  void whoComesBackIsCountedOnTheWayBack() {
    cross(sides, 0, -1, AWAY);
    cross(sides, 0, 1, AWAY);
    assertTrue(cross(sides, 0, -1, TOWARDS));
    assertTrue(cross(sides, 0, 1, AWAY));
  }

  @Test
  void aTrackThatTakesOverFromAnotherDoesNotCountWhatThatOneHasCounted() {
    LineSides other = lines();
    cross(other, 0, -1, AWAY);
    cross(other, 0, 1, AWAY);
    cross(sides, 0, -1, AWAY);
    cross(sides, 1, -1, AWAY);
    sides.join(other, false, AWAY);
    assertFalse(cross(sides, 0, 1, AWAY));
    assertTrue(cross(sides, 1, 1, AWAY));
  }

  @Test
  void aTrackThatBeganBeyondTheLineIsCountedThereIfAnOlderOneOfTheSameVehicleCameFromBefore() {
    LineSides other = lines();
    cross(other, 0, -1, AWAY);
    cross(sides, 0, 1, AWAY);
    sides.join(other, true, AWAY);
    assertTrue(cross(sides, 0, 1, AWAY));
  }

  @Test
  void aNewTrackKnowsNothingOfTheLastOne() {
    cross(sides, 0, 1, AWAY);
    sides.clear();
    assertTrue(sides.isNew(0));
  }

  @Test
  void aHigherLineThatSeemedToBeBeyondTheLineTakesNothingFromTheVehicle() {
    LineSides roof = lines();
    cross(roof, 0, 1, AWAY);
    cross(sides, 0, -1, AWAY);
    sides.join(roof, true, AWAY);
    assertTrue(cross(sides, 0, 1, AWAY));
  }

  @Test
  void aTrackThatKnowsNoLinesTakesNothing() {
    cross(sides, 0, -1, AWAY);
    sides.join(new LineSides(), true, AWAY);
    assertTrue(cross(sides, 0, 1, AWAY));
  }

  @Test
  void twoThatWereBothCountedAtALineAreTwoAndAPartOfOneThatWasCountedIsNot() {
    LineSides other = lines();
    sides.count(0, 1);
    other.count(1, 1);
    assertFalse(sides.isOtherThan(other));
    other.refuse(0, 1);
    assertFalse(sides.isOtherThan(other), "it was not counted");
    other.count(0, -1);
    assertFalse(sides.isOtherThan(other), "the other way");
    other.count(0, 1);
    assertTrue(sides.isOtherThan(other));
  }

  @Test
  void whatIsSuddenlyFartherBackWasOnAnotherVehicleIfItComesAndOnItsOwnRoofIfItDrivesAway() {
    sides.follow(10, TOWARDS, 5);
    cross(sides, 0, 1, TOWARDS);
    cross(sides, 0, -1, TOWARDS);
    sides.follow(13, TOWARDS, 5);
    assertTrue(sides.isOnItsWay(), "as far as it may seem to be off");
    sides.follow(40, TOWARDS, 5);
    assertFalse(sides.isOnItsWay());
    assertTrue(sides.isNew(0));
    cross(sides, 0, 1, TOWARDS);
    assertTrue(cross(sides, 0, -1, TOWARDS), "another vehicle");
    LineSides away = lines();
    away.follow(30, AWAY, 5);
    away.count(0, 1);
    away.follow(15, AWAY, 5);
    cross(away, 0, -1, AWAY);
    assertFalse(cross(away, 0, 1, AWAY), "the same vehicle");
  }
}
