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

  @Test
  void whatGoesOverALineIsCountedOnceThere() {
    assertFalse(sides.cross(0, -1, AWAY));
    assertTrue(sides.cross(0, 1, AWAY));
    assertFalse(sides.cross(0, 1, AWAY));
  }

  @Test
  void whatIsFirstSeenBeyondALineHasNotCrossedIt() {
    assertTrue(sides.isNew(0));
    assertFalse(sides.cross(0, 1, AWAY));
    assertFalse(sides.isNew(0));
  }

  @Test
  void aPlaceThatIsMendedBackOverTheLineIsNoCrossingAndTheLineIsNotCrossedTwice() {
    sides.cross(0, -1, AWAY);
    assertTrue(sides.cross(0, 1, AWAY));
    assertFalse(sides.cross(0, -1, AWAY));
    assertFalse(sides.cross(0, 1, AWAY));
  }

  @Test
  void whoComesBackIsCountedOnTheWayBack() {
    sides.cross(0, -1, AWAY);
    sides.cross(0, 1, AWAY);
    assertTrue(sides.cross(0, -1, TOWARDS));
    assertTrue(sides.cross(0, 1, AWAY));
  }

  @Test
  void aTrackThatTakesOverFromAnotherDoesNotCountWhatThatOneHasCounted() {
    LineSides other = lines();
    other.cross(0, -1, AWAY);
    other.cross(0, 1, AWAY);
    sides.cross(0, -1, AWAY);
    sides.cross(1, -1, AWAY);
    sides.join(other, false);
    assertFalse(sides.cross(0, 1, AWAY));
    assertTrue(sides.cross(1, 1, AWAY));
  }

  @Test
  void aTrackThatBeganBeyondTheLineIsCountedThereIfAnOlderOneOfTheSameVehicleCameFromBefore() {
    LineSides other = lines();
    other.cross(0, -1, AWAY);
    sides.cross(0, 1, AWAY);
    sides.join(other, true);
    assertTrue(sides.cross(0, 1, AWAY));
  }

  @Test
  void aNewTrackKnowsNothingOfTheLastOne() {
    sides.cross(0, 1, AWAY);
    sides.clear();
    assertTrue(sides.isNew(0));
  }
}
