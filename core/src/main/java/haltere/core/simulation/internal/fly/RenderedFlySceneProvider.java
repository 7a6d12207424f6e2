package haltere.core.simulation.internal.fly;

import haltere.core.simulation.Scene;
import haltere.core.simulation.SceneProvider;

/** Makes {@link RenderedFlyScene}s. */
public final class RenderedFlySceneProvider implements SceneProvider<RenderedFlySceneSettings> {
  /** Called by the service loader. */
  public RenderedFlySceneProvider() {}

  @Override
  public String name() {
    return "rendered-fly";
  }

  @Override
  public String description() {
    return "Rendered fly: images of a tethered fly whose half-transparent wings pitch, and pixels"
        + " that low-pass the light, take its logarithm and compare.";
  }

  @Override
  public Class<RenderedFlySceneSettings> settingsType() {
    return RenderedFlySceneSettings.class;
  }

  @Override
  public Scene<?> create(RenderedFlySceneSettings settings) {
    return new RenderedFlyScene(settings);
  }
}
