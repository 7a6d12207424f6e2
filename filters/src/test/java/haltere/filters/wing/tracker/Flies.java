package haltere.filters.wing.tracker;

import haltere.core.event.EventPacket;
import haltere.core.simulation.internal.fly.FlyScene;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.testing.SceneEvents;

/** Simulated flies that differ from the usual one by assignments. */
final class Flies {
  /** Setting of a tracker: the constant delay that the scene's pixels have, stated. */
  static final String LATENCY = "filter.latencyUs=60";

  private Flies() {}

  static FlyScene scene(String... assignments) {
    return new FlyScene(FlySceneSettings.defaults().with(assignments));
  }

  static EventPacket events(double seconds, String... assignments) {
    return events(seconds, FlySceneSettings.defaults().with(assignments));
  }

  static EventPacket events(double seconds, FlySceneSettings settings) {
    return SceneEvents.of(new FlyScene(settings.with("run.durationS=" + seconds)));
  }
}
