package haltere.ui.command.results;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.chain.FilterChain;
import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.stream.Reset;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.tracker.WingTrackerFilter;
import haltere.testing.SceneEvents;
import org.junit.jupiter.api.Test;

class WingsSummaryTest {
  @Test
  void shareOfTimeInLockCoversBothSegmentsOfARestartedClock() {
    FlyScene scene = new FlyScene(FlySceneSettings.defaults().with("run.durationS=0.1"));
    EventPacket fly = SceneEvents.of(scene);
    WingTrackerFilter filter =
        new WingTrackerFilter(scene.geometry(), WingTrackerSettings.defaults());
    FilterChain chain = new FilterChain(scene.geometry());
    chain.add("wing-tracker", filter);
    WingsSummary summary = new WingsSummary(filter, 1000);
    summary.listenTo(chain);
    for (int time = 0; time < 2; time++) {
      filter.process(fly);
      summary.packet(fly);
      filter.notified(new Reset(Reset.Cause.CLOCK_RESTARTED, fly.lastTimeUs(), fly.firstTimeUs()));
    }
    // the search takes 35 ms of each 100 ms
    assertTrue(
        summary.lines().stream().anyMatch(line -> line.startsWith("in lock 6")),
        summary.lines().toString());
  }
}
