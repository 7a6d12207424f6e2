package haltere.filters.wing.tracker;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.wing.FlyGeometry;
import haltere.filters.wing.WingAverage;
import haltere.filters.wing.WingBeat;
import haltere.filters.wing.WingEstimate;
import haltere.filters.wing.WingListener;
import haltere.filters.wing.WingPair;
import haltere.filters.wing.WingPart;
import haltere.filters.wing.WingResult;
import haltere.filters.wing.WingTrackerSettings;
import haltere.filters.wing.WingTrackerState;
import haltere.filters.wing.WingTrackerState.Phase;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;

/** Recorded results of a tracker; checks that they are finite. */
final class TrackerOutput implements WingListener {
  static final SensorGeometry SENSOR = new SensorGeometry(128, 128);

  final List<WingTrackerState> states = new ArrayList<>();
  final List<WingEstimate> estimates = new ArrayList<>();
  final List<WingEstimate> averages = new ArrayList<>();
  final List<WingBeat> beats = new ArrayList<>();
  final List<WingPair> pairs = new ArrayList<>();
  FlyGeometry geometry;
  WingTracker tracker;

  /** Output of a tracker with given settings on events. */
  static TrackerOutput of(EventPacket events, WingTrackerSettings settings) {
    TrackerOutput output = new TrackerOutput();
    output.tracker = new WingTracker(SENSOR, settings, output);
    output.tracker.track(events);
    return output;
  }

  /** Output of a tracker whose settings differ from the defaults by assignments. */
  static TrackerOutput with(EventPacket events, String... assignments) {
    return of(events, WingTrackerSettings.defaults().with(assignments));
  }

  @Override
  public void accept(WingResult result) {
    if (result instanceof WingTrackerState state) {
      states.add(state);
    } else if (result instanceof WingEstimate estimate) {
      assertNumbers(estimate);
      estimates.add(estimate);
    } else if (result instanceof WingAverage average) {
      assertNumbers(average.estimate());
      averages.add(average.estimate());
    } else if (result instanceof WingBeat beat) {
      beats.add(beat);
    } else if (result instanceof WingPair pair) {
      pairs.add(pair);
    } else if (result instanceof FlyGeometry found) {
      geometry = found;
    }
  }

  private static void assertNumbers(WingEstimate e) {
    assertTrue(
        Double.isFinite(
            e.angleRad() + e.centreRad() + e.amplitudeRad() + e.phaseRad() + e.frequencyHz()),
        e::toString);
  }

  Set<Phase> phases() {
    Set<Phase> phases = EnumSet.noneOf(Phase.class);
    states.forEach(state -> phases.add(state.phase()));
    return phases;
  }

  Phase lastPhase() {
    return states.get(states.size() - 1).phase();
  }

  /** Estimates of an edge or a wing. */
  List<WingEstimate> of(WingPart part) {
    return estimates.stream().filter(e -> e.edge() == part).toList();
  }

  /** The last estimate of an edge or a wing. */
  WingEstimate last(WingPart part) {
    List<WingEstimate> all = of(part);
    return all.get(all.size() - 1);
  }
}
