package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** A small sample of the evaluation whose figures are in docs/tracking.md. */
class TrackEvaluationTest {
  @Test
  void tracksOfAFewScenesAreWhereTheDiscsAreAndKeepTheirIdentities() {
    TrackingScores scores = TrackingScores.of(3, 6, TrackEvaluation::tracks);
    assertTrue(scores.hota() > 0.95, scores.toString());
    assertTrue(scores.idf1() > 0.96, scores.toString());
    assertTrue(scores.keptShare() > 0.9, scores.toString());
    assertTrue(scores.accuracy().positionRmse() < 0.9, scores.toString());
    assertTrue(scores.accuracy().relativeVelocityRmse() < 0.15, scores.toString());
  }
}
