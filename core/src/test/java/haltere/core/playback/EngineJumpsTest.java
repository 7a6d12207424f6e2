package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.even;
import static haltere.core.playback.EngineRig.events;
import static haltere.core.playback.EngineRig.recording;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Notifications of jumps, restarts and losses. */
class EngineJumpsTest {
  @Test
  void clockRestartEndsTheSlice() throws IOException {
    EngineRig rig = new EngineRig(recording(events(100, 150), events(20, 90)), byTime(60)).run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[100,151) [100, 150]",
            "Reset CLOCK_RESTARTED",
            "[20,80) [20]",
            "[80,91) [90]",
            "EndOfStream"),
        rig.log.take());
    assertEquals(122, rig.engine.status().elapsedUs());
    assertEquals(122, rig.engine.status().durationUs());
  }

  @Test
  void dataLossEndsTheSliceAndTheNextOneKeepsTheGrid() throws IOException {
    MemoryRecording lossy = new MemoryRecording(SENSOR, events(100, 110, 170, 260)).losing(2, 77);
    EngineRig rig = new EngineRig(new RecordingPlayable(lossy), byTime(100)).run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[100,111) [100, 110]",
            "DataLost 77",
            "[111,200) [170]",
            "[200,261) [260]",
            "EndOfStream"),
        rig.log.take());
    assertEquals(77, rig.engine.status().droppedEvents());
  }

  @Test
  void jumpsSendOneNotificationBeforeTheirPackets() throws IOException {
    EngineRig rig = new EngineRig(recording(even(20)), byTime(20).withPaused(true)).run();
    rig.ask(new PlaybackCommand.Seek(100));
    rig.run();
    rig.ask(new PlaybackCommand.Rewind());
    rig.run();
    rig.ask(new PlaybackCommand.UserReset());
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    List<String> expected =
        List.of(
            "StreamStarted",
            "[1000,1020) [1000, 1010]",
            "Reset SEEK",
            "[1100,1120) [1100, 1110]",
            "Reset REWIND",
            "[1000,1020) [1000, 1010]",
            "Reset USER",
            "[1020,1040) [1020, 1030]");
    assertEquals(expected, rig.log.take());
    assertEquals(expected, rig.raw.take());
    assertEquals(
        List.of(
            "StreamStarted",
            "1000",
            "1010",
            "Reset SEEK",
            "1100",
            "1110",
            "Reset REWIND",
            "1000",
            "1010",
            "Reset USER",
            "1020",
            "1030"),
        rig.told);
  }

  @Test
  void successiveJumpsWithoutPlaybackAreOne() throws IOException {
    EngineRig rig = new EngineRig(recording(even(20)), byTime(20).withPaused(true)).run();
    rig.ask(new PlaybackCommand.Seek(100));
    rig.ask(new PlaybackCommand.Rewind());
    rig.ask(new PlaybackCommand.Seek(60));
    rig.ask(new PlaybackCommand.UserReset());
    rig.run();
    assertEquals(
        List.of(
            "StreamStarted", "[1000,1020) [1000, 1010]", "Reset SEEK", "[1060,1080) [1060, 1070]"),
        rig.log.take());
  }

  @Test
  void resetsStateTheTimesBeforeAndAfter() throws IOException {
    List<StreamNotification> seen = new ArrayList<>();
    EngineRig rig = new EngineRig(recording(even(20)), byTime(20).withPaused(true)).run();
    rig.ask(new PlaybackCommand.AddSink(noting(seen), false));
    rig.ask(new PlaybackCommand.Seek(95));
    rig.run();
    assertEquals(
        List.of(
            new haltere.core.stream.StreamStarted(SENSOR, "memory"),
            new haltere.core.stream.Reset(haltere.core.stream.Reset.Cause.SEEK, 1010, 1100)),
        seen);
  }

  @Test
  void jumpWithinASliceEndsIt() throws IOException {
    EngineRig rig =
        new EngineRig(recording(even(20)), byTime(100).withSpeed(Double.POSITIVE_INFINITY));
    assertEquals(0, rig.engine.turn());
    assertEquals(0, rig.engine.turn());
    rig.ask(new PlaybackCommand.UserReset());
    assertEquals(0, rig.engine.turn());
    rig.ask(new PlaybackCommand.Seek(150));
    rig.run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[1000,1011) [1000, 1010]",
            "Reset USER",
            "[1011,1031) [1020, 1030]",
            "Reset SEEK",
            "[1150,1191) [1150, 1160, 1170, 1180, 1190]",
            "EndOfStream"),
        rig.log.take());
  }

  @Test
  void jumpAfterTheEndRestartsTheStream() throws IOException {
    EngineRig rig = new EngineRig(recording(even(3)), byTime(100)).run();
    assertEquals(State.ENDED, rig.engine.status().state());
    rig.ask(new PlaybackCommand.Seek(10));
    rig.run();
    assertEquals(State.PAUSED, rig.engine.status().state());
    rig.ask(new PlaybackCommand.Play(true));
    rig.run();
    rig.ask(new PlaybackCommand.Play(true));
    rig.run();
    assertEquals(
        List.of(
            "StreamStarted",
            "[1000,1021) [1000, 1010, 1020]",
            "EndOfStream",
            "StreamStarted",
            "[1010,1021) [1010, 1020]",
            "EndOfStream",
            "StreamStarted",
            "[1000,1021) [1000, 1010, 1020]",
            "EndOfStream"),
        rig.log.take());
  }

  @Test
  void closingEndsTheStream() throws IOException {
    MemoryRecording memory = new MemoryRecording(SENSOR, even(10));
    EngineRig rig = new EngineRig(new RecordingPlayable(memory), byTime(20).withPaused(true)).run();
    rig.engine.close();
    assertEquals(
        List.of("StreamStarted", "[1000,1020) [1000, 1010]", "EndOfStream"), rig.log.take());
    assertTrue(memory.closed());
  }

  private static StreamHandler noting(List<StreamNotification> seen) {
    return new StreamHandler() {
      @Override
      public void packet(EventPacket packet) {}

      @Override
      public void notified(StreamNotification notification) {
        seen.add(notification);
      }
    };
  }
}
