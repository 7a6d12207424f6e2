package haltere.core.simulation.internal.dots;

import haltere.core.simulation.Scene;
import haltere.core.simulation.SceneProvider;

/** Makes {@link MovingDotsScene}s. */
public final class MovingDotsSceneProvider implements SceneProvider<MovingDotsSettings> {
  /** Called by the service loader. */
  public MovingDotsSceneProvider() {}

  @Override
  public String name() {
    return "dots";
  }

  @Override
  public String description() {
    return "Dark dots on known paths through noise, and the truth about each of them.";
  }

  @Override
  public Class<MovingDotsSettings> settingsType() {
    return MovingDotsSettings.class;
  }

  @Override
  public Scene<?> create(MovingDotsSettings settings) {
    return new MovingDotsScene(settings);
  }
}
