package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class IdentityScoreTest {
  @Test
  void trackBrokenInTwoScoresOneHalf() {
    // The object takes one of the halves: IDTP = 2, IDFP = 2, IDFN = 2; 4 / (4 + 2 + 2).
    IdentityScore score = IdentityScore.of(Rows.brokenTrack(), 1);
    assertEquals(new IdentityScore(2, 2, 2), score);
    assertEquals(0.5, score.idf1());
  }

  @Test
  void swappedTracksScoreTheirLongerSegment() {
    // 6 of 10 points each: IDTP = 12, IDFP = IDFN = 8; 24 / (24 + 8 + 8).
    IdentityScore score = IdentityScore.of(Rows.swappedTracks(), 1);
    assertEquals(new IdentityScore(12, 8, 8), score);
    assertEquals(0.6, score.idf1(), 1e-15);
  }

  @Test
  void trajectoryMatchingIsGloballyOptimalNotGreedy() {
    // Common points: object 1 with track 1: 5, with track 2: 4; object 2 with track 1: 4. The
    // longest
    // first gives 5, all together 4 + 4 = 8 of 13 points on either side; 16 / (16 + 5 + 5).
    IdentityScore score =
        IdentityScore.of(
            Rows.frames(
                new Rows().add(1, 0, 8, 0).add(2, 10, 13, 0),
                new Rows().add(1, 0, 4, 0).add(2, 5, 8, 0).add(1, 10, 13, 0)),
            1);
    assertEquals(new IdentityScore(8, 5, 5), score);
    assertEquals(8.0 / 13, score.idf1(), 1e-15);
  }

  @Test
  void precisionAndRecallAreSharesOfTrackAndTruthPoints() {
    // 10 points of truth, a track on 4 of them, a false track of 2 points.
    IdentityScore score =
        IdentityScore.of(
            Rows.frames(new Rows().add(1, 0, 9, 0), new Rows().add(1, 2, 5, 0).add(2, 2, 3, 50)),
            1);
    assertEquals(4.0 / 6, score.precision(), 1e-15);
    assertEquals(4.0 / 10, score.recall(), 1e-15);
    // Harmonic mean of 2/3 and 2/5.
    assertEquals(0.5, score.idf1(), 1e-15);
  }

  @Test
  void gateIncludesItsDistance() {
    Frames frames = Rows.frames(new Rows().add(1, 0, 0, 0), new Rows().add(1, 0, 0, 3));
    assertEquals(1, IdentityScore.of(frames, 3).idf1());
    assertEquals(0, IdentityScore.of(frames, Math.nextDown(3.0)).idf1());
    for (double gate : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> IdentityScore.of(frames, gate));
    }
  }

  @Test
  void scoreIsZeroWithoutTracksAndUndefinedWithoutPoints() {
    Rows one = new Rows().add(1, 0, 3, 0);
    assertEquals(0, IdentityScore.of(Rows.frames(one, new Rows()), 1).idf1());
    assertTrue(Double.isNaN(IdentityScore.of(Rows.frames(new Rows(), new Rows()), 1).idf1()));
  }
}
