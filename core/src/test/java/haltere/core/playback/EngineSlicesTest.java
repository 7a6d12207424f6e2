package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.even;
import static haltere.core.playback.EngineRig.events;
import static haltere.core.playback.EngineRig.recording;
import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.event.EventPacket;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Division of the stream into slices. */
class EngineSlicesTest {
  @Test
  void slicesOfTimeAreHalfOpenAndContinueThroughSilence() throws IOException {
    EngineRig rig = new EngineRig(recording(events(100, 119, 120, 121, 185)), byTime(20)).run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[100,120) [100, 119]",
            "[120,140) [120, 121]",
            "[140,160) []",
            "[160,180) []",
            "[180,186) [185]",
            "EndOfStream"),
        rig.log.take());
  }

  @Test
  void slicesByCountContainExactlyTheirCount() throws IOException {
    EngineRig rig =
        new EngineRig(
                recording(events(10, 20, 20, 20, 90, 91, 92)),
                PlayerOptions.defaults().withSlicing(new Slicing.ByCount(3)))
            .run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[10,21) [10, 20, 20]",
            "[20,92) [20, 90, 91]",
            "[92,93) [92]",
            "EndOfStream"),
        rig.log.take());
  }

  @Test
  void slicesDoNotDependOnThePacketsOfTheSource() throws IOException {
    Random random = new Random(42);
    EventPacket packet = new EventPacket(0);
    long timeUs = 0;
    for (int i = 0; i < 30_000; i++) {
      timeUs += random.nextInt(10) == 0 ? random.nextInt(300) : random.nextInt(3);
      packet.append(timeUs, 1, 1, true);
    }
    for (Slicing slicing : List.of(new Slicing.ByTime(977), new Slicing.ByCount(7001))) {
      List<String> expected = null;
      for (int bound : new int[] {1, 50, 9000, 100_000}) {
        MemoryRecording cut =
            new MemoryRecording(SENSOR, () -> random.nextInt(bound + 1) + bound / 100, packet);
        EngineRig rig =
            new EngineRig(
                    new RecordingPlayable(cut),
                    PlayerOptions.defaults()
                        .withSlicing(slicing)
                        .withSpeed(Double.POSITIVE_INFINITY))
                .run();
        List<String> lines = rig.log.take();
        expected = expected == null ? lines : expected;
        assertEquals(expected, lines);
        assertEquals(30_000, rig.log.events);
        assertEquals(rig.log.times, rig.raw.times);
      }
    }
  }

  @Test
  void slicePerPictureFollowsTheSpeed() throws IOException {
    EngineRig rig =
        new EngineRig(
            recording(even(10_000)),
            PlayerOptions.defaults().withSlicing(new Slicing.PerFrame(50)).withSpeed(0.001));
    rig.runUntil(99_000_000);
    assertEquals(5, rig.log.slices);
    assertEquals(20, rig.engine.status().sliceUs());
    rig.ask(new PlaybackCommand.SetSpeed(0.1));
    rig.runUntil(199_000_000);
    assertEquals(2000, rig.engine.status().sliceUs());
    assertEquals(10, rig.log.slices, 1);
  }

  @Test
  void slowestSpeedShowsOneMicrosecondAtATime() throws IOException {
    EngineRig rig =
        new EngineRig(
                recording(events(5, 6, 7, 9)),
                PlayerOptions.defaults().withSlicing(new Slicing.PerFrame(100)).withSpeed(1e-4))
            .run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[5,6) [5]",
            "[6,7) [6]",
            "[7,8) [7]",
            "[8,9) []",
            "[9,10) [9]",
            "EndOfStream"),
        rig.log.take());
    assertEquals(40_000_000, rig.clock.getAsLong());
  }
}
