package haltere.core.playback;

import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.StreamNotification;
import haltere.testing.ManualClock;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.LongStream;

/** An engine driven by the test's own thread in virtual time. */
final class EngineRig {
  static final SensorGeometry SENSOR = new SensorGeometry(16, 16);

  final ManualClock clock = new ManualClock();
  final SliceLog log = new SliceLog();
  final SliceLog raw = new SliceLog();
  final FilterChain chain = new FilterChain(SENSOR);
  final List<String> told = new ArrayList<>();
  final PlaybackEngine engine;

  EngineRig(Playable playable, PlayerOptions options) {
    this(playable, options, 0);
  }

  /** The same with a filter that remembers. */
  EngineRig(Playable playable, PlayerOptions options, long memoryUs) {
    chain.add(
        "listener",
        new EventFilter() {
          @Override
          public long memoryUs() {
            return memoryUs;
          }

          @Override
          public void process(EventPacket packet) {
            for (int i = 0; i < packet.size(); i++) {
              told.add(String.valueOf(packet.timeUs(i)));
            }
          }

          @Override
          public void reset() {}

          @Override
          public void notified(StreamNotification notification) {
            told.add(
                notification instanceof haltere.core.stream.Reset reset
                    ? "Reset " + reset.cause()
                    : notification.getClass().getSimpleName());
          }
        });
    engine = new PlaybackEngine(playable, chain, options.withClock(clock, clock));
    ask(new PlaybackCommand.AddSink(log, false));
    ask(new PlaybackCommand.AddSink(raw, true));
    engine.start(new CompletableFuture<>());
  }

  static RecordingPlayable recording(EventPacket... segments) throws IOException {
    return new RecordingPlayable(new MemoryRecording(SENSOR, () -> 2, segments));
  }

  /** One event every 10 us from 1000 us on. */
  static EventPacket even(int count) {
    return events(LongStream.range(0, count).map(i -> 1000 + 10 * i).toArray());
  }

  static EventFilter filter(Consumer<EventPacket> work) {
    return new EventFilter() {
      @Override
      public void process(EventPacket packet) {
        work.accept(packet);
      }

      @Override
      public long memoryUs() {
        return 0;
      }

      @Override
      public void reset() {}
    };
  }

  static PlayerOptions byTime(long sliceUs) {
    return PlayerOptions.defaults().withSlicing(new Slicing.ByTime(sliceUs));
  }

  static EventPacket events(long... timesUs) {
    EventPacket packet = new EventPacket(timesUs.length);
    for (long timeUs : timesUs) {
      packet.append(timeUs, 1, 2, true);
    }
    return packet;
  }

  CompletableFuture<Void> ask(PlaybackCommand command) {
    CompletableFuture<Void> done = new CompletableFuture<>();
    engine.apply(command, done);
    return done;
  }

  /** Plays until nothing is left to do. */
  EngineRig run() {
    return runUntil(Long.MAX_VALUE);
  }

  /** Plays until the clock would pass a moment, and puts it there. */
  EngineRig runUntil(long nanos) {
    while (true) {
      long wait = engine.turn();
      if (wait == Long.MAX_VALUE) {
        return this;
      }
      if (clock.getAsLong() + wait > nanos) {
        clock.advance(nanos - clock.getAsLong());
        return this;
      }
      clock.advance(wait);
    }
  }
}
