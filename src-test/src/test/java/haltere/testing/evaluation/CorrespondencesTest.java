package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class CorrespondencesTest {
  private static void check(
      long missed, long falsePoints, long switches, double mota, Correspondences found) {
    assertEquals(missed, found.missed(), "missed");
    assertEquals(falsePoints, found.falsePoints(), "false");
    assertEquals(switches, found.switches(), "switches");
    assertEquals(mota, found.mota(), 1e-12, "MOTA");
  }

  @Test
  void trackBrokenInTwoIsOneSwitch() {
    check(0, 0, 1, 1 - 1.0 / 4, new Correspondences(Rows.brokenTrack(), 5));
  }

  @Test
  void swappedTracksAreTwoSwitches() {
    check(0, 0, 2, 1 - 2.0 / 20, new Correspondences(Rows.swappedTracks(), 5));
  }

  @Test
  void outlierCountsAsMissedAndFalse() {
    check(1, 1, 0, 1 - 2.0 / 4, new Correspondences(Rows.outlierTrack(), 5));
  }

  @Test
  void manyFalseTracksMakeMotaNegative() {
    // 1 − (1 missed + 3 false) / 1 = −3.
    Frames frames =
        Rows.frames(
            new Rows().add(1, 0, 0, 0),
            new Rows().add(1, 0, 0, 20).add(2, 0, 0, 30).add(3, 0, 0, 40));
    check(1, 3, 0, -3, new Correspondences(frames, 5));
  }

  @Test
  void objectKeepsItsTrackWhenAnotherTrackIsNearer() {
    // From frame 2 on track 1 is 3 away, within the gate, and track 2 at the object's own place.
    Frames frames =
        Rows.frames(
            new Rows().add(1, 0, 3, 0), new Rows().add(1, 0, 1, 0).add(1, 2, 3, 3).add(2, 2, 3, 0));
    Correspondences found = new Correspondences(frames, 5);
    check(0, 2, 0, 1 - 2.0 / 4, found);
    // Distances 0, 0, 3, 3.
    assertEquals(1.5, found.motp(), 1e-15);
  }

  @Test
  void reacquisitionUnderAnotherIdentityIsASwitch() {
    // Without a track in frames 2 and 3, then with a new one: 2 missed and 1 switch of 6.
    Frames frames =
        Rows.frames(new Rows().add(1, 0, 5, 0), new Rows().add(1, 0, 1, 0).add(9, 4, 5, 0));
    Correspondences found = new Correspondences(frames, 5);
    check(2, 0, 1, 1 - 3.0 / 6, found);
    assertFalse(found.matches().get(1).switched());
    assertTrue(found.matches().get(2).switched());
    assertFalse(found.matches().get(3).switched());
  }

  @Test
  void reacquisitionUnderTheSameIdentityIsNoSwitch() {
    Frames frames =
        Rows.frames(new Rows().add(1, 0, 5, 0), new Rows().add(1, 0, 1, 0).add(1, 4, 5, 0));
    check(2, 0, 0, 1 - 2.0 / 6, new Correspondences(frames, 5));
  }

  @Test
  void trackAssignedToAnotherObjectStaysThere() {
    // Object 1 is away in frame 1 while its track 1 goes over to object 2, which has been without a
    // track. In frame 2 both are near track 1: object 2 keeps it, and object 1 is missed.
    Frames frames =
        Rows.frames(
            new Rows().add(1, 0, 0, 0).add(2, 0, 0, 50).add(2, 1, 2, 3).add(1, 2, 2, 0),
            new Rows().add(1, 0, 2, 0));
    Correspondences found = new Correspondences(frames, 5);
    check(2, 0, 0, 1 - 2.0 / 5, found);
    assertEquals(2, found.matches().get(2).truth().id());
  }

  @Test
  void matchingMaximizesPairsBeforeMinimizingDistance() {
    Correspondences found = new Correspondences(Rows.chain(), 9.5);
    check(0, 0, 0, 1, found);
    assertEquals(8, found.motp());
    // With a gate of 5 the nearest pair is the only one.
    check(1, 1, 0, 1 - 2.0 / 2, new Correspondences(Rows.chain(), 5));
  }

  @Test
  void gateIncludesItsDistance() {
    Frames frames = Rows.frames(new Rows().add(1, 0, 0, 0), new Rows().add(1, 0, 0, 3));
    assertEquals(1, new Correspondences(frames, 3).matches().size());
    assertEquals(0, new Correspondences(frames, Math.nextDown(3.0)).matches().size());
    for (double gate : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> new Correspondences(frames, gate));
    }
  }

  @Test
  void motaIsUndefinedWithoutTruth() {
    Frames frames = Rows.frames(new Rows(), new Rows().add(1, 0, 0, 3));
    Correspondences found = new Correspondences(frames, 3);
    assertTrue(Double.isNaN(found.mota()));
    assertTrue(Double.isNaN(found.motp()));
    assertEquals(1, found.falsePoints());
  }
}
