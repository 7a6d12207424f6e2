package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.kalman.GivenClusters.Given;
import haltere.filters.track.motion.MotionModes;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

class TrackEstimatorTest {
  private static final long STEP_US = 10_000;
  private static final SensorGeometry SENSOR = new SensorGeometry(200, 200);

  private final GivenClusters clusters = new GivenClusters();
  private final List<Integer> ended = new ArrayList<>();
  private final List<Long> reportsUs = new ArrayList<>();
  private TrackEstimator estimator =
      estimator(KalmanTracksSettings.defaults().with("life.updatesTillShown=3"));
  private long timeUs;

  private TrackEstimator estimator(KalmanTracksSettings settings) {
    return new TrackEstimator(
        SENSOR,
        settings,
        new TrackListener() {
          @Override
          public void reported(long reportUs) {
            reportsUs.add(reportUs);
          }

          @Override
          public void updated(Track track, Measurement measurement, boolean accepted) {
            assertTrue(track.motion.covariance(0, 0) > 0);
          }

          @Override
          public void ended(int id) {
            ended.add(id);
          }
        });
  }

  /** Moves the clusters for some steps; a cluster's mean is half a step old. */
  private void step(int steps, Moving... moving) {
    for (int k = 0; k < steps; k++) {
      timeUs += STEP_US;
      for (Moving m : moving) {
        double seconds = (timeUs - STEP_US / 2) * 1e-6;
        m.cluster.at(m.x(seconds), m.y(seconds));
      }
      estimator.clustersRead(timeUs, clusters);
    }
  }

  /** A cluster that goes straight on, at a place at time 0. */
  private record Moving(Given cluster, double x0, double y0, double vx, double vy) {
    double x(double seconds) {
      return x0 + vx * seconds;
    }

    double y(double seconds) {
      return y0 + vy * seconds;
    }

    Moving as(Given other) {
      return new Moving(other, x0, y0, vx, vy);
    }
  }

  private Track only() {
    Track found = null;
    for (int i = 0; i < estimator.trackCount(); i++) {
      Track track = estimator.shown(i, timeUs);
      if (track != null) {
        assertNull(found, "more than one track is shown");
        found = track;
      }
    }
    return found;
  }

  private Track near(double x, double y) {
    for (int i = 0; i < estimator.trackCount(); i++) {
      Track track = estimator.shown(i, timeUs);
      if (track != null && Math.hypot(track.at(timeUs).x() - x, track.at(timeUs).y() - y) < 3) {
        return track;
      }
    }
    throw new AssertionError("no track near " + x + ", " + y);
  }

  @Test
  void aClusterBecomesATrackAfterSomeUpdatesAndIsFollowedWithoutLag() {
    Moving moving = new Moving(clusters.add(5), 20, 30, 120, -10);
    step(2, moving);
    assertNull(only());
    step(48, moving);
    Track track = only();
    MotionModes now = track.at(timeUs);
    double seconds = timeUs * 1e-6;
    assertEquals(moving.x(seconds), now.x(), 0.1);
    assertEquals(moving.y(seconds), now.y(), 0.1);
    assertEquals(120, now.vx(), 1);
    assertEquals(-10, now.vy(), 1);
    assertEquals(1, track.id);
    assertTrue(reportsUs.contains(timeUs) && reportsUs.get(0) >= 3 * STEP_US);
  }

  @Test
  void whereTheOutlineIsKnownItsMiddleCountsAndNotTheMeanOfItsEvents() {
    Moving moving = new Moving(clusters.add(5), 20, 30, 120, 0);
    clusters.list.get(0).outline = 100;
    clusters.list.get(0).outlineAheadX = 3;
    step(50, moving);
    assertEquals(moving.x(timeUs * 1e-6) + 3, only().at(timeUs).x(), 0.1);
    estimator = estimator(KalmanTracksSettings.defaults().with("measurement.source=events"));
    step(50, moving);
    assertEquals(moving.x(timeUs * 1e-6), only().at(timeUs).x(), 0.1);
  }

