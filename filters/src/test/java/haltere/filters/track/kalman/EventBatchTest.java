package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.filters.track.kalman.GivenClusters.Given;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Readings of a cluster that are put together because each has too few events. */
class EventBatchTest {
  private static final long STEP_US = 10_000;

  private final GivenClusters clusters = new GivenClusters();
  private final Given cluster = clusters.add(1);
  private final EventBatch batch = new EventBatch();
  private long timeUs;

  /** Where the thing is: it goes to the right and downwards. */
  private static double x(double atUs) {
    return 50 + 200e-6 * atUs;
  }

  private static double y(double atUs) {
    return 120 - 300e-6 * atUs;
  }

  private void begin() {
    cluster.vx = 200;
    cluster.vy = -300;
    batch.begin(1, timeUs);
  }

  private void read(double events, double ageUs, double information, double upright) {
    timeUs += STEP_US;
    cluster.newEvents = events;
    cluster.ageUs = ageUs;
    cluster.outline = information;
    cluster.outlineUpright = upright;
    cluster.at(x(timeUs - ageUs), y(timeUs - ageUs));
    batch.add(timeUs, clusters, 0);
  }

  @Test
  void readingsThatKnowDifferentDirectionsOfAThingOnItsWayAgreeOnItsPlaceAtOneTime() {
    begin();
    read(3, 5000, 100, 0.01);
    read(3, 5000, 1, 100);
    assertTrue(batch.hasOutline());
    assertEquals(STEP_US, batch.meanTimeUs());
    assertEquals(x(STEP_US), batch.outlineCentreX(), 1e-9);
    assertEquals(y(STEP_US), batch.outlineCentreY(), 1e-9);
  }

  @Test
  void howeverManyReadingsThereAreTheOutlineIsWhereTheThingIsAtTheMeanTimeOfTheEvents() {
    SplittableRandom random = new SplittableRandom(5);
    for (int run = 0; run < 100; run++) {
      begin();
      int readings = random.nextInt(1, 6);
      for (int k = 0; k < readings; k++) {
        read(random.nextInt(1, 6), random.nextInt(9000), random.nextDouble(50), 4);
      }
      assertEquals(x(batch.meanTimeUs()), batch.outlineCentreX(), 3e-4);
      assertEquals(y(batch.meanTimeUs()), batch.outlineCentreY(), 3e-4);
      assertEquals(x(batch.meanTimeUs()), batch.meanX(), 3e-4);
      assertEquals(y(batch.meanTimeUs()), batch.meanY(), 3e-4);
    }
  }
}
