package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.estimation.Interval;
import org.junit.jupiter.api.Test;

/** A small sample of the evaluation whose figures are in docs/tracking-figures.md. */
class TrackEvaluationTest {
  @Test
  void tracksOfAFewScenesAreWhereTheDiscsAreAndKeepTheirIdentities() {
    TrackConsistency consistency = new TrackConsistency();
    TrackingScores scores =
        TrackingScores.of(3, 6, scene -> TrackEvaluation.tracks(scene, consistency));
    assertTrue(scores.hota() > 0.95, scores.toString());
    assertTrue(scores.idf1() > 0.96, scores.toString());
    assertTrue(scores.keptShare() > 0.9, scores.toString());
    assertTrue(scores.accuracy().positionRmse() < 0.9, scores.toString());
    assertTrue(scores.accuracy().relativeVelocityRmse() < 0.15, scores.toString());
    // 95 % are expected; six scenes have few tracks.
    assertEquals(0.95, consistency.nisInside(), 0.03, consistency.toString());
    assertEquals(0.95, consistency.neesInside(), 0.04, consistency.toString());
    assertEquals(2, consistency.meanNis(), 0.4, consistency.toString());
    assertIn(consistency.nisBand(), consistency.meanNis(), consistency);
    assertIn(consistency.neesBand(), consistency.meanNees(), consistency);
  }

  private static void assertIn(Interval band, double mean, TrackConsistency consistency) {
    assertTrue(band.lower() < mean && mean < band.upper(), consistency.toString());
  }
}
