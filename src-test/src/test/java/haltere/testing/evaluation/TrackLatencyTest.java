package haltere.testing.evaluation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

class TrackLatencyTest {
  /** Object 1 from 1 ms on, with a track from 4 ms on; object 2 at once; object 3 never. */
  private static final Frames FRAMES =
      Rows.frames(
          new Rows().add(1, 1, 9, 0).add(2, 2, 9, 50).add(3, 0, 9, 100),
          new Rows().add(7, 4, 9, 1).add(8, 2, 5, 50).add(9, 6, 9, 50));

  private static final Correspondences FOUND = new Correspondences(FRAMES, 5);

  @Test
  void latenciesCountFromTheFirstRowOfTheTruth() {
    TrackLatency latency = TrackLatency.of(FRAMES, FOUND);
    assertEquals(List.of(0L, 3000L), latency.latenciesUs());
    assertEquals(1, latency.never());
    assertEquals(1500, latency.meanUs());
    // Of 0, 3000 and never the middle one.
    assertEquals(3000, latency.medianUs());
    assertEquals(Double.POSITIVE_INFINITY, latency.greatestUs());
  }

  @Test
  void latenciesCountFromAKnownFirstEvent() {
    TrackLatency latency = TrackLatency.of(FRAMES, FOUND, Map.of(1, 1600L, 2, 1250L));
    assertEquals(List.of(750L, 2400L), latency.latenciesUs());
  }

  @Test
  void medianOfAnEvenCountIsTheMidpoint() {
    assertEquals(15, new TrackLatency(List.of(30L, 10L, 20L, 0L), 0).medianUs());
    assertEquals(30, new TrackLatency(List.of(30L, 10L, 20L, 0L), 0).greatestUs());
    assertEquals(Double.POSITIVE_INFINITY, new TrackLatency(List.of(1L), 1).medianUs());
  }

  @Test
  void latencyIsUndefinedWithoutObjects() {
    TrackLatency latency = new TrackLatency(List.of(), 0);
    assertTrue(Double.isNaN(latency.meanUs()));
    assertTrue(Double.isNaN(latency.medianUs()));
    assertTrue(Double.isNaN(latency.greatestUs()));
  }
}
