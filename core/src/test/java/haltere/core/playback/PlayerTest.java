package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.events;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.StreamNotification;
import haltere.testing.ManualClock;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(20)
class PlayerTest {
  /** Lets a test wait for the end of the stream. */
  private static final class End implements SliceSink {
    final CountDownLatch ended = new CountDownLatch(1);
    volatile Thread thread;
    volatile long slices;

    @Override
    public void packet(EventPacket packet) {
      thread = Thread.currentThread();
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof EndOfStream) {
        ended.countDown();
      }
    }

    @Override
    public void sliceEnd(long fromUs, long toUs) {
      slices++;
    }
  }

  private static RecordingPlayable recording(long durationMs) throws IOException {
    long[] times = LongStream.rangeClosed(0, durationMs).map(i -> i * 1000).toArray();
    return new RecordingPlayable(new MemoryRecording(SENSOR, events(times)));
  }

  private static Player player(Playable playable, PlayerOptions options) {
    return new Player(playable, new FilterChain(SENSOR), options);
  }

  @Test
  void playerPlaysOnItsOwnThreadInVirtualTime() throws Exception {
    ManualClock clock = new ManualClock();
    try (Player player = player(recording(60_000), byTime(10_000).withClock(clock, clock))) {
      End end = new End();
      player.addSink(end);
      player.start().join();
      end.ended.await();
      assertNotEquals(Thread.currentThread(), end.thread);
      assertEquals(60.0, clock.getAsLong() / 1e9, 0.011);
      assertEquals(6001, end.slices);
    }
  }

  @Test
  void realTimePlaybackDoesNotDrift() throws Exception {
    try (Player player = player(recording(600), PlayerOptions.defaults())) {
      End end = new End();
      player.addSink(end);
      long start = System.nanoTime();
      player.start().join();
      end.ended.await();
      double ms = (System.nanoTime() - start) / 1e6;
      // The last slice is due within a slice of the end, and never early.
      assertTrue(ms > 582, "done too early, after " + ms + " ms");
      assertTrue(ms < 900, "done too late, after " + ms + " ms");
      assertTrue(player.status().lagUs() < 300_000, player.status().toString());
    }
  }

  @Test
  void commandsAreAppliedWhileThePlayerWaits() throws Exception {
    PlayerOptions slow =
        PlayerOptions.defaults().withSlicing(new Slicing.ByTime(1_000_000)).withSpeed(1e-4);
    try (Player player = player(recording(10_000), slow)) {
      End end = new End();
      player.addSink(end);
      player.start().join();
      // The next slice is due in more than two hours.
      long start = System.nanoTime();
      player.seek(9_000_000).join();
      player.pause().join();
      player.step(1).join();
      player.step(-1).join();
      assertTrue(System.nanoTime() - start < 2_000_000_000L);
      assertEquals(State.PAUSED, player.status().state());
      player.setSpeed(Double.POSITIVE_INFINITY).join();
      player.play().join();
      end.ended.await();
    }
  }

  @Test
  void futuresCompleteWithTheirCommands() throws Exception {
    try (Player player = player(recording(1000), byTime(1000).withPaused(true))) {
      SliceLog log = new SliceLog();
      player.addSink(log);
      player.start().join();
      player.step(2).join();
      player.seek(500_000).join();
      assertEquals(500_000, player.status().elapsedUs());
      assertEquals(500_000, player.status().timeUs());
      player.rewind().join();
      assertEquals(0, player.status().elapsedUs());
      player.reset().join();
      CompletableFuture<Void> edit =
          player.edit(
              chain -> {
                throw new IllegalArgumentException("not so");
              });
      assertThrows(CompletionException.class, edit::join);
      assertEquals("not so", player.status().message());
    }
  }

  @Test
  void onlyTheLastOfManySeeksIsPlayedAndAllComplete() throws Exception {
    try (Player player = player(recording(1000), byTime(1000).withPaused(true))) {
      SliceLog log = new SliceLog();
      player.addSink(log);
      player.start().join();
      CountDownLatch go = new CountDownLatch(1);
      player.edit(
          chain -> {
            try {
              go.await();
            } catch (InterruptedException e) {
              throw new IllegalStateException(e);
            }
          });
      CompletableFuture<?>[] seeks = new CompletableFuture<?>[50];
      for (int i = 0; i < 50; i++) {
        seeks[i] = player.seek(i * 10_000L);
      }
      go.countDown();
      CompletableFuture.allOf(seeks).join();
      assertEquals(490_000, player.status().elapsedUs());
      player.pause().join();
      List<String> lines = log.take();
      assertEquals(List.of("Reset SEEK", "[490000,491000) [490000]"), tail(lines, 2));
      assertTrue(lines.stream().filter("Reset SEEK"::equals).count() < 3);
    }
  }

  private static List<String> tail(List<String> lines, int count) {
    return lines.subList(lines.size() - count, lines.size());
  }

  @Test
  void closingEndsTheStreamFailsCommandsAndClosesTheRecording() throws Exception {
    MemoryRecording memory = new MemoryRecording(SENSOR, events(0, 1_000_000));
    Player player = player(new RecordingPlayable(memory), byTime(1000).withSpeed(1e-4));
    End end = new End();
    player.addSink(end);
    player.start().join();
    player.close();
    assertEquals(0, end.ended.getCount());
    assertTrue(memory.closed());
    assertTrue(player.play().isCompletedExceptionally());
    assertEquals(State.ENDED, player.status().state());
    player.close();
  }

  @Test
  void unstartedPlayersCloseTheirRecording() throws Exception {
    MemoryRecording memory = new MemoryRecording(SENSOR, events(0, 1));
    Player player = player(new RecordingPlayable(memory), byTime(1000));
    CompletableFuture<Void> waiting = player.seek(1);
    player.close();
    assertTrue(memory.closed());
    assertTrue(waiting.isCompletedExceptionally());
  }

  @Test
  void playerCanBeClosedFromItsOwnThread() throws Exception {
    AtomicReference<Player> self = new AtomicReference<>();
    MemoryRecording memory = new MemoryRecording(SENSOR, events(0, 1));
    self.set(player(new RecordingPlayable(memory), byTime(1000).withPaused(true)));
    End end = new End();
    self.get().addSink(end);
    self.get().start().join();
    self.get().edit(chain -> self.get().close());
    end.ended.await();
  }

  @Test
  void marksAreOrdered() throws Exception {
    try (Player player = player(recording(10), byTime(1000))) {
      assertTrue(player.addMark(new Mark("turn", 500)));
      assertTrue(player.addMark(new Mark("start", 100)));
      assertFalse(player.addMark(new Mark("turn", 500)));
      assertEquals(List.of(new Mark("start", 100), new Mark("turn", 500)), player.marks());
      assertTrue(player.removeMark(new Mark("start", 100)));
      assertEquals(1, player.marks().size());
    }
  }

  @Test
  void invalidValuesAreRejected() {
    assertThrows(IllegalArgumentException.class, () -> new Slicing.ByTime(0));
    assertThrows(IllegalArgumentException.class, () -> new Slicing.ByCount(0));
    assertThrows(IllegalArgumentException.class, () -> new Slicing.PerFrame(Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> Loop.between(5, 5));
    assertThrows(IllegalArgumentException.class, () -> new Mark("before", -1));
    assertThrows(IllegalArgumentException.class, () -> PlayerOptions.defaults().withSpeed(0.00001));
  }
}
