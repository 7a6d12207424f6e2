package haltere.filters.wing;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.core.simulation.FlyScene;
import haltere.core.simulation.FlySceneSettings;
import haltere.core.stream.StreamHandler;
import haltere.core.stream.StreamNotification;
import haltere.testing.EventFilterContract;

class WingTrackerFilterTest extends EventFilterContract {
  @Override
  protected EventFilter create(SensorGeometry geometry) {
    return new WingTrackerFilter(
        geometry,
        WingTrackerSettings.defaults()
            .with("filter.method=BOTH", "output.rateHz=400", "search.windowUs=25000"));
  }

  @Override
  protected EventPacket stream(SensorGeometry geometry, long seed) {
    return Flies.events(
        0.06,
        "fly.wing.visibleShare=0.9",
        "sensor.widthPx=" + geometry.width(),
        "sensor.heightPx=" + geometry.height(),
        "fly.wing.lengthPx=" + 0.4 * geometry.height(),
        "fly.body.lengthPx=" + 0.35 * geometry.height(),
        "run.seed=" + seed);
  }

  /** Events of simulated flies. */
  static final class Flies {
    private Flies() {}

    static FlyScene scene(String... assignments) {
      return new FlyScene(FlySceneSettings.defaults().with(assignments));
    }

    static EventPacket events(double seconds, String... assignments) {
      return events(seconds, FlySceneSettings.defaults().with(assignments));
    }

    static EventPacket events(double seconds, FlySceneSettings settings) {
      FlyScene scene = new FlyScene(settings.with("run.durationS=" + seconds));
      EventPacket all = new EventPacket(0);
      StreamHandler collect =
          new StreamHandler() {
            @Override
            public void packet(EventPacket packet) {
              all.append(packet, 0, packet.size());
            }

            @Override
            public void notified(StreamNotification notification) {
              // the events are all that counts
            }
          };
      while (scene.next(collect)) {
        // until the end
      }
      return all;
    }
  }
}
