package haltere.core.playback;

import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.even;
import static haltere.core.playback.EngineRig.events;
import static haltere.core.playback.EngineRig.recording;
import static org.junit.jupiter.api.Assertions.assertEquals;

import haltere.core.playback.PlayerStatus.State;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Playback at the ends of loops. */
class EngineLoopsTest {
  @Test
  void loopRewindsFromItsOutPointToItsInPoint() throws IOException {
    EngineRig rig = new EngineRig(recording(even(20)), byTime(20).withLoop(Loop.between(50, 80)));
    rig.runUntil(149_000);
    assertEquals(
        List.of(
            "StreamStarted",
            "[1000,1020) [1000, 1010]",
            "[1020,1040) [1020, 1030]",
            "[1040,1060) [1040, 1050]",
            "[1060,1080) [1060, 1070]",
            "Reset REWIND",
            "[1050,1070) [1050, 1060]",
            "[1070,1080) [1070]",
            "Reset REWIND",
            "[1050,1070) [1050, 1060]",
            "[1070,1080) [1070]",
            "Reset REWIND"),
        rig.log.take().subList(0, 12));
  }

  @Test
  void fullLoopsNeverSendAnEnd() throws IOException {
    EngineRig rig = new EngineRig(recording(even(3)), byTime(100).withLoop(Loop.ALL));
    rig.runUntil(43_000);
    assertEquals(
        List.of(
            "StreamStarted",
            "[1000,1021) [1000, 1010, 1020]",
            "Reset REWIND",
            "[1000,1021) [1000, 1010, 1020]",
            "Reset REWIND",
            "[1000,1021) [1000, 1010, 1020]"),
        rig.log.take().subList(0, 6));
  }

  @Test
  void loopKeepsItsPaceOverManyRounds() throws IOException {
    EngineRig rig = new EngineRig(recording(even(101)), byTime(7).withLoop(Loop.between(100, 900)));
    rig.log.quiet = true;
    rig.raw.quiet = true;
    rig.runUntil(100_000L + 1000 * 800_000);
    // 80 events a round.
    assertEquals(90 + 80 * 999, rig.log.events, 80);
  }

  @Test
  void playbackBehindTheOutPointContinuesToTheEnd() throws IOException {
    EngineRig rig =
        new EngineRig(
            recording(even(6)), byTime(20).withPaused(true).withLoop(Loop.between(0, 20)));
    rig.run();
    rig.ask(new PlaybackCommand.Seek(40));
    rig.ask(new PlaybackCommand.Step(2));
    rig.run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[1000,1020) [1000, 1010]",
            "Reset SEEK",
            "[1040,1051) [1040, 1050]",
            "Reset REWIND",
            "[1000,1020) [1000, 1010]",
            "Reset REWIND",
            "[1000,1020) [1000, 1010]"),
        rig.log.take());
  }

  @Test
  void outPointBehindTheDisplayedSliceStartsTheLoop() throws IOException {
    EngineRig rig = new EngineRig(recording(even(6)), byTime(20).withPaused(true));
    rig.run();
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    rig.log.take();
    rig.ask(new PlaybackCommand.SetLoop(Loop.between(10, 40)));
    rig.ask(new PlaybackCommand.Step(2));
    rig.run();
    assertEquals(
        List.of("Reset REWIND", "[1010,1030) [1010, 1020]", "[1030,1040) [1030]"), rig.log.take());
  }

  @Test
  void loopWithoutEventsEnds() throws IOException {
    EngineRig rig = new EngineRig(recording(), byTime(20).withLoop(Loop.ALL)).run();
    assertEquals(List.of("StreamStarted", "EndOfStream"), rig.log.take());
    assertEquals(State.ENDED, rig.engine.status().state());
  }

  @Test
  void loopByCountThroughSilenceTakesItsTime() throws IOException {
    EngineRig rig =
        new EngineRig(
            recording(events(0, 10, 1_000_000)),
            PlayerOptions.defaults()
                .withSlicing(new Slicing.ByCount(2))
                .withLoop(Loop.between(100, 500)));
    rig.runUntil(2_000_000);
    assertEquals(5, rig.log.slices, 1);
  }
}
