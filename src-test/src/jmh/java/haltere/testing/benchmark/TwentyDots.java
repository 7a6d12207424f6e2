package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.dots.MovingDotsScene;
import haltere.core.simulation.dots.MovingDotsSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.cluster.ClusterTrackerFilter;
import haltere.filters.cluster.ClusterTrackerSettings;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.kalman.KalmanTracksFilter;

/**
 * Twenty dots on circles before 640x480 pixels, 0.67 million events a second, and the filters that
 * follow them.
 */
final class TwentyDots {
  private static final int PACKETS = 256;
  private static final double EVENTS_PER_PIXEL = 9.3;
  private static final double RATE_HZ = 0.67e6;
  private static final int PIXELS = 640 * 480;

  private final SensorGeometry geometry;
  private final EventPacket stream = new EventPacket(PACKETS * Workload.PACKET_EVENTS);

  /**
   * Makes the events.
   *
   * @param noiseShare which share of them is noise, 0 to 1
   */
  TwentyDots(double noiseShare) {
    MovingDotsScene scene =
        new MovingDotsScene(
            MovingDotsSettings.defaults()
                .with(
                    "sensor.widthPx=640",
                    "sensor.heightPx=480",
                    "dots.path=circles",
                    "dots.count=20",
                    "dots.speedPxS=300",
                    "noise.leakHz=0",
                    "dots.eventsPerPixel=" + EVENTS_PER_PIXEL * (1 - noiseShare),
                    "noise.shotHz=" + noiseShare * RATE_HZ / PIXELS,
                    "noise.hotPixels=0"));
    geometry = scene.geometry();
    while (stream.size() < PACKETS * Workload.PACKET_EVENTS) {
      scene.next(
          new StreamHandler() {
            @Override
            public void packet(EventPacket made) {
              stream.append(made, 0, made.size());
            }

            @Override
            public void notified(StreamNotification notification) {
              // a scene in one piece
            }
          });
    }
  }

  /** Clusters alone. */
  EventFilter clusters() {
    return new ClusterTrackerFilter(geometry, clusterSettings());
  }

  /** Tracks, with clusters of their own. */
  EventFilter tracks() {
    return new KalmanTracksFilter(
        geometry, KalmanTracksSettings.defaults().withClusters(clusterSettings()));
  }

  private static ClusterTrackerSettings clusterSettings() {
    return ClusterTrackerSettings.defaults().with("output.mostClusters=40");
  }

  /** Fills a packet with the events of a place in the stream, and says where the next ones are. */
  int fill(EventPacket packet, int from) {
    packet.clear();
    packet.append(stream, from, from + Workload.PACKET_EVENTS);
    return (from + Workload.PACKET_EVENTS) % (PACKETS * Workload.PACKET_EVENTS);
  }
}
