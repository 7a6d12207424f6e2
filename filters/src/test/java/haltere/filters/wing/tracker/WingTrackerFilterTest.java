package haltere.filters.wing.tracker;

import haltere.core.chain.EventFilter;
import haltere.core.event.EventPacket;
import haltere.core.event.SensorGeometry;
import haltere.filters.wing.WingTrackerSettings;
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
}
