package haltere.device.simulated;

import haltere.core.camera.Camera;
import haltere.core.camera.CameraInfo;
import haltere.core.camera.CameraOptions;
import haltere.core.camera.CameraProblem;
import haltere.core.camera.CameraProvider;
import haltere.core.event.SensorGeometry;
import haltere.core.playback.Sleeper;
import haltere.core.simulation.Scene;
import haltere.core.simulation.SceneProvider;
import haltere.core.simulation.Scenes;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import java.util.function.Supplier;

/**
 * A simulated camera for each scene: {@code simulated:fly}, {@code simulated:road} and those of
 * other jars.
 */
public final class SimulatedCameraProvider implements CameraProvider {
  private static final String PREFIX = "simulated:";

  /** Creates a camera of a scene. */
  private interface Maker {
    Camera make(CameraInfo info, Scene<?> scene, CameraOptions options);
  }

  private final Maker maker;
  private final Map<String, SensorGeometry> geometries = new ConcurrentHashMap<>();

  /** Cameras in real time. Called by the service loader. */
  public SimulatedCameraProvider() {
    maker = SimulatedCamera::live;
  }

  /**
   * Cameras with another clock, which advance only in calls of their consumer.
   *
   * @param nanoTime their clock in nanoseconds, with any origin
   * @param sleepers create the wait of a consumer
   */
  public SimulatedCameraProvider(LongSupplier nanoTime, Supplier<Sleeper> sleepers) {
    Objects.requireNonNull(nanoTime, "nanoTime");
    Objects.requireNonNull(sleepers, "sleepers");
    maker =
        (info, scene, options) ->
            SimulatedCamera.stepped(info, scene, options, nanoTime, sleepers.get());
  }

  @Override
  public String name() {
    return "simulated";
  }

  @Override
  public boolean isPhysical() {
    return false;
  }

  @Override
  public List<CameraInfo> list() {
    List<CameraInfo> cameras = new ArrayList<>();
    for (SceneProvider<?> scene : Scenes.all().values()) {
      SensorGeometry geometry =
          geometries.computeIfAbsent(scene.name(), name -> scene.create(List.of()).geometry());
      cameras.add(info(scene, geometry));
    }
    return cameras;
  }

  private static CameraInfo info(SceneProvider<?> scene, SensorGeometry geometry) {
    return new CameraInfo(
        PREFIX + scene.name(), "simulated camera", "", geometry, true, scene.description());
  }

  @Override
  public Camera open(CameraInfo info, CameraOptions options) throws CameraProblem {
    SceneProvider<?> provider = Scenes.all().get(info.id().replaceFirst("^" + PREFIX, ""));
    if (provider == null || !info.id().startsWith(PREFIX)) {
      throw new CameraProblem(
          CameraProblem.Kind.NOT_FOUND,
          "there is no simulated camera "
              + info.id()
              + "; there are "
              + String.join(", ", Scenes.all().keySet()));
    }
    Scene<?> scene = provider.create(List.of());
    return maker.make(info(provider, scene.geometry()), scene, options);
  }
}
