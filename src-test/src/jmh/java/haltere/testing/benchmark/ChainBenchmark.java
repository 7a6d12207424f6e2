package haltere.testing.benchmark;

import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.stream.Reset;
import haltere.filters.DefaultChain;
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
 * Whole chains, in million events a second. The chain of no filter shows what the look for events
 * outside of the sensor costs, the one with a filter that does nothing what a stage costs.
 *
 * <p>Run: {@code ./gradlew :src-test:jmh -Pbench=ChainBenchmark}
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.Throughput)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class ChainBenchmark {
  /** Filters of the chain. */
  @Param({"empty", "nothing", "default"})
  public String chain;

  /** Events and sensor. */
  @Param({"bars-320x240", "fly"})
  public String events;

  private Workload workload;
  private FilterChain tested;

  /** Makes the chain and the events. */
  @Setup
  public void setUp() throws IOException {
    workload = Workload.named(events);
    tested =
        chain.equals("default")
            ? DefaultChain.create(workload.geometry)
            : new FilterChain(workload.geometry);
    if (chain.equals("nothing")) {
      tested.add("nothing", new NothingFilter());
    }
  }

  /**
   * Lets a packet through.
   *
   * @return events that are left
   */
  @Benchmark
  @OperationsPerInvocation(Workload.PACKET_EVENTS)
  public int process() {
    if (workload.atStart()) {
      tested.notified(new Reset(Reset.Cause.REWIND));
    }
    EventPacket packet = workload.nextPacket();
    tested.process(packet);
    return packet.size();
  }

  private static final class NothingFilter implements EventFilter {
    @Override
    public void process(EventPacket packet) {
      // That is the point.
    }

    @Override
    public void reset() {
      // Nothing to forget.
    }
  }
}
