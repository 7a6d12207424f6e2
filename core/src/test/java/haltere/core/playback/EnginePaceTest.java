package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.even;
import static haltere.core.playback.EngineRig.events;
import static haltere.core.playback.EngineRig.filter;
import static haltere.core.playback.EngineRig.recording;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

/** Pace of playback, and messages if it is too slow. */
class EnginePaceTest {
  @Test
  void realTimePlaybackDoesNotDriftWithTheCostOfTheChain() throws IOException {
    Random random = new Random(11);
    long[] times = LongStream.range(0, 60_000).map(i -> i * 1000).toArray();
    EngineRig rig =
        new EngineRig(
            new RecordingPlayable(new MemoryRecording(SENSOR, events(times))),
            PlayerOptions.defaults());
    rig.log.quiet = true;
    rig.raw.quiet = true;
    List<Double> errors = new ArrayList<>();
    rig.chain.add(
        "costly",
        filter(
            packet -> {
              // Up to one and a half slices' time, half a slice on the average, and hiccups.
              rig.clock.advance(
                  (long) (Math.pow(random.nextDouble(), 2) * 25_000_000)
                      + (random.nextInt(500) == 0 ? 300_000_000 : 0));
              double late = rig.clock.getAsLong() / 1000.0 - packet.firstTimeUs();
              errors.add(late);
            }));
    rig.run();
    double seconds = rig.clock.getAsLong() / 1e9;
    assertEquals(60.0, seconds, 0.06);
    // Lateness comes and goes but does not pile up.
    assertTrue(errors.get(errors.size() - 1) < 400_000);
    assertTrue(errors.stream().mapToDouble(x -> x).average().orElseThrow() < 60_000);
  }

  @Test
  void slowChainsAreReportedAndLoseNothing() throws IOException {
    long[] times = LongStream.range(0, 5_000).map(i -> i * 1000).toArray();
    EngineRig rig =
        new EngineRig(
            new RecordingPlayable(new MemoryRecording(SENSOR, events(times))), byTime(10_000));
    rig.log.quiet = true;
    rig.raw.quiet = true;
    rig.chain.add("quick", filter(packet -> {}));
    rig.chain.add(
        "dawdler",
        filter(
            packet -> {
              long until = System.nanoTime() + 20_000;
              while (System.nanoTime() < until) {
                Thread.onSpinWait();
              }
              rig.clock.advance(20_000_000);
            }));
    rig.run();
    // 500 slices of 10 ms, each of which took 20 ms.
    PlayerStatus status = rig.engine.status();
    assertEquals(499 * 10_000, status.lagUs(), 20_000);
    assertTrue(status.late());
    assertEquals("dawdler", status.slowestStage());
    assertFalse(status.sourceIsSlowest());
    assertEquals(5_000, rig.log.events);
    assertEquals(10.0, rig.clock.getAsLong() / 1e9, 0.02);
  }

  @Test
  void slowSourcesAreDistinguishedFromSlowChains() throws IOException {
    EngineRig[] rig = new EngineRig[1];
    long[] next = new long[1];
    EventSource slow =
        new EventSource() {
          @Override
          public SensorGeometry geometry() {
            return SENSOR;
          }

          @Override
          public boolean next(StreamHandler handler) {
            rig[0].clock.advance(15_000_000);
            handler.packet(events(next[0]));
            next[0] += 10_000;
            return true;
          }

          @Override
          public void close() {}
        };
    rig[0] = new EngineRig(new ScenePlayable(() -> slow, "slow"), byTime(10_000));
    rig[0].log.quiet = true;
    rig[0].raw.quiet = true;
    ChainStage stage =
        rig[0].chain.add("dawdler", filter(packet -> rig[0].clock.advance(5_000_000)));
    rig[0].runUntil(2_000_000_000);
    PlayerStatus status = rig[0].engine.status();
    assertTrue(status.late());
    assertEquals(0.75, status.sourceShare(), 0.02);
    assertTrue(status.sourceIsSlowest());
    rig[0].chain.remove(stage);
    rig[0].chain.add("worse", filter(packet -> rig[0].clock.advance(35_000_000)));
    rig[0].runUntil(4_000_000_000L);
    status = rig[0].engine.status();
    assertTrue(status.late());
    assertEquals(0.3, status.sourceShare(), 0.02);
    assertFalse(status.sourceIsSlowest());
    rig[0].ask(new PlaybackCommand.Play(false));
    assertEquals(0, rig[0].engine.status().sourceShare());
  }

