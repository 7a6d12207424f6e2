package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;

class AccuracyTest {
  private static final long SETTLED_US = 300_000;

  private static Accuracy of(List<ObjectPoint> truth, List<ObjectPoint> tracks) {
    Frames frames = Frames.of(truth, tracks);
    return Accuracy.of(frames, new Correspondences(frames, 20), SETTLED_US);
  }

  @Test
  void positionErrorIsTheRootMeanSquareDistance() {
    // Distances 5 (3, 4) and 1: √((25 + 1) / 2). The third object has no track.
    Accuracy accuracy =
        of(
            List.of(
                new ObjectPoint(0, 1, 10, 10),
                new ObjectPoint(5, 1, 10, 10),
                new ObjectPoint(5, 2, 500, 500)),
            List.of(new ObjectPoint(0, 1, 13, 14), new ObjectPoint(5, 1, 10, 9)));
    assertEquals(2, accuracy.pairs());
    assertEquals(Math.sqrt(13), accuracy.positionRmse(), 1e-12);
    assertEquals(0, accuracy.velocityPairs());
    assertTrue(Double.isNaN(accuracy.velocityRmse()));
    assertTrue(Double.isNaN(accuracy.speedBias()));
  }

  @Test
  void velocityErrorExcludesTheSettlingTimeOfATrack() {
    // At 299,999 us the track is too young, whatever its velocity. Then errors of 0.3 and 0.4 at
    // speeds of 10 and 20: √((0.09 + 0.16) / 2) and √(0.25 / 500).
    Accuracy accuracy =
        of(
            List.of(
                new ObjectPoint(1000, 1, 0, 0, 10, 0),
                new ObjectPoint(300_999, 1, 3, 0, 10, 0),
                new ObjectPoint(301_000, 1, 3, 0, 10, 0),
                new ObjectPoint(400_000, 1, 4, 0, 0, 20)),
            List.of(
                new ObjectPoint(1000, 8, 0, 0, 0, 0),
                new ObjectPoint(300_999, 8, 3, 0, -99, 7),
                new ObjectPoint(301_000, 8, 3, 0, 10.3, 0),
                new ObjectPoint(400_000, 8, 4, 0, 0, 19.6)));
    assertEquals(4, accuracy.pairs());
    assertEquals(2, accuracy.velocityPairs());
    assertEquals(Math.sqrt(0.125), accuracy.velocityRmse(), 1e-12);
    assertEquals(Math.sqrt(0.25 / 500), accuracy.relativeVelocityRmse(), 1e-12);
    // Ratios 1.03 and 0.98: mean 1.005, deviation 0.025.
    assertEquals(0.005, accuracy.speedBias(), 1e-12);
    assertEquals(0.025, accuracy.speedDeviation(), 1e-12);
  }

  @Test
  void stationaryObjectHasAVelocityErrorButNoSpeedRatio() {
    Accuracy accuracy =
        of(
            List.of(new ObjectPoint(0, 1, 0, 0, 0, 0), new ObjectPoint(SETTLED_US, 1, 0, 0, 0, 0)),
            List.of(new ObjectPoint(0, 1, 0, 0, 0, 0), new ObjectPoint(SETTLED_US, 1, 0, 0, 3, 4)));
    assertEquals(5, accuracy.velocityRmse(), 1e-12);
    assertTrue(Double.isNaN(accuracy.speedBias()));
    assertTrue(Double.isNaN(accuracy.speedDeviation()));
  }
}
