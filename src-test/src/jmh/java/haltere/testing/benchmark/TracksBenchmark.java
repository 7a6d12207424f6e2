package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.simulation.dots.MovingDotsScene;
import haltere.core.simulation.dots.MovingDotsSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.filters.cluster.ClusterTrackerFilter;
import haltere.filters.cluster.ClusterTrackerSettings;
import haltere.filters.track.KalmanTracksSettings;
import haltere.filters.track.kalman.KalmanTracksFilter;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What Kalman tracks cost on top of the clusters that they stand on: time of an event with 20 dots
 * on circles before 640x480 pixels. The figure to reach is 10 % more than clusters alone.
 *
 * <p>Run: {@code ./gradlew :src-test:jmh -Pbench=TracksBenchmark}
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class TracksBenchmark {
  private static final int PACKETS = 256;
  private static final double EVENTS_PER_PIXEL = 9.3;
  private static final double RATE_HZ = 0.67e6;
  private static final int PIXELS = 640 * 480;

  /** Clusters alone, or tracks with clusters of their own. */
  @Param({"clusters", "tracks"})
  public String filter;

  /** Share of the 0.67 million events a second that are noise. */
  @Param({"0", "0.5"})
  public double noiseShare;

  private final EventPacket packet = new EventPacket(Workload.PACKET_EVENTS);
  private final EventPacket stream = new EventPacket(PACKETS * Workload.PACKET_EVENTS);
  private EventFilter tested;
  private int next;

  /** Makes the filter and the events. */
  @Setup
  public void setUp() {
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
    ClusterTrackerSettings clusters =
        ClusterTrackerSettings.defaults().with("output.mostClusters=40");
    tested =
        filter.equals("clusters")
            ? new ClusterTrackerFilter(scene.geometry(), clusters)
            : new KalmanTracksFilter(
                scene.geometry(), KalmanTracksSettings.defaults().withClusters(clusters));
  }

  /**
   * Filters a packet.
   *
   * @return events that are left
   */
  @Benchmark
  @OperationsPerInvocation(Workload.PACKET_EVENTS)
  public int filter() {
    if (next == 0) {
      tested.reset();
    }
    packet.clear();
    packet.append(stream, next, next + Workload.PACKET_EVENTS);
    next = (next + Workload.PACKET_EVENTS) % (PACKETS * Workload.PACKET_EVENTS);
    tested.process(packet);
    return packet.size();
  }
}
