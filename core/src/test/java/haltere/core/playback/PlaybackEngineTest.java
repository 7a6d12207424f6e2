package haltere.core.playback;

import static haltere.core.playback.EngineRig.SENSOR;
import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.events;
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
import haltere.core.stream.EventSource;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.MemoryRecording;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.Random;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class PlaybackEngineTest {
  private static RecordingPlayable recording(EventPacket... segments) throws IOException {
    return new RecordingPlayable(new MemoryRecording(SENSOR, () -> 2, segments));
  }

  /** One event every 10 us from 1000 us on. */
  private static EventPacket even(int count) {
    return events(LongStream.range(0, count).map(i -> 1000 + 10 * i).toArray());
  }

  // ---- Slices

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
  void slicesOfCountHoldExactlySoManyEvents() throws IOException {
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
  void aSlicePerPictureFollowsTheSpeed() throws IOException {
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

  // ---- Notifications

  @Test
  void aClockRestartInTheMiddleEndsTheSliceThere() throws IOException {
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
  void lostDataEndsTheSliceAndTheNextOneKeepsToTheGrid() throws IOException {
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
  void everyJumpTellsExactlyOnceBeforeThePacketsItConcerns() throws IOException {
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
  void jumpsWithNothingPlayedBetweenAreOne() throws IOException {
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
  void aResetSaysWhatTimesItStandsBetween() throws IOException {
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

  @Test
  void aJumpInTheMiddleOfASliceEndsItThere() throws IOException {
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
  void afterTheEndAJumpStartsTheStreamAnew() throws IOException {
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

  // ---- Loops

  @Test
  void aLoopGoesFromItsOutPointToItsInPointWithARewind() throws IOException {
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
  void aLoopOverEverythingNeverTellsOfAnEnd() throws IOException {
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
  void aLoopKeepsItsPaceOverManyRounds() throws IOException {
    EngineRig rig = new EngineRig(recording(even(101)), byTime(7).withLoop(Loop.between(100, 900)));
    rig.log.quiet = true;
    rig.raw.quiet = true;
    rig.runUntil(100_000L + 1000 * 800_000);
    // 80 events a round.
    assertEquals(90 + 80 * 999, rig.log.events, 80);
  }

  @Test
  void behindTheOutPointPlaybackGoesOnToTheEndFirst() throws IOException {
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
  void aLoopWithoutEventsEndsInsteadOfSpinning() throws IOException {
    EngineRig rig = new EngineRig(recording(), byTime(20).withLoop(Loop.ALL)).run();
    assertEquals(List.of("StreamStarted", "EndOfStream"), rig.log.take());
    assertEquals(State.ENDED, rig.engine.status().state());
  }

  @Test
  void aLoopThroughSilenceByCountTakesItsTime() throws IOException {
    EngineRig rig =
        new EngineRig(
            recording(events(0, 10, 1_000_000)),
            PlayerOptions.defaults()
                .withSlicing(new Slicing.ByCount(2))
                .withLoop(Loop.between(100, 500)));
    rig.runUntil(2_000_000);
    assertEquals(5, rig.log.slices, 1);
  }

  // ---- Steps

  @Test
  void stepsGoForwardAndBackAndShowTheSameSlices() throws IOException {
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
  void aStepBackWarmsTheChainAndShowsTheSinksNothingOfIt() throws IOException {
    EngineRig rig =
        new EngineRig(recording(even(20)), byTime(20).withPaused(true).withRunUpUs(40)).run();
    rig.ask(new PlaybackCommand.Seek(120));
    rig.run();
    rig.log.take();
    rig.raw.take();
    rig.told.clear();
    rig.ask(new PlaybackCommand.Step(-1));
    rig.run();
    assertEquals(List.of("Reset SEEK", "[1100,1120) [1100, 1110]"), rig.log.take());
    assertEquals(List.of("Reset SEEK", "[1100,1120) [1100, 1110]"), rig.raw.take());
    assertEquals(List.of("Reset SEEK", "1060", "1070", "1080", "1090", "1100", "1110"), rig.told);
    assertEquals(4, rig.engine.counters().get(Counter.EVENTS_RUN_UP));
  }

  @Test
  void stepsByCountShowTheSameEventsBothWaysAlsoAmongEventsOfOneTime() throws IOException {
    long[] times = new Random(7).longs(500, 0, 200).sorted().toArray();
    EngineRig rig =
        new EngineRig(
                recording(events(times)),
                PlayerOptions.defaults()
                    .withSlicing(new Slicing.ByCount(9))
                    .withRunUpUs(20)
                    .withPaused(true))
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
      assertEquals(List.of("Reset SEEK", forward.get(i)), rig.log.take());
    }
    rig.ask(new PlaybackCommand.Step(3));
    rig.run();
    assertEquals(forward.subList(2, 5), rig.log.take());
  }

  @Test
  void aStepBackFromTheEndStartsTheStreamAnew() throws IOException {
    EngineRig rig = new EngineRig(recording(even(6)), byTime(20)).run();
    rig.log.take();
    rig.ask(new PlaybackCommand.Step(-1));
    rig.run();
    assertEquals(List.of("StreamStarted", "[1020,1040) [1020, 1030]"), rig.log.take());
    assertEquals(State.PAUSED, rig.engine.status().state());
  }

  @Test
  void aPauseHoldsAndPlayGoesOnWhereItWas() throws IOException {
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

  // ---- Pace

  @Test
  void atSpeedOneAMinuteTakesAMinuteWhateverTheChainCosts() throws IOException {
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

  private static EventFilter filter(java.util.function.Consumer<EventPacket> work) {
    return new EventFilter() {
      @Override
      public void process(EventPacket packet) {
        work.accept(packet);
      }

      @Override
      public void reset() {}
    };
  }

  @Test
  void aChainThatCannotKeepUpIsReportedAndLosesNothing() throws IOException {
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
  void aSourceThatCannotKeepUpIsToldFromTheChain() throws IOException {
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
  void theAchievedSpeedIsMeasured() throws IOException {
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
  void aCommandIsAppliedBetweenTwoPiecesOfALongSlice() throws IOException {
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
    rig.run();
    assertTrue(rig.log.events > 0 && rig.log.events <= 2 * PlaybackEngine.CHUNK_EVENTS);
    rig.ask(new PlaybackCommand.Play(true));
    rig.run();
    assertEquals(PlaybackEngine.CHUNK_EVENTS, largest[0]);
    assertEquals(100_000, rig.log.events);
    assertEquals(1, rig.log.slices);
  }

  @Test
  void aNewSpeedCountsAlsoWhileASliceIsWaitedFor() throws IOException {
    EngineRig rig = new EngineRig(recording(events(0, 100, 200)), byTime(100).withSpeed(1e-4));
    rig.runUntil(500_000_000);
    assertEquals(1, rig.log.slices);
    rig.ask(new PlaybackCommand.SetSpeed(1));
    rig.runUntil(500_060_000);
    assertEquals(2, rig.log.slices);
  }

  // ---- Failures

  @Test
  void aFilterThatThrowsIsSwitchedOffAndPlaybackGoesOn() throws IOException {
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
  void aFilterThatThrowsAtANotificationDoesNotHideItFromTheOthers() throws IOException {
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
  void aSinkThatThrowsIsRemovedAndTheOthersGoOn() throws IOException {
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
  void aSourceThatCannotBeReadAnyMoreEndsTheStreamAndSaysSo() throws IOException {
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
  void anEditThatThrowsFailsOnlyItself() throws IOException {
    EngineRig rig = new EngineRig(recording(even(8)), byTime(20));
    CompletableFuture<Void> edit = rig.ask(new PlaybackCommand.Edit(chain -> chain.stage("none")));
    assertThrows(CompletionException.class, edit::join);
    assertTrue(rig.engine.status().message().contains("no stage named none"));
    rig.run();
    assertEquals(8, rig.log.events);
  }

  @Test
  void aChainForAnotherSensorIsRefused() throws IOException {
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
  void eventsOffTheSensorAreCountedAsDropped() throws IOException {
    EventPacket packet = even(3);
    packet.append(1100, 15, 16, true);
    EngineRig rig = new EngineRig(recording(packet), byTime(20));
    rig.ask(new PlaybackCommand.RemoveSink(rig.raw));
    rig.run();
    assertEquals(1, rig.engine.status().droppedEvents());
    assertEquals(0, rig.engine.counters().unaccountedEvents());
  }

  // ---- Scenes

  @Test
  void aSceneIsMadeAnewByARewindAndSeeksNowhereElse() {
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