  @Test
  void whatWasNeverSeenByItselfIsNotShownOnceItsClusterIsGone() {
    Moving one = new Moving(clusters.add(1), 20, 100, 100, 0);
    Moving piece = new Moving(clusters.add(2), 25, 103, 100, 0);
    step(30, one, piece);
    clusters.list.remove(1);
    step(12, one);
    assertEquals(1, only().id);
  }

  @Test
  void aTrackWhoseClusterIsElsewhereGoesOnThereWithAboutItsVelocity() {
    Moving moving = new Moving(clusters.add(5), 20, 30, 120, 0);
    step(40, moving);
    int id = only().id;
    Moving aside = new Moving(moving.cluster, 20, 70, 120, 0);
    for (int i = 0; i < 10; i++) {
      step(1, aside);
      Track track = only();
      assertEquals(120, track == null ? 120 : track.at(timeUs).vx(), 60, "after " + i);
    }
    assertEquals(id, only().id);
    assertEquals(70, only().at(timeUs).y(), 1);
  }

  @Test
  void aTrackThatBeganWithNoIdeaOfItsVelocityIsNotThrownBackForEver() {
    Given cluster = clusters.add(5).at(20, 30);
    step(8, new Moving(cluster, 20, 30, 0, 0));
    double startS = timeUs * 1e-6;
    step(20, new Moving(cluster, 20 - 400 * startS, 30, 400, 0));
    assertEquals(400, only().at(timeUs).vx(), 20);
  }

  @Test
  void itsClusterIsPutWhereItIsExpected() {
    estimator = estimator(KalmanTracksSettings.defaults().with("life.feedbackToCluster=true"));
    Moving moving = new Moving(clusters.add(5), 20, 30, 120, 0);
    step(50, moving);
    Given fed = clusters.list.get(0);
    assertEquals(moving.x(timeUs * 1e-6), fed.fedX, 0.1);
    assertEquals(120, fed.fedVx, 1);
    assertEquals(Long.MIN_VALUE, fed.keptApartUntilUs);
    estimator = estimator(KalmanTracksSettings.original());
    fed.fedX = Double.NaN;
    step(50, moving);
    assertTrue(Double.isNaN(fed.fedX), "fed back though it should not");
  }

  @Test
  void aTrackCoastsWhileItIsHiddenAndTakesTheClusterThatComesOutAgain() {
    Moving moving = new Moving(clusters.add(1), 20, 100, 150, 0);
    step(40, moving);
    int id = only().id;
    clusters.list.clear();
    step(20);
    assertEquals(List.of(), ended);
    Moving again = moving.as(clusters.add(2));
    step(10, again);
    assertEquals(id, only().id);
    assertEquals(again.x(timeUs * 1e-6), only().at(timeUs).x(), 0.5);
  }

  @Test
  void itIsMoreAndMoreUncertainWhileItCoastsAndEndsInTime() {
    Moving moving = new Moving(clusters.add(1), 20, 100, 100, 0);
    step(40, moving);
    clusters.list.clear();
    double before = 0;
    for (int k = 0; k < 9; k++) {
      step(1);
      double variance = only().at(timeUs).covariance(0, 0);
      assertTrue(variance > before);
      before = variance;
    }
    step(5);
    assertNull(only(), "shown though nothing is seen of it");
    step(180);
    assertEquals(List.of(), ended, "in the open it may have stopped");
    step(10);
    assertEquals(List.of(1), ended);
    assertFalse(estimator.isWaiting(STEP_US));
  }

