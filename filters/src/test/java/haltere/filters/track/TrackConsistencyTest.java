package haltere.filters.track;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.cluster.Cluster;
import haltere.filters.cluster.ClusterListener;
import haltere.filters.cluster.ClusterTracker;
import haltere.filters.cluster.ClusterTrackerSettings;
import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Interval;
import haltere.filters.estimation.Whiteness;
import haltere.filters.plane.PlaneJacobian;
import haltere.filters.plane.PlaneMapping;
import haltere.filters.plane.RoadMapping;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

/**
 * The stated deviations are true on data of the model: normalised errors and innovations lie in
 * their bands, and innovations are white, in the picture and on a road.
 */
class TrackConsistencyTest {
  private static final int RUNS = 1000;
  private static final double CONFIDENCE = 0.99;
  private static final int STEPS = 80;
  private static final long STEP_US = 10_000;

  private final SplittableRandom random = new SplittableRandom(1);
  private final ClusterTracker clusters = clusters();
  private double neesSum;
  private double nisSum;
  private int nisCount;
  private double productSum;
  private double squareSum;

  /** A visible cluster whose location the test decides. */
  private static ClusterTracker clusters() {
    ClusterTracker made =
        new ClusterTracker(
            new SensorGeometry(4, 4), ClusterTrackerSettings.defaults(), new ClusterListener() {});
    EventPacket events = new EventPacket(0);
    for (int i = 0; i < 100; i++) {
      events.append(i * 100, 2, 2, true);
    }
    made.track(events);
    assertTrue(made.cluster(0).isVisible());
    return made;
  }

  @Test
  void neesAndNisInThePictureLieInTheirBands() {
    KalmanTracksSettings settings =
        KalmanTracksSettings.defaults().with("minProcessVariance=400", "launchSpeedPxS=100");
    for (int run = 0; run < RUNS; run++) {
      follow(settings, PlaneMapping.PICTURE, 400, 200, 200);
    }
    assertInBands();
  }

  @Test
  void variancesOnARoadMatchTheMapping() {
    // Small noise, within the linear range of the mapping.
    KalmanTracksSettings settings =
        KalmanTracksSettings.defaults()
            .with(
                "mapToRoad=true",
                "road.processVariance=0.5",
                "maxMeasurementVariance=0.0025",
                "launchSpeedPxS=3");
    RoadMapping road = new RoadMapping(settings.road().view(), new SensorGeometry(128, 128));
    for (int run = 0; run < RUNS; run++) {
      follow(settings, road, 0.5, 2, 20);
    }
    assertInBands();
  }

  private void assertInBands() {
    assertIn(Consistency.meanBand(4, RUNS, CONFIDENCE), neesSum / RUNS, "NEES");
    assertIn(Consistency.meanBand(2, nisCount, CONFIDENCE), nisSum / nisCount, "NIS");
    assertIn(Whiteness.band(nisCount, CONFIDENCE), productSum / squareSum, "whiteness");
  }

  private static void assertIn(Interval band, double value, String what) {
    assertTrue(band.lower() <= value && value <= band.upper(), what + " " + value + " in " + band);
  }

  /** One target from its birth; its error counts at the end, where runs are independent. */
  private void follow(
      KalmanTracksSettings settings,
      PlaneMapping mapping,
      double density,
      double startX,
      double startY) {
    double sd = Math.sqrt(settings.filter().maxMeasurementVariance());
    TrackPrediction filter = new TrackPrediction(mapping, settings);
    Cluster cluster = clusters.cluster(0);
    Track track = new Track(1);
    PlaneJacobian start =
        mapping.jacobian(mapping.pixelX(startX, startY), mapping.pixelY(startX, startY));
    double vxPxS = settings.filter().launchSpeedPxS() * random.nextGaussian();
    double vyPxS = settings.filter().launchSpeedPxS() * random.nextGaussian();
    double[] x = {startX, start.x(vxPxS, vyPxS)};
    double[] y = {startY, start.y(vxPxS, vyPxS)};
    double before = 0;
    for (int k = 0; k < STEPS; k++) {
      clusters.move(
          cluster,
          mapping.pixelX(x[0], y[0]) + sd * random.nextGaussian(),
          mapping.pixelY(x[0], y[0]) + sd * random.nextGaussian());
      if (k == 0) {
        track.follow(cluster, 0);
        filter.start(track);
      } else {
        assertTrue(filter.predict(track, k * STEP_US));
        TrackUpdate update = filter.correct(true);
        nisSum += update.nis();
        nisCount++;
        double innovation = update.innovationX() / Math.sqrt(update.sXx());
        productSum += innovation * before;
        squareSum += innovation * innovation;
        before = innovation;
      }
      if (k < STEPS - 1) {
        wander(x, density);
        wander(y, density);
      }
    }
    DMatrixRMaj error = new DMatrixRMaj(new double[][] {{-x[0]}, {-x[1]}, {-y[0]}, {-y[1]}});
    for (int i = 0; i < 4; i++) {
      error.add(i, 0, track.belief.mean(i));
    }
    neesSum += Consistency.nees(error, track.belief.covariance());
  }

  /** Constant velocity and white acceleration, drawn by the Cholesky factor of Q. */
  private void wander(double[] state, double density) {
    double dt = STEP_US * 1e-6;
    double a = random.nextGaussian();
    double b = random.nextGaussian();
    double correlation = Math.sqrt(0.75);
    state[0] += state[1] * dt + Math.sqrt(density * dt * dt * dt / 3) * a;
    state[1] +=
        Math.sqrt(density * dt) * (correlation * a + Math.sqrt(1 - correlation * correlation) * b);
  }

  @Test
  void updateMatchesTheEquations() {
    KalmanTracksSettings settings = KalmanTracksSettings.defaults();
    TrackPrediction filter = new TrackPrediction(PlaneMapping.PICTURE, settings);
    Track track = new Track(1);
    Cluster cluster = clusters.cluster(0);
    clusters.move(cluster, 10, 20);
    track.follow(cluster, 0);
    filter.start(track);
    clusters.move(cluster, 12, 17);
    filter.predict(track, 100_000);
    TrackUpdate update = filter.correct(true);
    // P⁻ = 1 + 300² 0.1² + 20000 0.1³/3, R = 1.
    double prior = 1 + 900 + 20_000e-3 / 3;
    assertEquals(1, update.rPx2());
    assertEquals(20_000e-3 / 3, update.qXx(), 1e-9);
    assertEquals(20_000e-2 / 2, update.qXvx(), 1e-9);
    assertEquals(20_000e-1, update.qVxvx(), 1e-9);
    assertEquals(prior + 1, update.sXx(), 1e-9);
    assertEquals(0, update.sXy(), 1e-9);
    assertEquals(2, update.innovationX(), 1e-12);
    assertEquals(-3, update.innovationY(), 1e-12);
    assertEquals(13 / (prior + 1), update.nis(), 1e-9);
    assertEquals(prior / (prior + 1), update.gainX(), 1e-9);
    assertEquals(update.gainX(), update.gainY(), 1e-9);
    double cross = 9000 + 100;
    assertEquals(cross / (prior + 1), update.gainVx(), 1e-9);
    assertEquals(10 + 2 * update.gainX(), update.x(), 1e-9);
    assertEquals(-3 * update.gainVy(), update.vy(), 1e-9);
    assertEquals(12, update.measuredX(), 1e-12);
    assertEquals(prior - prior * update.gainX(), update.pXx(), 1e-9);
  }
}
