package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.stream.EndOfStream;
import haltere.core.stream.EventSource;
import haltere.core.stream.Reset;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.core.stream.StreamStarted;
import haltere.testing.StreamRecorder;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class BufferedPlayableTest {
  private static final int ROOM = 4 * EventHistory.CHUNK_EVENTS;

  /** One event every 10 us in packets of 100, from 500 us on. */
  private static EventSource endless() {
    return new EventSource() {
      private long nextUs = 500;
      private boolean started;

      @Override
      public SensorGeometry geometry() {
        return SENSOR;
      }

      @Override
      public boolean next(StreamHandler handler) {
        if (!started) {
          started = true;
          handler.notified(new StreamStarted(SENSOR, "dots"));
          return true;
        }
        EventPacket packet = new EventPacket(100);
        for (int i = 0; i < 100; i++, nextUs += 10) {
          packet.append(nextUs, 1, 2, true);
        }
        handler.packet(packet);
        return true;
      }

      @Override
      public void close() {}
    };
  }

  private static BufferedPlayable kept() {
    return new BufferedPlayable(new ScenePlayable(BufferedPlayableTest::endless, "dots"), ROOM);
  }

  private static void pull(Playable playable, StreamHandler handler, long untilUs)
      throws IOException {
    long[] place = {0};
    while (place[0] < untilUs) {
      playable.next(
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              place[0] = playable.elapsedUs(packet.lastTimeUs());
              handler.packet(packet);
            }

            @Override
            public void notified(StreamNotification notification) {
              handler.notified(notification);
            }
          });
    }
  }

  private static List<Long> elapsed(Playable playable) throws IOException {
    List<Long> all = new ArrayList<>();
    StreamRecorder notices = new StreamRecorder();
    while (playable.next(
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            for (int i = 0; i < packet.size(); i++) {
              all.add(playable.elapsedUs(packet.timeUs(i)));
            }
          }

          @Override
          public void notified(StreamNotification notification) {
            notices.notified(notification);
          }
        })) {
      // to the end
    }
    return all;
  }

  @Test
  void storedEventsAreReplayedBeforeNewOnes() throws IOException {
    BufferedPlayable kept = kept();
    StreamRecorder first = new StreamRecorder();
    pull(kept, first, 900_000);
    assertTrue(kept.bufferedFromUs() > 0);
    assertTrue(
        kept.bufferedToUs() - kept.bufferedFromUs() >= 10L * (ROOM - EventHistory.CHUNK_EVENTS));
    long place = kept.nearestUs(700_005);
    assertEquals(700_005, place);
    kept.seek(place);
    EventPacket again = new EventPacket(0);
    pull(
        kept,
        new StreamHandler() {
          @Override
          public void packet(EventPacket packet) {
            again.append(packet, 0, packet.size());
          }

          @Override
          public void notified(StreamNotification notification) {
            assertEquals(new Reset(Reset.Cause.SEEK), notification);
          }
        },
        1_000_000);
    long[] expected = LongStream.range(0, again.size()).map(i -> 500 + 700_010 + 10 * i).toArray();
    for (int i = 0; i < again.size(); i++) {
      assertEquals(expected[i], again.timeUs(i));
    }
    assertTrue(again.size() >= 30_000);
  }

  @Test
  void memoryIsBoundedAndScenesRestartForTheirStart() throws IOException {
    BufferedPlayable kept = kept();
    pull(kept, new StreamRecorder(), 900_000);
    long from = kept.bufferedFromUs();
    assertThrows(IOException.class, () -> kept.seek(from - 1));
    assertEquals(from, kept.nearestUs(5));
    assertEquals(0, kept.nearestUs(0));
    assertEquals(kept.bufferedToUs(), kept.nearestUs(Long.MAX_VALUE));
    kept.seek(0);
    assertEquals(0, kept.bufferedToUs());
    pull(kept, new StreamRecorder(), 1);
    assertEquals(0, kept.bufferedFromUs());
  }

  @Test
  void storedEventsDoNotDependOnPacketBoundaries() throws IOException {
    SplittableRandom random = new SplittableRandom(5);
    EventHistory history = new EventHistory(16 * ROOM);
    List<Long> expected = new ArrayList<>();
    long timeUs = 40;
    while (expected.size() < 3 * EventHistory.CHUNK_EVENTS) {
      EventPacket packet = new EventPacket(16);
      int size = random.nextInt(4000);
      for (int i = 0; i < size; i++) {
        // now and then a silence that is too long for one stretch
        timeUs += random.nextInt(4000) == 0 ? 3_000_000_000L : random.nextInt(5);
        packet.append(timeUs, i % 16, 3, (i & 1) == 0);
        expected.add(timeUs);
      }
      history.append(packet, 60);
    }
    for (int trial = 0; trial < 20; trial++) {
      long place = 100 + random.nextLong(timeUs - 40);
      history.read(place);
      List<Long> read = new ArrayList<>();
      EventPacket piece = new EventPacket(0);
      while (!history.atEnd()) {
        history.next(
            piece,
            offset -> assertEquals(60, offset),
            new StreamHandler() {
              @Override
              public void packet(EventPacket packet) {
                for (int i = 0; i < packet.size(); i++) {
                  read.add(packet.timeUs(i));
                }
              }

              @Override
              public void notified(StreamNotification notification) {}
            });
      }
      assertEquals(expected.stream().filter(time -> time + 60 >= place).toList(), read);
    }
  }

  @Test
  void replayRepeatsClockRestarts() throws IOException {
    Reset restarted = new Reset(Reset.Cause.CLOCK_RESTARTED, 30, 5);
    BufferedPlayable kept =
        new BufferedPlayable(
            new ScriptedPlayable(
                new StreamStarted(SENSOR, "script"),
                EngineRig.events(10, 20, 30),
                restarted,
                EngineRig.events(5, 6),
                new EndOfStream(6)),
            ROOM);
    assertEquals(List.of(0L, 10L, 20L, 21L, 22L), elapsed(kept));
    kept.seek(10);
    StreamRecorder again = new StreamRecorder();
    while (kept.next(again)) {
      // to the end, which comes once more
    }
    assertEquals(1, again.notifications(StreamStarted.class).size());
    assertEquals(List.of(restarted), again.notifications(Reset.class));
    assertEquals(1, again.notifications(EndOfStream.class).size());
  }

  @Test
  void copyContainsOnlyItsPart() throws IOException {
    BufferedPlayable kept = kept();
    pull(kept, new StreamRecorder(), 300_000);
    Playable copy = kept.copy(100_000, 100_100);
    pull(kept, new StreamRecorder(), 900_000);
    assertEquals(
        LongStream.range(0, 10).map(i -> 100_000 + 10 * i).boxed().toList(), elapsed(copy));
    copy.seek(100_055);
    assertEquals(List.of(100_060L, 100_070L, 100_080L, 100_090L), elapsed(copy));
    assertEquals(OptionalLong.of(100_091), copy.durationUs());
    assertEquals(OptionalLong.of(0), kept.copy(5, 6).durationUs());
  }

  @Test
  void sceneIsSteppedAndLoopedLikeARecording() throws IOException {
    EngineRig rig =
        new EngineRig(
            kept(), byTime(1000).withLoop(new Loop(true, OptionalLong.of(2000), at(4000))));
    rig.runUntil(5_500_000);
    rig.ask(new PlaybackCommand.Play(false));
    List<String> slices = rig.log.take();
    assertEquals("[2500,3500)", slices.get(3).substring(0, 11));
    assertEquals("Reset REWIND", slices.get(5));
    assertEquals(slices.get(3), slices.get(6), "the same events again");
    rig.ask(new PlaybackCommand.Step(-1));
    rig.run();
    assertTrue(rig.log.take().get(0).startsWith("Reset SEEK"));
    rig.ask(new PlaybackCommand.Seek(Long.MAX_VALUE));
    rig.run();
    assertTrue(rig.engine.status().elapsedUs() >= 4000);
  }

  private static OptionalLong at(long us) {
    return OptionalLong.of(us);
  }

  /** Packets of two events, one a millisecond. */
  private static List<Object> packets(int fromMs, int toMs) {
    List<Object> items = new ArrayList<>();
    for (int i = fromMs; i < toMs; i++) {
      items.add(EngineRig.events(1000L * i, 1000L * i + 500));
    }
    return items;
  }

  private static BufferedPlayable live(List<Object> items) {
    items.add(0, new StreamStarted(SENSOR, "script"));
    return new BufferedPlayable(new ScriptedPlayable(items.toArray()), ROOM);
  }

  @Test
  void replayOfACameraIsPaced() throws IOException {
    BufferedPlayable kept = live(packets(0, 1000));
    EngineRig rig = new EngineRig(kept, byTime(1000).withSpeed(0.1));
    for (int i = 0; i < 200; i++) {
      assertEquals(0, rig.engine.turn(), "as it comes");
    }
    assertTrue(kept.isLive());
    long newest = rig.engine.status().elapsedUs();
    assertTrue(newest > 10_000);
    rig.ask(new PlaybackCommand.Seek(newest - 5000));
    assertFalse(kept.isLive());
    long before = rig.clock.getAsLong();
    while (rig.engine.status().elapsedUs() < newest - 1000) {
      rig.clock.advance(rig.engine.turn());
    }
    assertEquals(40_000_000, rig.clock.getAsLong() - before, 10_000_000);
  }

  @Test
  void jumpToTheEndOfAPausedCameraShowsWhatHasComeSince() throws IOException {
    List<Object> items = packets(0, 20);
    items.addAll(packets(40, 120));
    EventPacket nothing = new EventPacket(1);
    items.add(nothing);
    items.addAll(packets(120, 200));
    EngineRig rig = new EngineRig(live(items), byTime(1000));
    while (rig.engine.status().elapsedUs() < 5_000) {
      rig.engine.turn();
    }
    rig.ask(new PlaybackCommand.Play(false));
    rig.run();
    assertTrue(rig.engine.status().elapsedUs() < 20_000);
    rig.ask(new PlaybackCommand.Seek(Long.MAX_VALUE));
    rig.run();
    assertEquals(119_501, rig.engine.status().elapsedUs());
    assertEquals(PlayerStatus.State.PAUSED, rig.engine.status().state());
  }

  @Test
  void sourceThatNeverEndsIsReadForAsManyEventsAsAreKept() throws IOException {
    BufferedPlayable kept = live(packets(0, ROOM));
    kept.catchUp();
    assertEquals(500L * ROOM, kept.bufferedToUs(), 1000);
  }

  @Test
  void sceneIsNotReadAhead() throws IOException {
    BufferedPlayable kept = kept();
    kept.catchUp();
    assertEquals(0, kept.bufferedToUs());
  }
}
