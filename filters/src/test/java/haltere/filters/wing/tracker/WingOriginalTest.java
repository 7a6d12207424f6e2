package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.filters.estimation.Angles;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The tracker of Cardinale (2006). */
class WingOriginalTest {
  private static final String STEADY = "disturbances.manoeuvres.everyS=0";
  private static final String SPARSE = "fly.wing.visibleShare=0.15";

  private static EventPacket fly(double hz, double seconds) {
    return Flies.events(seconds, STEADY, SPARSE, "stroke.beat.frequencyHz=" + hz);
  }

  private static WingTrackerState step(TrackerOutput output, Phase phase) {
    return output.states.stream().filter(s -> s.phase() == phase).findFirst().orElseThrow();
  }

  @Test
  void flyIsFoundByTwoMeansOfTheFirst2000Events() {
    EventPacket fly = fly(235, 0.1);
    TrackerOutput output = TrackerOutput.of(fly, WingTrackerSettings.original());
    assertEquals(
        List.of(Phase.COLLECTING, Phase.TWO_MEANS, Phase.HEAD_AND_TAIL, Phase.UNLOCKED),
        output.states.stream().limit(4).map(WingTrackerState::phase).toList());
    WingTrackerState found = step(output, Phase.HEAD_AND_TAIL);
    assertEquals(fly.timeUs(1999), found.timeUs());
    assertEquals(240, found.frequencyHz());
    FlyGeometry body = output.geometry;
    assertEquals(body.centreX(), body.leftHingeX());
    assertEquals(body.centreY(), body.rightHingeY());
    // the means: nearest points of each class
    double across = body.headingRad() + Math.PI / 2;
    double half = body.sizePx() / 2;
    double[] mean = {half * Math.cos(across), half * Math.sin(across)};
    double[] sums = new double[4];
    int[] counts = new int[2];
    Set<Integer> pixels = new HashSet<>();
    for (int i = 0; i < 2000; i++) {
      if (pixels.add(fly.y(i) * 128 + fly.x(i))) {
        double dx = fly.x(i) - body.centreX();
        double dy = fly.y(i) - body.centreY();
        int side = dx * mean[0] + dy * mean[1] > 0 ? 0 : 1;
        sums[2 * side] += dx;
        sums[2 * side + 1] += dy;
        counts[side]++;
      }
    }
    for (int side = 0; side < 2; side++) {
      double sign = side == 0 ? 1 : -1;
      assertEquals(sign * mean[0], sums[2 * side] / counts[side], 1.5);
      assertEquals(sign * mean[1], sums[2 * side + 1] / counts[side], 1.5);
    }
    FlyScene truth = Flies.scene(STEADY, SPARSE);
    assertEquals(
        0, Angles.wrapPi(body.headingRad() - truth.truthAt(0).headingRad()), 0.15, "the head");
  }

  @ParameterizedTest
  @ValueSource(strings = {"EKF", "WRA", "BOTH"})
  void bodyHeadingAndRegionFollowTheBeats(String method) {
    EventPacket fly = fly(235, 0.4);
    WingTrackerSettings settings = WingTrackerSettings.original().with("filter.method=" + method);
    TrackerOutput output = TrackerOutput.of(fly, settings);
    FlyGeometry now = output.tracker.geometry().orElseThrow();
    assertTrue(now.centreY() != output.geometry.centreY());
    assertTrue(now.headingRad() != output.geometry.headingRad());
    assertEquals(now.sizePx(), output.tracker.regionPx(), 1e-9);
    assertTrue(now.sizePx() != output.geometry.sizePx());
    assertEquals(now.centreX(), now.leftHingeX(), 1e-9, "no hinges");
    TrackerOutput still =
        TrackerOutput.of(
            fly, settings.with("average.bodyUpdate=false", "average.headingUpdate=false"));
    FlyGeometry stays = still.tracker.geometry().orElseThrow();
    assertEquals(still.geometry.centreY(), stays.centreY());
    assertEquals(still.geometry.headingRad(), stays.headingRad());
  }

  @ParameterizedTest
  @ValueSource(ints = {112, 150})
  void filterAtAnotherFrequencyThanTheBeatIsNeverInLock(int hz) {
    TrackerOutput output = TrackerOutput.of(fly(hz, 0.5), WingTrackerSettings.original());
    assertFalse(output.phases().contains(Phase.TRACKING));
    assertEquals(Phase.UNLOCKED, output.lastPhase());
    assertEquals(List.of(), output.beats);
    assertTrue(output.of(WingPart.LEFT).size() > 400, "it goes on all the same");
    assertTrue(Math.abs(output.last(WingPart.LEFT).frequencyHz() - hz) > 20);
  }

  @Test
  void filterNearItsStartAndRunningAverageAreInLock() {
    TrackerOutput filter = TrackerOutput.of(fly(232, 0.5), WingTrackerSettings.original());
    assertEquals(Phase.TRACKING, filter.lastPhase());
    assertTrue(step(filter, Phase.TRACKING).timeUs() < 60_000);
    double mean = filter.beats.stream().mapToDouble(WingBeat::frequencyHz).average().orElse(0);
    assertEquals(230, mean, 8);
    TrackerOutput average =
        TrackerOutput.of(fly(150, 0.5), WingTrackerSettings.original().with("filter.method=WRA"));
    assertEquals(Phase.TRACKING, average.lastPhase());
    WingEstimate last = average.last(WingPart.RIGHT);
    assertEquals(148, last.frequencyHz(), 8);
  }
}
