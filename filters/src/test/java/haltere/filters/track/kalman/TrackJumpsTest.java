package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.kalman.GivenClusters.Given;
import org.junit.jupiter.api.Test;

/** Clusters that are elsewhere at once, for a reason that the cluster tracker knows. */
class TrackJumpsTest {
  private static final long STEP_US = 10_000;

  private final GivenClusters clusters = new GivenClusters();
  private final TrackEstimator estimator =
      new TrackEstimator(
          new SensorGeometry(200, 200),
          KalmanTracksSettings.defaults(),
          new TrackListener() {
            @Override
            public void reported(long reportUs) {
              // looked at directly
            }

            @Override
            public void updated(Track track, Measurement measurement, boolean accepted) {
              // looked at directly
            }

            @Override
            public void ended(int id) {
              // looked at directly
            }
          });
  private long timeUs;

  /** A cluster at a place at a time, going to the right; its mean is half a step old. */
  private void step(int steps, Given cluster, double atX, double atY, double vx) {
    for (int k = 0; k < steps; k++) {
      timeUs += STEP_US;
      cluster.at(atX + vx * (timeUs - STEP_US / 2) * 1e-6, atY);
      estimator.clustersRead(timeUs, clusters);
    }
  }

  private MotionModes only() {
    assertEquals(1, estimator.trackCount());
    return estimator.shown(0, timeUs).at(timeUs);
  }

  @Test
  void aTrackWhoseClusterWasOfTwoThingsGoesOnWithAboutItsVelocity() {
    Given cluster = clusters.add(5);
    step(40, cluster, 20, 100, 120);
    estimator.clusterParted(timeUs, 5);
    step(1, cluster, 20, 108, 120);
    assertEquals(108, only().y(), 1);
    assertEquals(0, only().vy(), 20);
    step(9, cluster, 20, 108, 120);
    assertEquals(0, only().vy(), 20);
    assertEquals(120, only().vx(), 20);
  }

  @Test
  void aTrackWhoseClusterFallsSilentTakesTheOneThatAppearsWhereItIsExpected() {
    Given silent = clusters.add(5);
    step(40, silent, 20, 100, 120);
    int id = estimator.shown(0, timeUs).id;
    silent.newEvents = 0;
    step(6, silent, 20, 100, 120);
    Given other = clusters.add(6);
    step(3, other, 20, 100, 120);
    assertEquals(1, estimator.trackCount());
    assertEquals(id, estimator.shown(0, timeUs).id);
    assertEquals(6, estimator.shown(0, timeUs).batch.clusterId);
  }

  @Test
  void theRestOfWhatHasLeftIsNoNewThingUntilItHasHadTimeToGo() {
    step(24, clusters.add(1), 150, 100, 200);
    clusters.list.clear();
    Given rest = clusters.add(2);
    step(9, rest, 196, 100, 0);
    assertEquals(0, estimator.trackCount());
    step(3, rest, 196, 100, 0);
    assertEquals(1, estimator.trackCount());
  }

  @Test
  void whatComesInElsewhereIsANewThing() {
    step(24, clusters.add(1), 150, 100, 200);
    clusters.list.clear();
    step(2, clusters.add(2), 196, 150, 0);
    assertEquals(1, estimator.trackCount());
    estimator.reset();
    clusters.list.clear();
    step(2, clusters.add(3), 196, 150, 0);
    assertEquals(1, estimator.trackCount());
  }

  @Test
  void twoThatHaveJustPartedAreContestedForAMomentMore() {
    Given first = clusters.add(1);
    Given second = clusters.add(2);
    double reach = 2 * 2.5 * Math.sqrt(first.variance);
    int lasting = 0;
    boolean met = false;
    for (double way = -60; way < 60; way++) {
      // At 50 px/s each, in opposite directions.
      timeUs += STEP_US;
      first.at(100 + way / 2, 100);
      second.at(100 - way / 2, 102);
      first.ageUs = 0;
      second.ageUs = 0;
      estimator.clustersRead(timeUs, clusters);
      Track track = estimator.shown(0, timeUs);
      met |= way == 0 && track.contested;
      lasting += way > reach && track.contested ? 1 : 0;
    }
    assertTrue(met);
    assertTrue(lasting >= 3 && lasting <= 6, lasting + " steps");
  }
}
