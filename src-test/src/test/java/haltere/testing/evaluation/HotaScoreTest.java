package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class HotaScoreTest {
  private static final double D0 = 10;

  private static void check(double detA, double assA, double hota, Frames frames) {
    HotaScore score = HotaScore.of(frames, D0);
    assertEquals(19, score.thresholds().size());
    assertEquals(detA, score.detA(), 1e-12, "DetA");
    assertEquals(assA, score.assA(), 1e-12, "AssA");
    assertEquals(hota, score.hota(), 1e-12, "HOTA");
  }

  @Test
  void thresholdsMatchThePaper() {
    HotaScore score = HotaScore.of(Rows.brokenTrack(), D0);
    assertEquals(0.05, score.thresholds().get(0).alpha());
    assertEquals(0.5, score.thresholds().get(9).alpha());
    assertEquals(0.95, score.thresholds().get(18).alpha());
  }

  @Test
  void tracksEqualToTheTruthScoreOne() {
    Rows truth = new Rows().add(1, 0, 9, 0).add(2, 3, 5, 4);
    check(1, 1, 1, Rows.frames(truth, truth));
  }

  @Test
  void trackBrokenInTwoHasAnAssociationScoreOfOneHalf() {
    // All 4 points are pairs: DetA = 1. Each: TPA = 2, FNA = 4 − 2, FPA = 2 − 2, so A = 2/4.
    check(1, 0.5, Math.sqrt(0.5), Rows.brokenTrack());
  }

  @Test
  void swappedTracksScoreAsComputedByHand() {
    // DetA = 1. 12 pairs of identity: TPA = 6, FNA = FPA = 4, A = 6/14. 8 swapped: TPA = 4,
    // FNA = FPA = 6, A = 4/16. AssA = (12 · 6/14 + 8 · 4/16) / 20 = 5/14.
    check(1, 5.0 / 14, Math.sqrt(5.0 / 14), Rows.swappedTracks());
  }

  @Test
  void outlierLowersDetectionAndAssociationScores() {
    // TP = 3, FN = 1, FP = 1: DetA = 3/5. TPA = 3, FNA = 1, FPA = 1: A = 3/5. HOTA = 3/5.
    check(0.6, 0.6, 0.6, Rows.outlierTrack());
  }

  @Test
  void offsetOfThreeTenthsMatchesUpToAlphaOfSevenTenths() {
    // S = 1 − 3/10 = 0.7: a perfect score at 0.05 … 0.70, 14 of 19, and 0 above.
    Frames frames = Rows.frames(new Rows().add(1, 0, 4, 20), new Rows().add(1, 0, 4, 23));
    check(14.0 / 19, 14.0 / 19, 14.0 / 19, frames);
    HotaScore score = HotaScore.of(frames, D0);
    assertEquals(0.7, score.thresholds().get(13).locA(), 1e-12);
    assertEquals(5, score.thresholds().get(13).pairs());
    assertEquals(5, score.thresholds().get(14).missed());
    assertEquals(5, score.thresholds().get(14).falsePoints());
  }

  @Test
  void identitiesDecideWhenTracksAreNearBothObjects() {
    // In one frame of four the objects are at 0 and 1, their tracks at 0.6 and 0.4. With S = 0.94
    // of
    // the right pairs the score is 1 up to α = 0.90. At 0.95 only the wrong pairs are left, S =
    // 0.96:
    // DetA = 1, 6 pairs with A = 3/(4 + 4 − 3), 2 with A = 1/(4 + 4 − 1), AssA = 17/35.
    Rows apart = new Rows().add(1, 0, 2, 0).add(2, 0, 2, 100);
    Rows truth = apart.with(new Rows().add(1, 3, 3, 0).add(2, 3, 3, 1));
    Rows tracks = apart.with(new Rows().add(1, 3, 3, 0.6).add(2, 3, 3, 0.4));
    double last = 17.0 / 35;
    check(1, (18 + last) / 19, (18 + Math.sqrt(last)) / 19, Rows.frames(truth, tracks));
  }

  @Test
  void matchingMaximizesThePairs() {
    // S of (0, 8) and (12, 20) is 0.2, of (12, 8) 0.6. α ≤ 0.2 (4 of them): both pairs, all 1.
    // 0.25 to 0.60 (8): one pair, DetA = 1/3, AssA = 1. Above (7): none.
    check((4 + 8.0 / 3) / 19, (4 + 8.0) / 19, (4 + 8 * Math.sqrt(1.0 / 3)) / 19, Rows.chain());
  }

  @Test
  void scoreIsZeroWithoutTracksOrTruthAndUndefinedWithoutBoth() {
    Rows one = new Rows().add(1, 0, 3, 0);
    check(0, 0, 0, Rows.frames(one, new Rows()));
    check(0, 0, 0, Rows.frames(new Rows(), one));
    assertTrue(Double.isNaN(HotaScore.of(Rows.frames(new Rows(), new Rows()), D0).hota()));
  }

  @Test
  void invalidDistanceIsRejected() {
    Frames frames = Rows.brokenTrack();
    for (double d0 : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> HotaScore.of(frames, d0));
    }
  }
}
