package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.kalman.GivenClusters.Given;
import haltere.filters.track.motion.MotionModes;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class TrackPartsTest {
  private static final long STEP_US = 10_000;

  private final GivenClusters clusters = new GivenClusters();
  private TrackEstimator estimator = estimator(KalmanTracksSettings.defaults());
  private long timeUs;

  private static TrackEstimator estimator(KalmanTracksSettings settings) {
    return new TrackEstimator(
        new SensorGeometry(300, 200),
        settings,
        new TrackListener() {
          @Override
          public void reported(long reportUs) {
            // Each test asks for what is shown.
          }

          @Override
          public void updated(Track track, Measurement measurement, boolean accepted) {
            // The tests are about identities.
          }

          @Override
          public void ended(int id) {
            // The tests look at those that are there.
          }
        });
  }

  /** Moves all clusters for some steps, each at its velocity to the right. */
  private void step(int steps, double... velocities) {
    for (int k = 0; k < steps; k++) {
      timeUs += STEP_US;
      for (int i = 0; i < clusters.list.size(); i++) {
        Given cluster = clusters.list.get(i);
        cluster.at(cluster.x + velocities[i] * 1e-6 * STEP_US, cluster.y);
      }
      estimator.clustersRead(timeUs, clusters);
    }
  }

  private List<Integer> shown() {
    List<Integer> ids = new ArrayList<>();
    for (int i = 0; i < estimator.trackCount(); i++) {
      Track track = estimator.shown(i, timeUs);
      if (track != null) {
        ids.add(track.id);
      }
    }
    return ids;
  }

  private double columnOf(int id) {
    for (int i = 0; i < estimator.trackCount(); i++) {
      if (estimator.shown(i, timeUs) != null && estimator.shown(i, timeUs).id == id) {
        return estimator.shown(i, timeUs).at(timeUs).x();
      }
    }
    throw new AssertionError("no track " + id);
  }

  @Test
  void whatBeginsBesideATrackIsAPartOfItsThingWhichIsShownOnce() {
    clusters.add(1).at(40, 100);
    step(5, 60);
    clusters.add(2).at(65, 100);
    step(60, 60, 60);
    assertEquals(List.of(1), shown());
  }

  @Test
  void whenTheClusterOfTheTrackThatIsShownEndsAPartGoesOnWithItsIdentity() {
    clusters.add(1).at(40, 100);
    step(5, 60);
    Given part = clusters.add(2).at(65, 100);
    step(30, 60, 60);
    clusters.list.remove(0);
    step(10, 60);
    assertEquals(List.of(1), shown());
    assertEquals(part.x, columnOf(1), 1);
  }

  @Test
  void aPartThatGoesItsOwnWayGetsAnIdentityOfItsOwn() {
    clusters.add(1).at(40, 100);
    step(5, 60);
    clusters.add(2).at(65, 100);
    step(10, 60, 60);
    step(100, 60, 150);
    assertEquals(List.of(1, 2), shown());
  }

  @Test
  void aPartThatMovesWithItsThingIsItThoughNothingConnectsThem() {
    clusters.add(1).at(20, 100);
    step(5, 60);
    clusters.add(2).at(45, 100);
    step(250, 60, 75);
    assertEquals(List.of(1), shown());
  }

  @Test
  void anEdgeThatAppearsWhereAnotherMovesIsOfItsThingIfItMovesWithIt() {
    edgesAt(40, 100);
    step(100, 60, 60);
    assertEquals(List.of(1), shown());
  }

  @Test
  void anEdgeThatAppearsWhereAnotherMovesIsItselfIfItMovesOtherwise() {
    edgesAt(100, 60);
    step(30, 60, -60);
    assertEquals(List.of(1, 2), shown());
  }

  @Test
  void whatAppearsWhereAThingWasLostIsNoEdgeOfAnotherThatIsFartherAway() {
    Given edge = clusters.add(1).at(40, 100);
    edge.upright = 8;
    clusters.add(2).at(120, 100);
    step(60, 30, -6);
    Given lost = clusters.list.remove(1);
    step(20, 30);
    // Too far from where that was lost to be held for it, and about as far from the edge as others
    // that are taken for parts of its thing.
    clusters.add(3).at(lost.x + 10, 124);
    step(2, 30, 0);
    assertEquals(2, shown().size(), "shown " + shown());
    assertTrue(shown().contains(3), "shown " + shown());
  }

  @Test
  void ofHowAnEdgeMovesAlongItselfNothingIsKnown() {
    edgesAt(40, 100);
    Given across = clusters.list.get(1);
    across.variance = 48;
    across.upright = 1 / 12.0;
    step(100, 60, 90);
    assertEquals(List.of(1), shown());
  }

  /** Two upright edges of which the second appears while the first moves. */
  private void edgesAt(double firstX, double secondX) {
    clusters.add(1).at(firstX, 100).upright = 12;
    step(20, 60);
    clusters.add(2).at(secondX, 100).upright = 12;
  }

  @Test
  void cornersAreNotRoundThings() {
    clusters.add(1).at(40, 100);
    clusters.add(2).at(65, 100);
    for (Given corner : clusters.list) {
      corner.outline = 100;
      corner.outlineAheadX = 2;
    }
    step(100, 40, 40);
    assertEquals(List.of(1), shown());
  }

  @Test
  void twoThatWereSeenByThemselvesAreOneOnlyAfterTheyHaveBeenInTouchForLong() {
    clusters.add(1).at(20, 100);
    clusters.add(2).at(90, 100);
    step(75, 90, 30);
    step(50, 40, 40);
    assertEquals(List.of(1, 2), shown());
    step(80, 40, 40);
    assertEquals(List.of(1), shown());
  }

  @Test
  void roundThingsStayThemselvesHoweverNearTheyAre() {
    clusters.add(1).at(40, 100);
    clusters.add(2).at(65, 100);
    clusters.list.forEach(cluster -> cluster.outline = 100);
    step(150, 40, 40);
    assertEquals(List.of(1, 2), shown());
  }

  @Test
  void withoutPartsEachClusterHasATrack() {
    estimator = estimator(KalmanTracksSettings.defaults().with("things.together=false"));
    clusters.add(1).at(40, 100);
    clusters.add(2).at(65, 100);
    step(60, 60, 60);
    assertEquals(List.of(1, 2), shown());
  }

  @Test
  void aPlaceThatNeverMovesIsShownNoLongerNorWhatBeginsThereAgain() {
    clusters.add(1).at(100, 100);
    step(80, 0);
    assertEquals(List.of(1), shown());
    step(40, 0);
    assertTrue(shown().isEmpty());
    clusters.list.clear();
    step(300);
    clusters.add(2).at(101, 101);
    step(20, 0);
    assertTrue(shown().isEmpty());
    step(50, 80);
    assertEquals(1, shown().size());
  }

  @Test
  void aPlaceThatNeverMovesIsShownIfThatIsAskedFor() {
    estimator = estimator(KalmanTracksSettings.defaults().with("things.standing=true"));
    clusters.add(1).at(100, 100);
    step(150, 0);
    assertEquals(List.of(1), shown());
  }

  @Test
  void whatStandsAfterItHasMovedIsShown() {
    clusters.add(1).at(100, 100);
    step(20, 50);
    step(150, 0);
    assertEquals(List.of(1), shown());
  }

  @Test
  void whatStopsAtOnceIsTheSameWhenItGoesOn() {
    Given cluster = clusters.add(1).at(50, 100);
    step(30, 200);
    clusters.list.clear();
    step(120);
    clusters.add(2).at(cluster.x, 100);
    step(10, 200);
    assertEquals(List.of(1), shown());
  }

  @Test
  void alongALineNothingIsKnownOfThePlaceAndAcrossItMuch() {
    Given edge = clusters.add(1).at(50, 100);
    edge.lineY = 1;
    step(60, 60);
    Track track = null;
    for (int i = 0; i < estimator.trackCount(); i++) {
      track = estimator.shown(i, timeUs);
    }
    MotionModes now = track.at(timeUs);
    assertEquals(60, now.vx(), 2);
    assertTrue(now.covariance(1, 1) > 4 * now.covariance(0, 0));
  }
}