  @Test
  void twoThatCrossKeepTheirIdentitiesThoughTheirClustersChangePlaces() {
    Moving right = new Moving(clusters.add(1), 20, 100, 150, 0);
    Moving up = new Moving(clusters.add(2), 95, 25, 0, 150);
    step(40, right, up);
    int rightId = near(right.x(timeUs * 1e-6), 100).id;
    int upId = near(95, up.y(timeUs * 1e-6)).id;
    step(10, right, up);
    Moving rightOther = right.as(clusters.list.get(1));
    Moving upOther = up.as(clusters.list.get(0));
    step(30, rightOther, upOther);
    double seconds = timeUs * 1e-6;
    assertEquals(rightId, near(right.x(seconds), 100).id);
    assertEquals(upId, near(95, up.y(seconds)).id);
  }

  @Test
  void twoThatMoveDifferentlyAtOnePlaceMayNotMerge() {
    Moving right = new Moving(clusters.add(1), 20, 100, 150, 0);
    Moving up = new Moving(clusters.add(2), 95, 25, 0, 150);
    step(48, right, up);
    assertTrue(clusters.list.get(0).keptApartUntilUs > timeUs);
    assertTrue(clusters.list.get(1).keptApartUntilUs > timeUs);
  }

  @Test
  void twoThatMergeThoughTheyMoveDifferentlyBothGoOn() {
    Moving right = new Moving(clusters.add(1), 20, 100, 150, 0);
    Moving up = new Moving(clusters.add(2), 95, 25, 0, 150);
    step(48, right, up);
    estimator.clustersMerged(timeUs, 1, 2);
    Given lost = clusters.list.remove(1);
    step(15, right);
    Given fresh = clusters.add(9);
    assertNotEquals(fresh.id, lost.id);
    step(20, right, up.as(fresh));
    double seconds = timeUs * 1e-6;
    assertEquals(1, near(right.x(seconds), 100).id);
    assertEquals(2, near(95, up.y(seconds)).id);
    assertEquals(List.of(), ended);
  }

  @Test
  void partsOfOneThingThatMergeAreTheOlderTrack() {
    Moving first = new Moving(clusters.add(1), 20, 100, 100, 0);
    step(20, first);
    Moving part = new Moving(clusters.add(2), 28, 100, 100, 0);
    step(20, first, part);
    estimator.clustersMerged(timeUs, 2, 1);
    clusters.list.remove(0);
    step(10, part);
    assertEquals(1, only().id);
  }

  @Test
  void whatIsThrownBackStaysTheSameTrack() {
    Moving right = new Moving(clusters.add(1), 20, 100, 150, 0);
    step(60, right);
    double turn = timeUs * 1e-6;
    double wall = right.x(turn);
    Moving left = new Moving(clusters.list.get(0), wall + 150 * turn, 100, -150, 0);
    step(30, left);
    assertEquals(1, only().id);
    assertEquals(-150, only().at(timeUs).vx(), 5);
  }

  @Test
  void whatHasStoppedIsTheSameWhenItMovesAgain() {
    Moving slow = new Moving(clusters.add(1), 20, 100, 20, 0);
    step(60, slow);
    clusters.list.clear();
    step(100);
    assertNull(only());
    Moving again = new Moving(clusters.add(2), slow.x(timeUs * 1e-6 - 1), 100, 0, 30);
    Moving from = new Moving(again.cluster, again.x0, 100 - 30 * timeUs * 1e-6, 0, 30);
    step(20, from);
    assertEquals(1, only().id);
  }

  @Test
  void whatLeavesThePictureIsGoneAndIdentitiesAreNotGivenOutTwice() {
    Moving leaving = new Moving(clusters.add(1), 150, 100, 200, 0);
    step(24, leaving);
    clusters.list.clear();
    step(10);
    assertEquals(List.of(1), ended);
    step(20, new Moving(clusters.add(2), 20, 20, 50, 50));
    assertEquals(2, only().id);
    estimator.reset();
    clusters.list.clear();
    assertEquals(0, estimator.trackCount());
    step(20, new Moving(clusters.add(3), 20, 20, 50, 50));
    assertEquals(3, only().id);
  }

