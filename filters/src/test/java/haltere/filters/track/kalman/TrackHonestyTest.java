package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.estimation.Consistency;
import haltere.filters.estimation.Interval;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.TrackUpdate;
import haltere.filters.track.motion.MotionModes;
import java.util.SplittableRandom;
import org.ejml.data.DMatrixRMaj;
import org.junit.jupiter.api.Test;

/**
 * Tracks are as sure as they say: over many runs on targets drawn from their own model, normalised
 * errors and innovations lie in their bands, and innovations are white.
 */
class TrackHonestyTest {
  private static final int RUNS = 200;
  private static final int STEPS = 80;
  private static final int SETTLED = 10;
  private static final long STEP_US = 10_000;
  private static final double DENSITY = 400;
  private static final double LAUNCH_SPEED = 100;

  private final SplittableRandom random = new SplittableRandom(7);
  private double neesSum;
  private double nisSum;
  private int nisCount;
  private double productSum;
  private double squareSum;
  private double lastInnovation;

  @Test
  void errorsAndInnovationsLieInTheirBands() {
    for (int run = 0; run < RUNS; run++) {
      follow();
    }
    assertIn(Consistency.meanBand(4, RUNS, 0.95), neesSum / RUNS, "NEES");
    assertIn(Consistency.meanBand(2, nisCount, 0.95), nisSum / nisCount, "NIS");
    assertIn(Consistency.whitenessBand(nisCount, 0.95), productSum / squareSum, "whiteness");
  }

  private static void assertIn(Interval band, double value, String what) {
    assertTrue(band.lower() <= value && value <= band.upper(), what + " " + value + " in " + band);
  }

  /** One target from its birth; the error counts at the end, where runs are independent. */
  private void follow() {
    KalmanTracksSettings settings =
        KalmanTracksSettings.defaults()
            .with(
                "motion.model=straight",
                "motion.minProcessVariance=" + DENSITY,
                "motion.launchSpeedPxS=" + LAUNCH_SPEED,
                "measurement.floorPx=0",
                "life.gateSigmas=10");
    TrackEstimator estimator =
        new TrackEstimator(new SensorGeometry(4000, 4000), settings, new Innovations());
    GivenClusters clusters = new GivenClusters();
    GivenClusters.Given cluster = clusters.add(1);
    double x = 2000;
    double y = 2000;
    double vx = LAUNCH_SPEED * random.nextGaussian();
    double vy = LAUNCH_SPEED * random.nextGaussian();
    lastInnovation = 0;
    for (int k = 1; k <= STEPS; k++) {
      cluster.newEvents = random.nextInt(6, 40);
      cluster.ageUs = 0;
      double sd = Math.sqrt(cluster.variance / cluster.newEvents);
      cluster.at(x + sd * random.nextGaussian(), y + sd * random.nextGaussian());
      estimator.clustersRead(k * STEP_US, clusters);
      if (k < STEPS) {
        double dt = STEP_US * 1e-6;
        double[] ax = wander(dt);
        double[] ay = wander(dt);
        x += vx * dt + ax[0];
        y += vy * dt + ay[0];
        vx += ax[1];
        vy += ay[1];
      }
    }
    Track track = estimator.shown(0, STEPS * STEP_US);
    MotionModes motion = track.motion;
    DMatrixRMaj error =
        new DMatrixRMaj(
            new double[][] {
              {motion.x() - x}, {motion.y() - y}, {motion.vx() - vx}, {motion.vy() - vy}
            });
    DMatrixRMaj covariance = new DMatrixRMaj(4, 4);
    for (int i = 0; i < 4; i++) {
      for (int j = 0; j < 4; j++) {
        covariance.set(i, j, motion.covariance(i, j));
      }
    }
    neesSum += Consistency.nees(error, covariance);
  }

  /** What white acceleration does to place and velocity: drawn by the Cholesky factor of Q. */
  private double[] wander(double dt) {
    double a = random.nextGaussian();
    double b = random.nextGaussian();
    double place = Math.sqrt(DENSITY * dt * dt * dt / 3);
    double velocity = Math.sqrt(DENSITY * dt);
    double correlation = Math.sqrt(0.75);
    return new double[] {
      place * a, velocity * (correlation * a + Math.sqrt(1 - correlation * correlation) * b)
    };
  }

  private final class Innovations implements TrackListener {
    @Override
    public void reported(long timeUs) {
      // the test looks for itself
    }

    @Override
    public void updated(Track track, Measurement measurement, boolean accepted) {
      assertTrue(accepted, "an honest measurement was refused");
      TrackUpdate update = track.lastUpdate(measurement.timeUs, true);
      if (track.updates <= SETTLED) {
        return;
      }
      nisSum += update.nis();
      nisCount++;
      double innovation = update.innovationX() / Math.sqrt(update.sXx());
      productSum += innovation * lastInnovation;
      squareSum += innovation * innovation;
      lastInnovation = innovation;
    }

    @Override
    public void ended(int id) {
      throw new AssertionError("a target was lost");
    }
  }
}
