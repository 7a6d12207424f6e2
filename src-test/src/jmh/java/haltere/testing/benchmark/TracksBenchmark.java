package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import java.io.IOException;
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
 * What the object tracker costs, clusters, and Kalman tracks with the clusters that they stand on:
 * time of an event with 20 dots on circles before 640x480 pixels, and the object tracker with 200
 * of them before 1280x720.
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
  /** Objects; 200 of them; clusters alone; or tracks with clusters of their own. */
  @Param({"objects", "200-objects", "clusters", "tracks"})
  public String filter;

  /** Share of the events that are noise. */
  @Param({"0", "0.5"})
  public double noiseShare;

  private Workload workload;
  private EventFilter tested;

  /**
   * Makes the filter and the events.
   *
   * @throws IOException never, for the scene is simulated
   */
  @Setup
  public void setUp() throws IOException {
    boolean isCrowd = filter.equals("200-objects");
    workload = isCrowd ? TwentyDots.tenTimes(noiseShare) : TwentyDots.events(noiseShare);
    tested =
        switch (filter) {
          case "objects", "200-objects" -> TwentyDots.objects(workload.geometry);
          case "clusters" -> TwentyDots.clusters();
          default -> TwentyDots.tracks();
        };
  }

  /**
   * Filters a packet.
   *
   * @return events that are left
   */
  @Benchmark
  @OperationsPerInvocation(Workload.PACKET_EVENTS)
  public int filter() {
    if (workload.atStart()) {
      tested.reset();
    }
    EventPacket packet = workload.nextPacket();
    tested.process(packet);
    return packet.size();
  }
}
