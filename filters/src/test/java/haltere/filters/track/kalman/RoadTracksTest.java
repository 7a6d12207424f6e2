package haltere.filters.track.kalman;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.RoadMapping;
import haltere.filters.track.RoadSettings;
import haltere.filters.track.RoadTracksSettings;
import haltere.filters.track.VanishingPoint;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** Speeds of vehicles from clusters whose places in the picture are measured without bias. */
class RoadTracksTest {
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);
  private static final RoadSettings VIEW = new RoadSettings(5, 6, 300, VanishingPoint.defaults());
  private static final int VEHICLES = 60;
  private static final long STEP_US = 10_000;
  private static final int SETTLED_STEPS = 30;

  private final SplittableRandom random = new SplittableRandom(5);
  private final RoadMapping road = new RoadMapping(VIEW, SENSOR);
  private double sum;
  private double squares;
  private int count;

  @Test
  void vehiclesThatDriveAwayHaveTheirSpeedWithinTwoPercent() {
    drive(1);
    double mean = sum / count;
    assertEquals(1, mean, 0.005);
    assertTrue(Math.sqrt(squares / count - mean * mean) < 0.02);
  }

  @Test
  void vehiclesThatComeHaveItToo() {
    drive(-1);
    double mean = sum / count;
    assertEquals(1, mean, 0.005);
    // Far away, where they begin, a pixel is worth metres.
    assertTrue(Math.sqrt(squares / count - mean * mean) < 0.04);
  }

  private void drive(int direction) {
    for (int vehicle = 0; vehicle < VEHICLES; vehicle++) {
      follow(
          direction * random.nextDouble(12, 20), direction > 0 ? 8 : 90, random.nextDouble(-2, 2));
    }
  }

  private void follow(double speed, double startM, double lateralM) {
    RoadTracksSettings tracks = RoadTracksSettings.defaults().seenAs(VIEW);
    TrackEstimator estimator =
        new TrackEstimator(
            SENSOR,
            KalmanTracksSettings.defaults().with("measurement.source=events").onRoad(tracks),
            new Silent());
    GivenClusters clusters = new GivenClusters();
    GivenClusters.Given cluster = clusters.add(1);
    cluster.radius = 6;
    for (int k = 1; ; k++) {
      double distance = startM + speed * (k - 0.5) * STEP_US * 1e-6;
      if (distance < 8 || distance > 95) {
        return;
      }
      double row = road.rowOf(distance);
      cluster.newEvents = random.nextInt(5, 35);
      cluster.variance = Math.pow(1.3 / road.distancePerY(row), 2) + 0.3;
      double sd = Math.sqrt(cluster.variance / cluster.newEvents);
      cluster.at(
          road.columnOf(lateralM, distance) + sd * random.nextGaussian(),
          row + sd * random.nextGaussian());
      estimator.clustersRead(k * STEP_US, clusters);
      if (k > SETTLED_STEPS) {
        Track track = estimator.shown(0, k * STEP_US);
        double ratio = Math.hypot(track.motion.vx(), track.motion.vy()) / Math.abs(speed);
        sum += ratio;
        squares += ratio * ratio;
        count++;
      }
    }
  }

  private static final class Silent implements TrackListener {
    @Override
    public void reported(long timeUs) {
      // the test looks for itself
    }

    @Override
    public void updated(Track track, Measurement measurement, boolean accepted) {
      assertTrue(accepted, "a vehicle was lost");
    }

    @Override
    public void ended(int id) {
      throw new AssertionError("a vehicle was lost");
    }
  }
}
