package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class GospaTest {
  private static void check(
      double localisation, double missed, double falseTracks, Rows truth, Rows tracks) {
    Gospa gospa = Gospa.of(Rows.frames(truth, tracks).list().get(0), 10);
    assertEquals(localisation, gospa.localisation(), 1e-12, "localisation");
    assertEquals(missed, gospa.missed(), 1e-12, "missed");
    assertEquals(falseTracks, gospa.falseTracks(), 1e-12, "false");
    assertEquals(Math.sqrt(localisation + missed + falseTracks), gospa.mean(), 1e-12);
    assertEquals(gospa.mean(), gospa.rms(), 1e-12);
  }

  private static Rows at(double... positions) {
    Rows rows = new Rows();
    for (int i = 0; i < positions.length; i++) {
      rows.add(i, 0, 0, positions[i]);
    }
    return rows;
  }

  @Test
  void localizationMissedAndFalseTermsAddUp() {
    // c = 10: 3² + 10²/2 + 2 · 10²/2 = 159.
    check(9, 50, 100, at(0, 100), at(3, 200, 300));
  }

  @Test
  void pairAtTheCutOffCostsAMissAndAFalseTrack() {
    check(0, 50, 50, at(0), at(10));
    check(0, 50, 50, at(0), at(1000));
    check(81, 0, 0, at(0), at(9));
  }

  @Test
  void assignmentIsGloballyOptimalNotGreedy() {
    // (0, 3) and (5, 12): 9 + 49 = 58. Nearest first: (5, 3) costs 4, but then 50 + 50 for the
    // rest.
    check(58, 0, 0, at(0, 5), at(3, 12));
  }

  @Test
  void optimalAssignmentMayLeaveAPairUnassigned() {
    // (0, 1): 1; the object at 50 and the track at −9: 59 apart. Pairing 0 with −9 as well as 50
    // with
    // nothing would cost 81 + 50 + 50.
    check(1, 50, 50, at(0, 50), at(1, -9));
  }

  @Test
  void gospaIsSymmetricExceptForMissedAndFalse() {
    check(58, 0, 50, at(3, 12), at(0, 5, 400));
    check(58, 50, 0, at(0, 5, 400), at(3, 12));
  }

  @Test
  void gospaOverTimeIsTheMeanOfFrames() {
    // Frame 0: 58, see above. Frame 1: an object without a track, 50.
    Frames frames = Rows.frames(at(0, 5).add(0, 1, 1, 0), at(3, 12));
    Gospa gospa = Gospa.of(frames, 10);
    assertEquals((Math.sqrt(58) + Math.sqrt(50)) / 2, gospa.mean(), 1e-12);
    assertEquals(29, gospa.localisation(), 1e-12);
    assertEquals(25, gospa.missed(), 1e-12);
    assertEquals(0, gospa.falseTracks(), 1e-12);
    assertEquals(Math.sqrt(54), gospa.rms(), 1e-12);
  }

  @Test
  void emptyFrameScoresZeroAndNoFramesAreUndefined() {
    Frames empty = Frames.at(new long[] {0}, at().points(), at().points());
    assertEquals(0, Gospa.of(empty, 10).mean());
    assertTrue(Double.isNaN(Gospa.of(Rows.frames(at(), at()), 10).mean()));
    for (double cutOff : new double[] {0, Double.NaN, Double.POSITIVE_INFINITY}) {
      assertThrows(IllegalArgumentException.class, () -> Gospa.of(empty, cutOff));
    }
  }
}
