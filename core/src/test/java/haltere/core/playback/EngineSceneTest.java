package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.events;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.SensorGeometry;
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import java.util.List;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

/** Scenes in the engine. */
class EngineSceneTest {
  @Test
  void scenesRestartOnRewindAndAreNotSeekable() {
    int[] made = new int[1];
    ScenePlayable scene =
        new ScenePlayable(
            () -> {
              made[0]++;
              return endless();
            },
            "dots");
    EngineRig rig = new EngineRig(scene, byTime(20).withPaused(true));
    rig.run();
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    CompletableFuture<Void> seek = rig.ask(new PlaybackCommand.Seek(5));
    assertTrue(seek.isCompletedExceptionally());
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    rig.ask(new PlaybackCommand.Rewind());
    rig.run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[500,520) [500, 510]",
            "[520,540) [520, 530]",
            "[540,560) [540, 550]",
            "Reset REWIND",
            "[500,520) [500, 510]"),
        rig.log.take());
    assertEquals(2, made[0]);
    assertEquals(-1, rig.engine.status().durationUs());
    assertEquals(OptionalLong.empty(), scene.durationUs());
  }

  private static EventSource endless() {
    return new EventSource() {
      private long nextUs = 490;

      @Override
      public SensorGeometry geometry() {
        return SENSOR;
      }

      @Override
      public boolean next(StreamHandler handler) {
        if (nextUs == 490) {
          handler.notified(new haltere.core.stream.StreamStarted(SENSOR, "dots"));
        } else {
          handler.packet(events(nextUs));
        }
        nextUs += 10;
        return true;
      }

      @Override
      public void close() {}
    };
  }
}
