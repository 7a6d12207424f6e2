package haltere.ui.viewer.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.EventFilter;
import haltere.core.chain.FilterChain;
import haltere.core.chain.Outlet;
import haltere.core.event.EventPacket;
import haltere.core.format.Recordings;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.RecordingPlayable;
import haltere.core.playback.SliceSink;
import haltere.core.playback.Slicing;
import haltere.testing.Recorded;
import haltere.testing.Waiting;
import haltere.ui.rendering.ColourMap;
import haltere.ui.rendering.DisplayMode;
import haltere.ui.rendering.Gradient;
import haltere.ui.viewer.picture.DisplayOptions;
import haltere.ui.viewer.picture.DisplaySink;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Two identical chains publish the same, however their moment was reached. */
@Timeout(value = 60, unit = TimeUnit.SECONDS, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class SecondChainTest {
  /** Publishes how many events a packet has, and remembers for a tenth of a second. */
  private static final class Counter implements EventFilter {
    private final List<Integer> published = new ArrayList<>();
    private final Outlet<Integer> sizes = new Outlet<>("sizes", Integer.class);

    Counter() {
      sizes.subscribe(published::add);
    }

    @Override
    public List<Outlet<?>> outlets() {
      return List.of(sizes);
    }

    @Override
    public void process(EventPacket packet) {
      sizes.publish(packet.size());
    }

    @Override
    public void reset() {
      // nothing depends on the events before
    }

    @Override
    public long memoryUs() {
      return 100_000;
    }
  }

  /** Counts how often a slice stayed. */
  private record HoldSink(AtomicInteger held) implements SliceSink {
    @Override
    public void packet(EventPacket packet) {
      // of no interest
    }

    @Override
    public void sliceEnd(long fromUs, long toUs) {
      // of no interest
    }

    @Override
    public void sliceHeld() {
      held.incrementAndGet();
    }
  }

  private static FilterChain chain(RecordingPlayable playable, Counter counter) {
    FilterChain chain = new FilterChain(playable.geometry());
    chain.add("counter", counter);
    return chain;
  }

  @Test
  void recomputedMomentIsPublishedByNeitherChain() throws Exception {
    RecordingPlayable playable =
        new RecordingPlayable(Recordings.open(Recorded.file("dvxplorer-sample.aedat4")));
    Counter firstCounter = new Counter();
    Counter secondCounter = new Counter();
    FilterChain first = chain(playable, firstCounter);
    DisplayOptions shown =
        new DisplayOptions(
            DisplayMode.POLARITY,
            ColourMap.DARK,
            Gradient.CIVIDIS,
            DisplayOptions.FOLLOW_SLICES,
            0);
    DisplaySink display = DisplaySink.direct(playable.geometry(), first, shown);
    SecondChain second = new SecondChain(chain(playable, secondCounter), first, display);
    AtomicInteger held = new AtomicInteger();
    PlayerOptions options =
        PlayerOptions.defaults().withSlicing(new Slicing.ByTime(8_333)).withPaused(true);
    try (Player player = new Player(playable, first, options)) {
      player.addRawSink(second);
      player.addSink(display);
      player.addSink(new HoldSink(held));
      player.start().join();
      player.seek(300_000).join();
      player.step(2).join();
      int before = held.get();
      player.refresh().join();
      Waiting.until("the moment is made anew", () -> held.get() > before);
      player.step(1).join();
      // behind all that was asked for
      player.read(chain -> {}).join();
    }
    second.close();
    assertTrue(firstCounter.published.size() > 3);
    assertEquals(firstCounter.published, secondCounter.published);
  }
}
