package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

/** A sample of what {@code ./gradlew :src-test:evaluateClusters} measures on many scenes. */
class ClusterTrackingTest {
  @Test
  void clustersAloneKeepTheIdentitiesOfDiscsThatMeet() {
    TrackingScores scores = TrackingScores.of(1, 10, ClusterRows::of);
    assertTrue(scores.hota() > 0.95, scores::toString);
    assertTrue(scores.idf1() > 0.96, scores::toString);
    assertTrue(scores.keptShare() >= 0.95, scores::toString);
    assertTrue(scores.accuracy().positionRmse() < 0.9, scores::toString);
  }

  @Test
  void theSameSeedMakesTheSameScene() {
    assertEquals(TrackingScene.of(7), TrackingScene.of(7));
  }
}
