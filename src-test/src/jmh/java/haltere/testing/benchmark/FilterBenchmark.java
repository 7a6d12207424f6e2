package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import haltere.core.chain.Filters;
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
 * Each filter alone with its default settings, in million events a second, beside one that does
 * nothing: what that one costs is the copy of the packet and the benchmark itself.
 *
 * <p>Figures to beat on one core, events from real recordings: background activity 66 (320x240) and
 * 60 (1280x720) in dv-processing 2.0.4; refractory period 107 and 81, hot pixels 107 and 84 in
 * eventcv 1.0.8; trackers 6.6 (mean shift of dv-processing) and 5.4 (components of eventcv).
 *
 * <p>Run: {@code ./gradlew :src-test:jmh -Pbench=FilterBenchmark}; on a recording with {@code
 * -PjmhArgs='-p events=dvs128-pendulum.aedat'} and HALTERE_RECORDINGS set to its folder.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class FilterBenchmark {
  /** Name of the filter, or {@code nothing}. */
  @Param({
    "nothing",
    "refractory",
    "background-activity",
    "hot-pixels",
    "frequency-map",
    "region",
    "polarity",
    "cluster-tracker",
    "object-tracker"
  })
  public String filter;

  /** Events and sensor. */
  @Param({"noise-320x240", "bars-320x240", "bars-1280x720", "fly"})
  public String events;

  private Workload workload;
  private EventFilter tested;

  /** Makes the filter and the events. */
  @Setup
  public void setUp() throws IOException {
    workload = Workload.named(events);
    tested = filter.equals("nothing") ? null : Filters.named(filter).create(workload.geometry);
  }

  /**
   * Filters a packet.
   *
   * @return events that are left
   */
  @Benchmark
  @OperationsPerInvocation(Workload.PACKET_EVENTS)
  public int filter() {
    if (tested != null && workload.atStart()) {
      tested.reset();
    }
    EventPacket packet = workload.nextPacket();
    if (tested != null) {
      tested.process(packet);
    }
    return packet.size();
  }
}