  @Test
  void anHourWithoutEventsLeavesNoTrackAndNoReports() {
    step(40, new Moving(clusters.add(1), 20, 100, 100, 0));
    clusters.list.clear();
    int reports = reportsUs.size();
    timeUs += 3_600_000_000L;
    step(1);
    assertEquals(0, estimator.trackCount());
    assertTrue(reportsUs.size() - reports < 200, reportsUs.size() + " reports");
    step(20, new Moving(clusters.add(2), 20 - 100 * timeUs * 1e-6, 100, 100, 0));
    assertEquals(2, only().id);
    assertTrue(only().at(timeUs).covariance(2, 2) < 1e6);
  }

  @Test
  void aClockThatGoesBackNeverGivesANegativeStep() {
    Moving moving = new Moving(clusters.add(1), 20, 100, 0, 0);
    step(40, moving);
    timeUs = -1_000_000;
    step(40, moving);
    assertTrue(estimator.trackCount() <= 2);
    Track track = near(20, 100);
    assertTrue(track.motion.covariance(0, 0) > 0 && track.motion.covariance(0, 0) < 10);
    assertTrue(Math.abs(track.motion.vx()) < 10);
  }

  @Test
  void thereAreNeverMoreTracksThanAllowed() {
    estimator = estimator(KalmanTracksSettings.defaults().with("life.mostTracks=3"));
    Moving[] moving = new Moving[10];
    for (int i = 0; i < moving.length; i++) {
      moving[i] = new Moving(clusters.add(i), 15 * i, 15 * i, 10, 0);
    }
    step(20, moving);
    assertEquals(3, estimator.trackCount());
  }

  @Test
  void afterOtherSettingsATrackBeginsWhereItsClusterIs() {
    int before = stepsTillShown(new Moving(clusters.add(1), 150, 100, 200, 0));
    clusters.list.clear();
    step(220);
    assertEquals(0, estimator.trackCount());
    estimator.apply(estimator.settings().with("life.pathS=2"));
    Moving next = new Moving(clusters.add(2), 20, 20, 10, 10);
    assertEquals(before, stepsTillShown(next));
    assertNotNull(near(next.x(timeUs * 1e-6), next.y(timeUs * 1e-6)));
  }

  private int stepsTillShown(Moving moving) {
    int steps = 0;
    while (only() == null && steps < 100) {
      step(1, moving);
      steps++;
    }
    return steps;
  }

  @Test
  void theOriginalWaitsForTheEventsOfAllClustersTogether() {
    estimator = estimator(KalmanTracksSettings.original().with("measurement.eventsTillTrack=200"));
    Moving a = new Moving(clusters.add(1), 20, 30, 50, 0);
    Moving b = new Moving(clusters.add(2), 20, 130, 50, 0);
    step(4, a, b);
    assertEquals(0, estimator.trackCount());
    step(1, a, b);
    assertEquals(2, estimator.trackCount());
    step(95, a, b);
    Track track = near(a.x(timeUs * 1e-6 - 0.005), 30);
    assertEquals(20, track.updates);
  }

  @Test
  void withDynamicVariancesTheMeasurementIsBelievedLessAndLess() {
    estimator = estimator(KalmanTracksSettings.original().with("measurement.eventsTillTrack=20"));
    Moving moving = new Moving(clusters.add(1), 20, 30, 50, 0);
    step(5, moving);
    Measurement early = measured();
    assertTrue(early.xx < 2, "young: " + early.xx);
    step(200, moving);
    assertEquals(8, measured().xx, 0.2);
  }

  private Measurement measured() {
    Measurement measurement = new Measurement(estimator.settings().measurement(), false);
    EventBatch batch = new EventBatch();
    batch.begin(1, timeUs);
    batch.add(timeUs, clusters, 0);
    Track track = only();
    assertNotNull(track);
    measurement.of(batch, track, clusters, timeUs);
    return measurement;
  }
}
