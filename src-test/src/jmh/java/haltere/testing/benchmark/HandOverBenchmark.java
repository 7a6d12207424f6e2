package haltere.testing.benchmark;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.pipeline.LiveBuffer;
import haltere.core.pipeline.OverflowPolicy;
import haltere.core.pipeline.PacketPool;
import haltere.core.sink.Mailbox;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Cost of handing over a value or a packet, on one thread and between two. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class HandOverBenchmark {
  private static final int HAND_OVERS = 100_000;
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  private final Mailbox<Object> mailbox = new Mailbox<>();
  private final Object value = new Object();
  private final PacketPool pool = new PacketPool(8, 16);
  private final EventPacket packet = packet(1024);
  private final LiveBuffer buffer =
      new LiveBuffer(SENSOR, 8 * 4096, 4096, OverflowPolicy.DROP_NEWEST, "benchmark");
  private final StreamHandler nowhere =
      new StreamHandler() {
        @Override
        public void packet(EventPacket taken) {}

        @Override
        public void notified(StreamNotification notification) {}
      };

  private static EventPacket packet(int events) {
    EventPacket made = new EventPacket(events);
    for (int i = 0; i < events; i++) {
      made.append(i, i & 127, i >> 7 & 127, true);
    }
    return made;
  }

  /** Puts a value in and takes it out. */
  @Benchmark
  public Object mailboxPutAndPoll() {
    mailbox.put(value);
    return mailbox.poll();
  }

  /** Puts a value over one that nobody took. */
  @Benchmark
  public Object mailboxConflated() {
    return mailbox.put(value);
  }

  /** One packet round, without another thread. */
  @Benchmark
  public void poolOnOneThread() throws InterruptedException {
    pool.hand(pool.take());
    pool.release(pool.receive());
  }

  /** One packet from one thread to another and back. */
  @Benchmark
  @OperationsPerInvocation(HAND_OVERS)
  public void poolBetweenTwoThreads() throws InterruptedException {
    Thread producer =
        new Thread(
            () -> {
              try {
                for (int i = 0; i < HAND_OVERS; i++) {
                  pool.hand(pool.take());
                }
              } catch (InterruptedException e) {
                Thread.currentThread().interrupt();
              }
            });
    producer.start();
    for (int i = 0; i < HAND_OVERS; i++) {
      pool.release(pool.receive());
    }
    producer.join();
  }

  /** A packet of 1024 events in, copied, and out. */
  @Benchmark
  public void liveBufferOfAThousandEvents() throws IOException {
    buffer.packet(packet);
    buffer.next(nowhere);
  }
}
