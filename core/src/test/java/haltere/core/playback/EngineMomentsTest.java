package haltere.core.playback;

import static haltere.core.playback.EngineRig.byTime;
import static haltere.core.playback.EngineRig.even;
import static haltere.core.playback.EngineRig.recording;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorSample;
import haltere.core.pipeline.PipelineCounters.Counter;
import haltere.core.playback.PlayerStatus.State;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;

/** The display of a moment does not depend on its history. */
class EngineMomentsTest {
  private static final long MEMORY_US = 400;

  private static EngineRig rig(boolean paused) throws IOException {
    return new EngineRig(recording(even(400)), byTime(100).withPaused(paused), MEMORY_US);
  }

  /** Elements that the chain has received since it restarted. */
  private static List<String> run(EngineRig rig) {
    return List.copyOf(rig.told.subList(rig.told.lastIndexOf("Reset SEEK"), rig.told.size()));
  }

  private static EngineRig sought(long elapsedUs) throws IOException {
    EngineRig rig = rig(true).run();
    rig.ask(new PlaybackCommand.Seek(elapsedUs));
    return rig.run();
  }

  @Test
  void playedAndSoughtMomentsAreEqual() throws IOException {
    EngineRig played = rig(false);
    played.runUntil(2_050_000);
    assertEquals(2000, played.engine.status().elapsedUs());
    played.ask(new PlaybackCommand.Play(false));
    played.run();
    assertEquals(2000, played.engine.status().elapsedUs());
    assertEquals(run(sought(2000)), run(played));
    assertEquals("2600", run(played).get(1));
  }

  @Test
  void eventRateOfADisplayedSliceIsNotThatOfARunUp() throws IOException {
    EngineRig rig = new EngineRig(recording(even(20_000)), byTime(10_000), 40_000);
    rig.runUntil(150_000_000);
    assertEquals(100_000, rig.engine.status().eventRateEps(), 100);
    rig.ask(new PlaybackCommand.Play(false));
    int runUps = 0;
    while (rig.engine.turn() != Long.MAX_VALUE) {
      runUps += rig.engine.status().runUpUs() > 0 ? 1 : 0;
      assertEquals(100_000, rig.engine.status().eventRateEps(), 100);
    }
    assertTrue(runUps > 0);
  }

  @Test
  void steppedAndSoughtMomentsAreEqual() throws IOException {
    for (int steps : new int[] {1, 3, 7, -1, -5}) {
      EngineRig stepped = sought(2000);
      stepped.ask(new PlaybackCommand.Step(steps));
      stepped.run();
      EngineRig back = sought(2000);
      back.ask(new PlaybackCommand.Step(steps));
      back.run();
      back.ask(new PlaybackCommand.Step(-steps));
      back.run();
      assertEquals(run(sought(2000 + 100 * steps)), run(stepped));
      assertEquals(run(sought(2000)), run(back));
    }
  }

  @Test
  void loopRunsTheChainBeforeItsStart() throws IOException {
    EngineRig rig = rig(true).run();
    rig.ask(
        new PlaybackCommand.SetLoop(
            new Loop(true, java.util.OptionalLong.of(2000), java.util.OptionalLong.of(2300))));
    rig.ask(new PlaybackCommand.Seek(2200));
    rig.run();
    rig.told.clear();
    rig.ask(new PlaybackCommand.Play(true));
    rig.runUntil(rig.clock.getAsLong() + 150_000);
    assertEquals("Reset REWIND", rig.told.get(0));
    assertEquals("2600", rig.told.get(1));
  }

  @Test
  void changesWhilePausedRepeatTheSliceForSliceSinksOnly() throws IOException {
    EngineRig rig = sought(2000);
    List<String> before = run(rig);
    List<Long> file = new ArrayList<>();
    rig.ask(
        new PlaybackCommand.AddSink(
            new StreamHandler() {
              @Override
              public void packet(EventPacket packet) {
                for (int i = 0; i < packet.size(); i++) {
                  file.add(packet.timeUs(i));
                }
              }

              @Override
              public void sample(SensorSample sample) {}

              @Override
              public void notified(StreamNotification notification) {}
            },
            false));
    rig.log.take();
    edit(rig);
    rig.run();
    assertEquals(before, run(rig));
    assertEquals(3, rig.log.take().size());
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    assertEquals(3100, file.get(0));
    assertEquals(10, file.size());
    assertEquals(State.PAUSED, rig.engine.status().state());
    assertEquals(2100, rig.engine.status().elapsedUs());
  }

  @Test
  void editsDuringAPauseCostOneRunUpAndThoseDuringARunUpOneMore() throws IOException {
    EngineRig rig = sought(2000);
    long once = (MEMORY_US + MEMORY_US / 4 + 100) / 10;
    long before = eventsRunUp(rig);
    edit(rig);
    rig.run();
    long first = eventsRunUp(rig) - before;
    assertTrue(first > 0 && first <= once, first + " events");
    edit(rig);
    rig.engine.turn();
    rig.engine.turn();
    for (int i = 0; i < 5; i++) {
      edit(rig);
    }
    rig.run();
    assertEquals(3 * first, eventsRunUp(rig) - before);
  }

  private static void edit(EngineRig rig) {
    rig.ask(
        new PlaybackCommand.Edit(chain -> chain.setEnabled(chain.stages().get(0), true), false));
  }

  private static long eventsRunUp(EngineRig rig) {
    return rig.engine.counters().get(Counter.EVENTS_RUN_UP);
  }

  @Test
  void readsAndManualChangesRepeatNothing() throws IOException {
    EngineRig rig = sought(2000);
    rig.log.take();
    rig.ask(new PlaybackCommand.Read(chain -> {}));
    rig.ask(new PlaybackCommand.Edit(chain -> {}, false));
    rig.ask(new PlaybackCommand.Refresh());
    rig.run();
    assertEquals(List.of(), rig.log.take());
    rig.ask(new PlaybackCommand.Seek(1000));
    rig.run();
    rig.log.take();
    rig.ask(new PlaybackCommand.Refresh());
    rig.run();
    assertEquals(3, rig.log.take().size());
  }

  @Test
  void pausingDuringARunUpShowsTheTarget() throws IOException {
    EngineRig rig = rig(false);
    rig.runUntil(50_000);
    rig.ask(new PlaybackCommand.Seek(2000));
    rig.engine.turn();
    rig.engine.turn();
    assertTrue(rig.engine.status().runUpUs() > 0);
    rig.ask(new PlaybackCommand.Play(false));
    rig.run();
    assertEquals(0, rig.engine.status().runUpUs());
    assertEquals(run(sought(2000)), run(rig));
    assertFalse(rig.log.take().isEmpty());
  }

  @Test
  void scenesRepeatSlicesFromStoredEvents() throws IOException {
    BufferedPlayable kept = new BufferedPlayable(recording(even(400)), 100_000);
    EngineRig rig = new EngineRig(kept, byTime(100), MEMORY_US);
    rig.runUntil(2_050_000);
    rig.ask(new PlaybackCommand.Play(false));
    rig.run();
    assertEquals(run(sought(2000)), run(rig));
    rig.told.clear();
    rig.ask(new PlaybackCommand.Step(1));
    rig.run();
    assertEquals("3100", rig.told.get(0));
  }
}
