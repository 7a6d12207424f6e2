package haltere.core.simulation;

import haltere.core.simulation.dots.MovingDotsSettings;
import haltere.core.simulation.flight.FlightSettings;
import haltere.core.simulation.fly.FlySceneSettings;
import haltere.core.simulation.fly.RenderedFlySceneSettings;
import haltere.core.simulation.road.RoadSceneSettings;
import haltere.testing.SettingsContract;
import java.util.Collection;
import java.util.List;

/** The settings of the scenes keep the contract of all settings. */
class SimulationSettingsTest extends SettingsContract {
  @Override
  protected Collection<? extends Class<? extends Record>> settingsTypes() {
    return List.of(
        FlightSettings.class,
        FlySceneSettings.class,
        MovingDotsSettings.class,
        RenderedFlySceneSettings.class,
        RoadSceneSettings.class);
  }
}
