package haltere.core.simulation;

import haltere.core.simulation.internal.dots.MovingDotsSettings;
import haltere.core.simulation.internal.flight.FlightSettings;
import haltere.core.simulation.internal.fly.FlySceneSettings;
import haltere.core.simulation.internal.fly.RenderedFlySceneSettings;
import haltere.core.simulation.internal.road.RoadSceneSettings;
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
