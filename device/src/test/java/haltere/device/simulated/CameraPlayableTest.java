package haltere.device.simulated;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.camera.CameraOptions;
import haltere.core.camera.Cameras;
import haltere.core.camera.TimestampReset;
import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.playback.CameraPlayable;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.DeviceLost;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.ManualClock;
import haltere.testing.StreamRecorder;
import haltere.testing.Waiting;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.ExecutionException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(60)
class CameraPlayableTest {
  private static final long MS = 1_000_000;

  private final ManualClock time = new ManualClock();
  private final Cameras cameras =
      new Cameras(List.of(new SimulatedCameraProvider(time, () -> time)));
  private final StreamRecorder recorder = new StreamRecorder();
  private final StreamGrammar stream = new StreamGrammar(recorder);

  private CameraPlayable fly(boolean reconnects) throws IOException {
    return new CameraPlayable(
        cameras.open("simulated:fly", CameraOptions.DEFAULT.withReconnect(reconnects)), reconnects);
  }

  private void pull(CameraPlayable playable, long ms) throws IOException {
    long until = time.getAsLong() + ms * MS;
    while (time.getAsLong() < until) {
      playable.next(stream);
    }
  }

  @Test
  void cameraIsLiveEndlessAndNotSeekable() throws IOException {
    try (CameraPlayable playable = fly(true)) {
      assertTrue(playable.isLive());
      assertTrue(playable.durationUs().isEmpty());
      assertFalse(playable.seekable());
      assertEquals("simulated:fly", playable.name());
      String said = assertThrows(IOException.class, () -> playable.seek(5)).getMessage();
      assertTrue(said.contains("cannot be played again"), said);
    }
  }

  @Test
  void timelineContinuesAcrossRestartsOfTheCameraClock() throws IOException {
    try (CameraPlayable playable = fly(true)) {
      long[] lastElapsed = {-1};
      StreamHandler ascending =
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              stream.packet(packet);
              if (!packet.isEmpty()) {
                long elapsed = playable.elapsedUs(packet.timeUs(0));
                assertTrue(elapsed >= lastElapsed[0]);
                lastElapsed[0] = playable.elapsedUs(packet.lastTimeUs());
              }
            }

            @Override
            public void notified(StreamNotification notification) {
              stream.notified(notification);
            }
          };
      Plug plug = playable.camera().facet(Plug.class).orElseThrow();
      for (int part = 0; part < 3; part++) {
        long until = time.getAsLong() + 20 * MS;
        while (time.getAsLong() < until) {
          playable.next(ascending);
        }
        plug.unplug();
        while (!playable.isUnplugged()) {
          playable.next(ascending);
        }
        // the player is not kept waiting while the camera is away
        for (int i = 0; i < 10; i++) {
          assertTrue(playable.next(ascending));
        }
        assertTrue(playable.isUnplugged());
        plug.plugIn();
      }
      pull(playable, 20);
      assertFalse(playable.isUnplugged());
      playable.camera().facet(TimestampReset.class).orElseThrow().resetTimestamps();
      pull(playable, 20);
      assertEquals(4, recorder.notifications(Reset.class).size());
      assertTrue(recorder.notifications(DeviceLost.class).isEmpty(), "it is one session");
      assertTrue(lastElapsed[0] > 55_000 && lastElapsed[0] < 70_000);
    }
  }

  @Test
  void unpluggingEndsTheStreamWithoutReconnect() throws IOException {
    try (CameraPlayable playable = fly(false)) {
      pull(playable, 10);
      playable.camera().facet(Plug.class).orElseThrow().unplug();
      while (playable.next(stream)) {
        // to the end
      }
      assertTrue(stream.ended());
      assertEquals(1, recorder.notifications(DeviceLost.class).size());
    }
  }

  @Test
  void playerPlaysALiveCameraAndRejectsASpeed() throws Exception {
    // in real time, because the player and the camera wait on their own threads
    Cameras real = new Cameras(List.of(new SimulatedCameraProvider()));
    CameraPlayable playable =
        new CameraPlayable(
            real.open("simulated:fly", CameraOptions.DEFAULT.withReconnect(true)), true);
    FilterChain chain = new FilterChain(playable.geometry());
    try (Player player = new Player(playable, chain, PlayerOptions.defaults())) {
      player.start().get();
      waitForEvents(player, 2000);
      ExecutionException refused =
          assertThrows(ExecutionException.class, () -> player.setSpeed(0.5).get());
      assertTrue(refused.getCause().getMessage().contains("its speed cannot be changed"));
      assertEquals("", player.status().message());
      player.pause().get();
      assertEquals(State.PAUSED, player.status().state());
      player.play().get();
      playable.camera().facet(Plug.class).orElseThrow().unplug();
      Waiting.until("the camera to be away", playable::isUnplugged);
      assertEquals(State.PLAYING, player.status().state());
      playable.camera().facet(Plug.class).orElseThrow().plugIn();
      waitForEvents(player, player.status().eventsIn() + 2000);
      assertEquals("", player.status().message());
    }
  }

  private static void waitForEvents(Player player, long events) {
    Waiting.until(events + " events", () -> player.status().eventsIn() >= events);
  }
}
