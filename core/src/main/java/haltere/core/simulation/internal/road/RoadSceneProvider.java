package haltere.core.simulation.internal.road;

import haltere.core.simulation.Scene;
import haltere.core.simulation.SceneProvider;

/** Makes {@link RoadScene}s. */
public final class RoadSceneProvider implements SceneProvider<RoadSceneSettings> {
  /** Called by the service loader. */
  public RoadSceneProvider() {}

  @Override
  public String name() {
    return "road";
  }

  @Override
  public String description() {
    return "Traffic on a road seen from a bridge, and the truth about each vehicle.";
  }

  @Override
  public Class<RoadSceneSettings> settingsType() {
    return RoadSceneSettings.class;
  }

  @Override
  public Scene<?> create(RoadSceneSettings settings) {
    return new RoadScene(settings);
  }
}
