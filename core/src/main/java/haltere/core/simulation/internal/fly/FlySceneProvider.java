package haltere.core.simulation.internal.fly;

import haltere.core.simulation.Scene;
import haltere.core.simulation.SceneProvider;

/** Makes {@link FlyScene}s. */
public final class FlySceneProvider implements SceneProvider<FlySceneSettings> {
  /** Called by the service loader. */
  public FlySceneProvider() {}

  @Override
  public String name() {
    return "fly";
  }

  @Override
  public String description() {
    return "A tethered fruit fly with beating wings, and the truth about its wings and body.";
  }

  @Override
  public Class<FlySceneSettings> settingsType() {
    return FlySceneSettings.class;
  }

  @Override
  public Scene<?> create(FlySceneSettings settings) {
    return new FlyScene(settings);
  }
}
