package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.even;
import static haltere.core.playback.EngineRig.filter;
import static haltere.core.playback.EngineRig.recording;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.ChainStage;
import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.Test;

/** Playback after a failure of a filter, a sink or a source. */
class EngineFailuresTest {
  @Test
  void throwingFiltersAreDisabledAndPlaybackContinues() throws IOException {
    EngineRig rig = new EngineRig(recording(even(8)), byTime(20));
    ChainStage broken =
        rig.chain.add(
            "broken",
            filter(
                packet -> {
                  if (packet.firstTimeUs() >= 1040) {
                    throw new IllegalStateException("no such pixel\nand more");
                  }
                }));
    rig.run();
    assertFalse(broken.isEnabled());
    assertEquals(
        "filter broken failed: java.lang.IllegalStateException: no such pixel; it is switched off",
        rig.engine.status().message());
    assertEquals(2, rig.engine.status().droppedEvents());
    assertEquals(6, rig.engine.status().eventsOut());
    assertEquals(0, rig.engine.counters().unaccountedEvents());
    assertEquals(
        List.of(
            "StreamStarted",
            "[1000,1020) [1000, 1010]",
            "[1020,1040) [1020, 1030]",
            "DataLost 2",
            "[1040,1060) []",
            "[1060,1071) [1060, 1070]",
            "EndOfStream"),
        rig.log.take());
  }

  @Test
  void filterWithAMissingLibraryIsDisabledAndAnsweredAgainWhenItFailsAgain() throws IOException {
    EngineRig rig = new EngineRig(recording(even(8)), byTime(20));
    ChainStage broken =
        rig.chain.add(
            "broken",
            filter(
                packet -> {
                  throw new NoClassDefFoundError("org/example/Missing");
                }));
    rig.run();
    assertFalse(broken.isEnabled());
    assertEquals(1, rig.engine.status().failures());
    String message = rig.engine.status().message();
    assertEquals(
        "filter broken failed: java.lang.NoClassDefFoundError: org/example/Missing;"
            + " it is switched off",
        message);
    rig.ask(new PlaybackCommand.Edit(chain -> chain.setEnabled(broken, true), false));
    rig.ask(new PlaybackCommand.Rewind());
    rig.run();
    assertEquals(message, rig.engine.status().message());
    assertEquals(2, rig.engine.status().failures());
  }

  @Test
  void changeThatFailsForALibraryEndsWithThatError() throws IOException {
    EngineRig rig = new EngineRig(recording(even(8)), byTime(20));
    CompletableFuture<Void> edit =
        rig.ask(
            new PlaybackCommand.Edit(
                chain -> {
                  throw new NoClassDefFoundError("org/example/Missing");
                },
                false));
    assertThrows(CompletionException.class, edit::join);
    rig.run();
    assertEquals(8, rig.log.events);
  }

  @Test
  void notificationsReachAllFiltersDespiteAnException() throws IOException {
    EngineRig rig = new EngineRig(recording(even(8)), byTime(20).withPaused(true)).run();
    List<String> heard = new ArrayList<>();
    rig.chain.add(
        "deaf",
        new EventFilter() {
          @Override
          public void process(EventPacket packet) {}

          @Override
          public void reset() {
            throw new IllegalStateException("cannot forget");
          }
        });
    rig.chain.add(
        "after",
        new EventFilter() {
          @Override
          public void process(EventPacket packet) {}

          @Override
          public void reset() {
            heard.add("reset");
          }
        });
    rig.ask(new PlaybackCommand.UserReset());
    assertEquals(List.of("reset"), heard);
    assertFalse(rig.chain.stage("deaf").isEnabled());
    assertTrue(rig.engine.status().message().contains("cannot forget"));
  }

  @Test
  void throwingSinksAreRemovedAndOthersContinue() throws IOException {
    EngineRig rig = new EngineRig(recording(even(8)), byTime(20));
    rig.ask(
        new PlaybackCommand.AddSink(
            new StreamHandler() {
              @Override
              public void packet(EventPacket packet) {
                throw new java.io.UncheckedIOException(new IOException("disk full"));
              }

              @Override
              public void notified(StreamNotification notification) {}
            },
            false));
    rig.run();
    assertTrue(rig.engine.status().message().contains("disk full"));
    assertEquals(8, rig.log.events);
    assertEquals(1, rig.engine.counters().get(Counter.SINK_FAILURES));
  }

  @Test
  void readFailuresEndTheStreamWithAMessage() throws IOException {
    MemoryRecording bad = new MemoryRecording(SENSOR, () -> 2, even(8)).failingAt(1045);
    EngineRig rig = new EngineRig(new RecordingPlayable(bad), byTime(20)).run();
    assertEquals(State.FAILED, rig.engine.status().state());
    assertEquals("memory: the disk is gone; plug it in again", rig.engine.status().message());
    List<String> lines = rig.log.take();
    assertEquals("EndOfStream", lines.get(lines.size() - 1));
    assertEquals(4, rig.log.events);
    rig.ask(new PlaybackCommand.Rewind());
    rig.run();
    assertEquals(List.of("StreamStarted", "[1000,1020) [1000, 1010]"), rig.log.take());
  }

  @Test
  void throwingEditsDoNotAffectOthers() throws IOException {
    EngineRig rig = new EngineRig(recording(even(8)), byTime(20));
    CompletableFuture<Void> edit =
        rig.ask(new PlaybackCommand.Edit(chain -> chain.stage("none"), false));
    assertThrows(CompletionException.class, edit::join);
    assertTrue(rig.engine.status().message().contains("no stage named none"));
    rig.run();
    assertEquals(8, rig.log.events);
  }

  @Test
  void chainForAnotherSensorIsRejected() throws IOException {
    RecordingPlayable playable = recording(even(8));
    assertThrows(
        IllegalArgumentException.class,
        () ->
            new PlaybackEngine(
                playable,
                new haltere.core.chain.FilterChain(new SensorGeometry(8, 8)),
                PlayerOptions.defaults()));
  }

  @Test
  void eventsOutsideTheSensorAreCountedAsDropped() throws IOException {
    EventPacket packet = even(3);
    packet.append(1100, 15, 16, true);
    EngineRig rig = new EngineRig(recording(packet), byTime(20));
    rig.ask(new PlaybackCommand.RemoveSink(rig.raw));
    rig.run();
    assertEquals(1, rig.engine.status().droppedEvents());
    assertEquals(0, rig.engine.counters().unaccountedEvents());
  }
}
