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
 * A simulated camera for each scene that there is: {@code simulated:fly}, {@code simulated:road}
 * and those that other jars add.
 */
public final class SimulatedCameraProvider implements CameraProvider {
  private static final String PREFIX = "simulated:";

  private final LongSupplier nanoTime;
  private final Supplier<Sleeper> sleepers;
  private final Map<String, SensorGeometry> geometries = new ConcurrentHashMap<>();

  /** Called by the service loader. */
  public SimulatedCameraProvider() {
    this(System::nanoTime, Sleeper::real);
  }

  /**
   * Cameras that live by another clock.
   *
   * @param nanoTime real time, nanoseconds from anywhere
   * @param sleepers make what a camera waits with
   */
  public SimulatedCameraProvider(LongSupplier nanoTime, Supplier<Sleeper> sleepers) {
    this.nanoTime = Objects.requireNonNull(nanoTime, "nanoTime");
    this.sleepers = Objects.requireNonNull(sleepers, "sleepers");
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
          "there is no simulated camera " + info.id() + "; there are " + Scenes.all().keySet());
    }
    Scene<?> scene = provider.create(List.of());
    return new SimulatedCamera(
        info(provider, scene.geometry()), scene, options, nanoTime, sleepers.get());
  }
}