  @Test
  void achievedSpeedIsMeasured() throws IOException {
    long[] times = LongStream.range(0, 4_000).map(i -> i * 1000).toArray();
    RecordingPlayable playable = new RecordingPlayable(new MemoryRecording(SENSOR, events(times)));
    EngineRig rig = new EngineRig(playable, byTime(10_000).withSpeed(2));
    rig.log.quiet = true;
    rig.runUntil(1_200_000_000);
    assertEquals(2, rig.engine.status().achievedSpeed(), 0.02);
    assertEquals(1000, rig.engine.status().eventRateEps(), 10);
    assertEquals(0, rig.engine.status().lagUs());
    rig.chain.add("dawdler", filter(packet -> rig.clock.advance(20_000_000)));
    rig.runUntil(3_000_000_000L);
    assertEquals(0.5, rig.engine.status().achievedSpeed(), 0.02);
    assertEquals(2, rig.engine.status().speed());
    rig.ask(new PlaybackCommand.Play(false));
    assertEquals(0, rig.engine.status().achievedSpeed());
  }

  @Test
  void unlimitedSpeedNeverWaits() throws IOException {
    EngineRig rig =
        new EngineRig(recording(even(5000)), byTime(20).withSpeed(Double.POSITIVE_INFINITY));
    rig.run();
    assertEquals(0, rig.clock.getAsLong());
    assertEquals(5000, rig.log.events);
    assertEquals(0, rig.engine.status().lagUs());
  }

  @Test
  void commandIsAppliedWithinALongSlice() throws IOException {
    long[] times = LongStream.range(0, 100_000).toArray();
    EngineRig rig =
        new EngineRig(
            new RecordingPlayable(new MemoryRecording(SENSOR, () -> 100_000, events(times))),
            byTime(1_000_000));
    int[] largest = new int[1];
    rig.chain.add("size", filter(packet -> largest[0] = Math.max(largest[0], packet.size())));
    rig.engine.turn();
    rig.engine.turn();
    rig.ask(new PlaybackCommand.Play(false));
    assertTrue(rig.log.events > 0 && rig.log.events <= 2 * PlaybackEngine.CHUNK_EVENTS);
    assertEquals(PlayerStatus.State.PAUSED, rig.engine.status().state());
    rig.run();
    assertEquals(PlaybackEngine.CHUNK_EVENTS, largest[0]);
    assertEquals(100_000, rig.log.events);
    assertEquals(1, rig.log.slices);
  }

  @Test
  void newSpeedAppliesToAWaitingSlice() throws IOException {
    EngineRig rig = new EngineRig(recording(events(0, 100, 200)), byTime(100).withSpeed(1e-4));
    rig.runUntil(500_000_000);
    assertEquals(1, rig.log.slices);
    rig.ask(new PlaybackCommand.SetSpeed(1));
    rig.runUntil(500_060_000);
    assertEquals(2, rig.log.slices);
  }

  @Test
  void changingFromUnlimitedSpeedContinuesWithoutAWait() throws IOException {
    EngineRig rig =
        new EngineRig(recording(even(5000)), byTime(20).withSpeed(Double.POSITIVE_INFINITY));
    while (rig.log.slices < 100) {
      rig.engine.turn();
    }
    rig.ask(new PlaybackCommand.SetSpeed(0.01));
    long before = rig.clock.getAsLong();
    long slices = rig.log.slices;
    rig.runUntil(before + 3 * 20_000_000 / 10);
    assertEquals(0, rig.engine.status().lagUs());
    assertEquals(3, rig.log.slices - slices, 1);
  }
}
