package haltere.core.playback;

import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.even;
import static haltere.core.playback.EngineRig.events;
import static haltere.core.playback.EngineRig.recording;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.playback.PlayerStatus.State;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

/** Steps forward and back, and pauses. */
class EngineStepsTest {
  private static final String SLICE = "[1100,1120) [1100, 1110]";

  @Test
  void stepsForwardAndBackShowTheSameSlices() throws IOException {
    EngineRig rig = new EngineRig(recording(even(20)), byTime(20).withPaused(true)).run();
    CompletableFuture<Void> forward = rig.ask(new PlaybackCommand.Step(3));
    assertFalse(forward.isDone());
    rig.run();
    assertTrue(forward.isDone());
    rig.log.take();
    rig.ask(new PlaybackCommand.Step(-2));
    rig.run();
    assertEquals(List.of("Reset SEEK", "[1020,1040) [1020, 1030]"), rig.log.take());
    assertEquals(20, rig.engine.status().elapsedUs());
    rig.ask(new PlaybackCommand.Step(-9));
    rig.run();
    assertEquals(List.of("Reset SEEK", "[1000,1020) [1000, 1010]"), rig.log.take());
    assertEquals(0, rig.clock.getAsLong());
  }

  @Test
  void stepBackRunsTheChainOverItsMemory() throws IOException {
    EngineRig rig = new EngineRig(recording(even(20)), byTime(20).withPaused(true), 40).run();
    rig.ask(new PlaybackCommand.Seek(120));
    rig.run();
    rig.log.take();
    rig.raw.take();
    rig.told.clear();
    rig.ask(new PlaybackCommand.Step(-1));
    rig.run();
    List<String> shown = List.of("Reset SEEK", "run-up [1060, 1070, 1080, 1090]", SLICE);
    assertEquals(shown, rig.log.take());
    assertEquals(shown, rig.raw.take());
    assertEquals(List.of("Reset SEEK", "1060", "1070", "1080", "1090", "1100", "1110"), rig.told);
    assertEquals(8, rig.engine.counters().get(Counter.EVENTS_RUN_UP));
  }

  @Test
  void stepsByCountAreReversibleAmongSimultaneousEvents() throws IOException {
    long[] times = new Random(7).longs(500, 0, 200).sorted().toArray();
    EngineRig rig =
        new EngineRig(
                recording(events(times)),
                PlayerOptions.defaults().withSlicing(new Slicing.ByCount(9)).withPaused(true))
            .run();
    List<String> forward = new ArrayList<>(rig.log.take().subList(1, 2));
    for (int i = 0; i < 20; i++) {
      rig.ask(new PlaybackCommand.Step(1));
      rig.run();
      forward.addAll(rig.log.take());
    }
    for (int i = 19; i >= 1; i--) {
      rig.ask(new PlaybackCommand.Step(-1));
      rig.run();
      List<String> shown = new ArrayList<>(rig.log.take());
      shown.removeIf(line -> line.startsWith("run-up"));
      assertEquals(List.of("Reset SEEK", forward.get(i)), shown);
    }
    rig.ask(new PlaybackCommand.Step(3));
    rig.run();
    assertEquals(forward.subList(2, 5), rig.log.take());
  }

  @Test
  void stepBackFromTheEndRestartsTheStream() throws IOException {
    EngineRig rig = new EngineRig(recording(even(6)), byTime(20)).run();
    rig.log.take();
    rig.ask(new PlaybackCommand.Step(-1));
    rig.run();
    assertEquals(List.of("StreamStarted", "[1020,1040) [1020, 1030]"), rig.log.take());
    assertEquals(State.PAUSED, rig.engine.status().state());
  }

  @Test
  void playContinuesAtThePositionOfAPause() throws IOException {
    EngineRig rig = new EngineRig(recording(even(100)), byTime(100));
    rig.runUntil(250_000);
    assertEquals(3, rig.log.slices);
    rig.ask(new PlaybackCommand.Toggle());
    rig.runUntil(10_000_000);
    rig.clock.advance(10_000_000);
    assertEquals(3, rig.log.slices);
    assertEquals(State.PAUSED, rig.engine.status().state());
    rig.ask(new PlaybackCommand.Toggle());
    rig.runUntil(rig.clock.getAsLong() + 49_000);
    assertEquals(3, rig.log.slices);
    rig.runUntil(rig.clock.getAsLong() + 2_000);
    assertEquals(4, rig.log.slices);
    assertEquals(300, rig.engine.status().elapsedUs());
  }
}
