package haltere.testing.benchmark;

import haltere.core.chain.FilterChain;
import haltere.core.chain.Filters;
import haltere.core.event.EventPacket;
import haltere.core.pipeline.LiveBuffer;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.concurrent.SynchronousQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;

/** Latency from a packet to its results: the figures of docs/embedding.md. */
@State(Scope.Thread)
@BenchmarkMode(Mode.SampleTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class LatencyBenchmark {
  /** Length of a packet. */
  @Param({"64", "512", "4096"})
  public int events;

  /** The filter that the chain has. */
  @Param({"object-tracker", "wing-tracker"})
  public String filter;

  private final SynchronousQueue<Object> done = new SynchronousQueue<>();
  private Workload workload;
  private EventPacket waiting;
  private int next;
  private EventPacket part;
  private FilterChain chain;
  private LiveBuffer buffer;

  /** Starts the thread that filters. */
  @Setup
  public void start() throws IOException {
    workload = Workload.named("fly");
    chain = new FilterChain(workload.geometry);
    chain.add(Filters.named(filter));
    part = new EventPacket(events);
    buffer = new LiveBuffer(workload.geometry, 1 << 16, 1 << 13, OverflowPolicy.BLOCK, "it");
  }

  private EventPacket part(Consumer<StreamNotification> restarted) {
    if (waiting == null || next + events > waiting.size()) {
      if (workload.atStart()) {
        restarted.accept(new Reset(Reset.Cause.CLOCK_RESTARTED));
      }
      waiting = workload.nextPacket();
      next = 0;
    }
    part.clear();
    part.append(waiting, next, next + events);
    next += events;
    return part;
  }

  /** In the thread that makes the packet. */
  @Benchmark
  public void onOneThread() {
    chain.process(part(chain::notified));
  }

  /** From the thread that makes the packet through a buffer to the one that filters. */
  @Benchmark
  public void betweenTwoThreads(Filtering consumer) throws InterruptedException {
    consumer.start(this);
    buffer.packet(part(buffer::notified));
    done.take();
  }

  /** Filters what comes out of the buffer. */
  @State(Scope.Thread)
  public static class Filtering {
    private Thread thread;
    private LiveBuffer buffer;

    void start(LatencyBenchmark benchmark) {
      if (thread != null) {
        return;
      }
      buffer = benchmark.buffer;
      thread =
          new Thread(
              () -> {
                StreamHandler filtering =
                    new StreamHandler() {
                      @Override
                      public void packet(EventPacket packet) {
                        benchmark.chain.process(packet);
                        try {
                          benchmark.done.put(this);
                        } catch (InterruptedException stop) {
                          Thread.currentThread().interrupt();
                        }
                      }

                      @Override
                      public void notified(StreamNotification notification) {
                        benchmark.chain.notified(notification);
                      }
                    };
                try {
                  buffer.drainTo(filtering);
                } catch (IOException thrown) {
                  throw new UncheckedIOException(thrown);
                }
              });
      thread.setDaemon(true);
      thread.start();
    }

    /** Ends the thread. */
    @TearDown
    public void stop() {
      if (buffer != null) {
        buffer.close();
      }
    }
  }
}
