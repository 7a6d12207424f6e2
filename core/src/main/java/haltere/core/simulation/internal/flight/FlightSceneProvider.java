package haltere.core.simulation.internal.flight;

import haltere.core.simulation.Scene;
import haltere.core.simulation.SceneProvider;

/** Makes {@link FlightScene}s. */
public final class FlightSceneProvider implements SceneProvider<FlightSettings> {
  /** Called by the service loader. */
  public FlightSceneProvider() {}

  @Override
  public String name() {
    return "flight";
  }

  @Override
  public String description() {
    return "An insect in free flight with saccades, seen by one of several cameras.";
  }

  @Override
  public Class<FlightSettings> settingsType() {
    return FlightSettings.class;
  }

  @Override
  public Scene<?> create(FlightSettings settings) {
    return new FlightScene(settings);
  }
}
