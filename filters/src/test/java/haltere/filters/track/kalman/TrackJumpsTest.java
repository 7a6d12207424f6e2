package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackUpdate;
import haltere.filters.track.kalman.GivenClusters.Given;
import haltere.filters.track.motion.MotionModes;
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
              last = track.lastUpdate(measurement.timeUs, accepted);
            }

            @Override
            public void ended(int id) {
              // looked at directly
            }
          });
  private long timeUs;
  private TrackUpdate last;

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
  void whatIsSaidOfARefusedMeasurementIsWhereTheTrackWasExpectedAtItsTime() {
    Given cluster = clusters.add(5);
    step(40, cluster, 20, 100, 120);
    step(2, cluster, 20, 120, 120);
    assertFalse(last.accepted());
    assertEquals(timeUs - STEP_US / 2, last.timeUs());
    assertEquals(20 + 120e-6 * last.timeUs(), last.x(), 0.3);
    assertEquals(100, last.y(), 0.3);
    assertEquals(last.measuredX() - last.innovationX(), last.x(), 1e-9);
    assertEquals(last.measuredY() - last.innovationY(), last.y(), 1e-9);
  }

  /** A round thing on its way, into whose cluster another one has run that enters behind it. */
  private Given runInto() {
    Given cluster = clusters.add(5);
    cluster.outline = 100;
    step(40, cluster, 20, 100, 120);
    cluster.variance = 10;
    return cluster;
  }

  @Test
  void aTrackWhoseClusterIsMuchLargerAtOnceGoesOnAsItWas() {
    step(10, runInto(), 20, 105, 120);
    assertEquals(20 + 120e-6 * timeUs, only().x(), 1);
    assertEquals(100, only().y(), 1);
  }

  @Test
  void whatStaysSoLargeHasBecomeSo() {
    step(60, runInto(), 20, 105, 120);
    assertEquals(105, only().y(), 0.5);
  }

  @Test
  void whenThatClusterPartsTheTrackGoesOnWithTheOneThatIsWhereItIsExpected() {
    Given cluster = runInto();
    step(10, cluster, 20, 105, 120);
    cluster.variance = 4;
    estimator.clusterParted(timeUs, 5);
    step(1, cluster, 20, 100, 120);
    assertEquals(100, only().y(), 0.3);
    assertEquals(120, only().vx(), 5);
  }

  @Test
  void whatComesInWhereATrackWentOutIsAnotherThing() {
    Given cluster = clusters.add(5);
    cluster.outline = 100;
    step(60, cluster, 120, 100, 120);
    int gone = estimator.shown(0, timeUs).id;
    cluster.variance = 10;
    step(10, cluster, 192, 100, 0);
    cluster.variance = 4;
    double backwards = 190 + 120e-6 * timeUs;
    step(20, cluster, backwards, 100, -120);
    assertEquals(1, estimator.trackCount());
    assertEquals(gone + 1, estimator.shown(0, timeUs).id);
    assertEquals(backwards - 120e-6 * timeUs, only().x(), 1);
    assertEquals(-120, only().vx(), 10);
  }

  @Test
  void aTrackOfTwoRingsTakenForOneIsUnsure() {
    Given clear = clusters.add(5);
    clear.outline = 100;
    step(40, clear, 20, 100, 120);
    double sure = only().covariance(0, 0);
    clear.misfit = 2;
    step(20, clear, 20, 100, 120);
    assertTrue(only().covariance(0, 0) > 5 * sure, "variance " + only().covariance(0, 0));
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
