package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.internal.dots.MovingDotsScene;
import haltere.core.simulation.internal.dots.MovingDotsSettings;
import haltere.core.stream.EventSource;
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
    return Workload.of(dots(SENSOR, 20, noiseShare, RATE_HZ));
  }

  /**
   * Ten times as many dots and events before 1280 × 720 pixels: 50 in each quarter.
   *
   * @param noiseShare which share of them is noise, 0 to 1
   */
  static Workload tenTimes(double noiseShare) throws IOException {
    return Workload.of(dots(new SensorGeometry(640, 360), 50, noiseShare, 2.5 * RATE_HZ)).tiled();
  }

  private static EventSource dots(
      SensorGeometry sensor, int count, double noiseShare, double rateHz) {
    return new MovingDotsScene(
        MovingDotsSettings.defaults()
            .with(
                "sensor.widthPx=" + sensor.width(),
                "sensor.heightPx=" + sensor.height(),
                "dots.path=circles",
                "dots.count=" + count,
                "dots.speedPxS=300",
                "noise.leakHz=0",
                "dots.eventsPerPixel=" + EVENTS_PER_PIXEL * (1 - noiseShare),
                "noise.shotHz=" + noiseShare * rateHz / sensor.pixels(),
                "noise.hotPixels=0",
                "run.durationS=1.6"));
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

  /** Objects, of which no row is asked for. */
  static EventFilter objects(SensorGeometry sensor) {
    return new ObjectTrackerFilter(sensor, ObjectTrackerSettings.defaults());
  }

  private static ClusterTrackerSettings clusterSettings() {
    return ClusterTrackerSettings.defaults().with("output.maxClusters=40", "shape.size=0.02");
  }
}
