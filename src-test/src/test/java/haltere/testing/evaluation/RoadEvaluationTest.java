package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.simulation.internal.road.RoadSceneSettings;
import java.io.IOException;
import org.junit.jupiter.api.Test;

class RoadEvaluationTest {
  @Test
  void medianSpeedErrorOnFreeRoadsIsBelowFifteenPercent() throws IOException {
    RoadEvaluation evaluation = new RoadEvaluation();
    for (int seed = 1; seed <= 2; seed++) {
      evaluation.judge(
          RoadSceneSettings.defaults()
              .with("traffic.pauseS=5", "run.seed=" + seed, "run.durationS=30"));
    }
    assertTrue(evaluation.medianError() < 0.15, evaluation.toString());
    assertTrue(evaluation.foundShare() > 0.5, evaluation.toString());
  }
}
