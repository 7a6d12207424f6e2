package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.dots.MovingDotsScene;
import haltere.core.simulation.internal.dots.MovingDotsSettings;
import haltere.filters.cluster.ClusterTrackerFilter;
import haltere.filters.cluster.ClusterTrackerSettings;
import haltere.filters.object.ObjectTrackerFilter;
import haltere.filters.object.ObjectTrackerSettings;
import haltere.filters.track.KalmanTracksFilter;
import haltere.filters.track.KalmanTracksSettings;
import java.io.IOException;

/**
 * Twenty dots on circles before 640x480 pixels, 0.67 million events a second for 1.6 s, and the
 * filters that follow them.
 */
final class TwentyDots {
  private static final SensorGeometry SENSOR = new SensorGeometry(640, 480);
  private static final double EVENTS_PER_PIXEL = 9.3;
  private static final double RATE_HZ = 0.67e6;

  private TwentyDots() {}

  /**
   * The events.
   *
   * @param noiseShare which share of them is noise, 0 to 1
   */
  static Workload events(double noiseShare) throws IOException {
    return Workload.of(
        new MovingDotsScene(
            MovingDotsSettings.defaults()
                .with(
                    "sensor.widthPx=" + SENSOR.width(),
                    "sensor.heightPx=" + SENSOR.height(),
                    "dots.path=circles",
                    "dots.count=20",
                    "dots.speedPxS=300",
                    "noise.leakHz=0",
                    "dots.eventsPerPixel=" + EVENTS_PER_PIXEL * (1 - noiseShare),
                    "noise.shotHz=" + noiseShare * RATE_HZ / SENSOR.pixels(),
                    "noise.hotPixels=0",
                    "run.durationS=1.6")));
  }

  /** Clusters alone. */
  static EventFilter clusters() {
    return new ClusterTrackerFilter(SENSOR, clusterSettings());
  }

  /** Tracks, with clusters of their own. */
  static EventFilter tracks() {
    return new KalmanTracksFilter(
        SENSOR, KalmanTracksSettings.defaults().withClusters(clusterSettings()));
  }

  /** Objects. */
  static EventFilter objects() {
    return new ObjectTrackerFilter(SENSOR, ObjectTrackerSettings.defaults());
  }

  private static ClusterTrackerSettings clusterSettings() {
    return ClusterTrackerSettings.defaults().with("output.maxClusters=40", "shape.size=0.02");
  }
}
