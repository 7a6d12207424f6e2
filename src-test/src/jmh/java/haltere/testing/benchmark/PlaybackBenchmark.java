package haltere.testing.benchmark;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.playback.Playable;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.Slicing;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import java.io.IOException;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CountDownLatch;
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
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * What the player costs beside the plain pipeline, per event: looking ahead, copying, cutting into
 * slices, counting. A million events a second of recording time, an empty chain, one sink.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PlaybackBenchmark {
  private static final int EVENTS = 1 << 22;
  private static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  /** Events in a packet of the source. */
  @Param({"1000", "4096", "65536"})
  public int packetEvents;

  /** Hands out one packet again and again, with later times each time. */
  private static final class Packets implements Playable {
    private final EventPacket packet;
    private int given = -1;
    private boolean ended;

    Packets(int size) {
      packet = new EventPacket(size);
      for (int i = 0; i < size; i++) {
        packet.append(i, i * 7 & 127, i * 13 & 127, (i & 1) == 0);
      }
    }

    @Override
    public boolean next(StreamHandler handler) {
      if (ended) {
        return false;
      }
      if (given < 0) {
        given = 0;
        handler.notified(new StreamStarted(SENSOR, "packets"));
      } else if (given + packet.size() > EVENTS) {
        ended = true;
        handler.notified(new EndOfStream(given));
      } else {
        long[] timesUs = packet.timesUs();
        for (int i = 0; i < timesUs.length; i++) {
          timesUs[i] = given + i;
        }
        given += timesUs.length;
        handler.packet(packet);
      }
      return true;
    }

    @Override
    public String name() {
      return "packets";
    }

    @Override
    public SensorGeometry geometry() {
      return SENSOR;
    }

    @Override
    public OptionalLong durationUs() {
      return OptionalLong.of(EVENTS);
    }

    @Override
    public boolean seekable() {
      return false;
    }

    @Override
    public void seek(long elapsedUs) {
      throw new UnsupportedOperationException();
    }

    @Override
    public long elapsedUs(long timeUs) {
      return timeUs;
    }

    @Override
    public void close() {}
  }

  private static final class Count implements StreamHandler {
    final CountDownLatch ended = new CountDownLatch(1);
    long events;

    @Override
    public void packet(EventPacket packet) {
      events += packet.size();
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof EndOfStream) {
        ended.countDown();
      }
    }
  }

  /** The baseline: source, chain, sink. */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public long pipeline() throws IOException {
    Count sink = new Count();
    Pipeline.run(
        new Packets(packetEvents), new FilterChain(SENSOR), List.of(sink), new PipelineCounters());
    return sink.events;
  }

  private long play(Slicing slicing) throws InterruptedException {
    Count sink = new Count();
    PlayerOptions options =
        PlayerOptions.defaults().withSlicing(slicing).withSpeed(Double.POSITIVE_INFINITY);
    try (Player player = new Player(new Packets(packetEvents), new FilterChain(SENSOR), options)) {
      player.addSink(sink);
      player.start();
      sink.ended.await();
    }
    return sink.events;
  }

  /** Slices of a thousand events. */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public long slicesOfAMillisecond() throws InterruptedException {
    return play(new Slicing.ByTime(1_000));
  }

  /** Slices of a picture at sixty a second. */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public long slicesOfAPicture() throws InterruptedException {
    return play(new Slicing.PerFrame(60));
  }

  /** Slices by count. */
  @Benchmark
  @OperationsPerInvocation(EVENTS)
  public long slicesOfAThousandEvents() throws InterruptedException {
    return play(new Slicing.ByCount(1_000));
  }
}
