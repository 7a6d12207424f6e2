package haltere.testing.playback;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.format.RecordingReader;
import haltere.core.pipeline.Pipeline;
import haltere.core.pipeline.PipelineCounters;
import haltere.core.playback.Loop;
import haltere.core.playback.Player;
import haltere.core.playback.PlayerOptions;
import haltere.core.playback.PlayerStatus;
import haltere.core.playback.RecordingPlayable;
import haltere.core.playback.ScenePlayable;
import haltere.core.playback.SliceSink;
import haltere.core.playback.Slicing;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamGrammar;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.RecordedPackets;
import java.io.IOException;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The player on recordings and scenes. */
@Timeout(60)
class RealSourcesTest {
  /** Order-sensitive digest of all events, with the grammar checked on the way. */
  private static class Digest implements StreamHandler {
    final CountDownLatch ended = new CountDownLatch(1);
    long events;
    long digest;

    @Override
    public void packet(EventPacket packet) {
      events += packet.size();
      for (int i = 0; i < packet.size(); i++) {
        digest = 31 * (31 * digest + packet.timeUs(i)) + packet.address(i);
      }
    }

    @Override
    public void notified(StreamNotification notification) {
      if (notification instanceof EndOfStream) {
        ended.countDown();
      }
    }
  }

  private static PlayerOptions fast(Slicing slicing) {
    return PlayerOptions.defaults().withSlicing(slicing).withSpeed(Double.POSITIVE_INFINITY);
  }

  @Test
  void playbackInSlicesYieldsAllEventsOfTheRecording() throws Exception {
    for (RecordedPackets recorded :
        List.of(RecordedPackets.WALKING, RecordedPackets.ROTATING_BAR)) {
      Digest plain = new Digest();
      FilterChain chain;
      try (RecordingReader reader = recorded.open()) {
        chain = new FilterChain(reader.geometry());
        Pipeline.run(reader, chain, List.of(plain), new PipelineCounters());
      }
      for (Slicing slicing : List.of(new Slicing.ByTime(5_000), new Slicing.ByCount(777))) {
        Digest played = new Digest();
        try (Player player =
            new Player(new RecordingPlayable(recorded.open()), chain, fast(slicing))) {
          player.addSink(new StreamGrammar(played));
          player.start();
          played.ended.await();
          PlayerStatus status = player.status();
          assertEquals("", status.message());
          assertEquals(status.durationUs(), status.elapsedUs());
        }
        assertEquals(plain.events, played.events);
        assertEquals(plain.digest, played.digest);
      }
    }
  }

  @Test
  void seekContinuesAtTheGivenTime() throws IOException {
    RecordingPlayable playable = new RecordingPlayable(RecordedPackets.WALKING.open());
    FilterChain chain = new FilterChain(playable.geometry());
    long duration = playable.durationUs().orElseThrow();
    long[] first = {-1};
    try (Player player =
        new Player(playable, chain, fast(new Slicing.ByTime(10_000)).withPaused(true))) {
      player.addSink(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              if (first[0] < 0) {
                first[0] = packet.firstTimeUs();
              }
            }

            @Override
            public void notified(StreamNotification notification) {
              first[0] = -1;
            }
          });
      player.start().join();
      for (int percent : new int[] {50, 10, 99, 0, 75}) {
        player.seek(duration * percent / 100).join();
        PlayerStatus status = player.status();
        assertEquals(duration * percent / 100, status.elapsedUs());
        assertTrue(
            first[0] >= status.timeUs() && first[0] < status.timeUs() + 10_000,
            first[0] + " us at " + status);
      }
    }
  }

  @Test
  void loopedSceneRepeatsTheSameEvents() throws Exception {
    CountDownLatch thrice = new CountDownLatch(3);
    Digest[] rounds = {new Digest()};
    long[] digests = new long[4];
    int[] round = {0};
    ScenePlayable scene = new ScenePlayable(() -> new FlyScene(FlySceneSettings.defaults()), "fly");
    FilterChain chain = new FilterChain(scene.geometry());
    try (Player player =
        new Player(
            scene, chain, fast(new Slicing.ByTime(1_000)).withLoop(Loop.between(0, 50_000)))) {
      player.addSink(
          new SliceSink() {
            @Override
            public void packet(EventPacket packet) {
              rounds[0].packet(packet);
            }

            @Override
            public void notified(StreamNotification notification) {
              if (notification instanceof Reset reset
                  && reset.cause() == Reset.Cause.REWIND
                  && round[0] < 3) {
                digests[round[0]++] = rounds[0].digest;
                rounds[0] = new Digest();
                thrice.countDown();
              }
            }

            @Override
            public void sliceEnd(long fromUs, long toUs) {}
          });
      player.start();
      thrice.await();
    }
    assertTrue(digests[0] != 0);
    assertEquals(digests[0], digests[1]);
    assertEquals(digests[0], digests[2]);
  }
}
