package haltere.core.camera;

import haltere.core.extension.Extensions;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;

/**
 * The cameras of all providers.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public final class Cameras {
  private final List<CameraProvider> providers;

  /**
   * The cameras of some providers.
   *
   * @param providers asked in this order
   */
  public Cameras(List<? extends CameraProvider> providers) {
    this.providers = List.copyOf(providers);
  }

  /**
   * The cameras of all providers that are found as services.
   *
   * @return the same at every call
   */
  public static Cameras installed() {
    return new Cameras(Extensions.find(CameraProvider.class));
  }

  /**
   * All cameras found now, including those that cannot be opened.
   *
   * @return physical cameras first
   */
  public List<CameraInfo> list() {
    return seen().stream().map(FoundCamera::info).toList();
  }

  /**
   * Subscribes to arrivals and removals of cameras, as far as providers support it. A new camera
   * may need a second until it can be opened.
   *
   * @param changed called on any thread; must return at once without calling this class
   * @return the subscription
   */
  public CameraProvider.Watch watch(Runnable changed) {
    List<CameraProvider.Watch> watches =
        providers.stream().flatMap(provider -> provider.watch(changed).stream()).toList();
    return () -> watches.forEach(CameraProvider.Watch::close);
  }

  /**
   * Reasons why providers cannot find any camera.
   *
   * @return a line for users for each of them, beginning with its name
   */
  public List<String> obstacles() {
    return providers.stream()
        .flatMap(provider -> provider.obstacle().stream().map(why -> provider.name() + ": " + why))
        .toList();
  }

  /**
   * Opens a camera.
   *
   * @param id id as listed; empty for the first physical one that can be opened
   * @param options options of its event stream
   * @return an open camera that the caller closes
   * @throws CameraProblem if there is none of that id, listing those that there are, or if it
   *     cannot be opened
   */
  public Camera open(String id, CameraOptions options) throws CameraProblem {
    List<FoundCamera> seen = seen();
    for (FoundCamera camera : seen) {
      boolean wanted =
          id.isEmpty()
              ? camera.provider.isPhysical() && camera.info.canOpen()
              : camera.info.id().equals(id);
      if (wanted) {
        return camera.provider.open(camera.info, options);
      }
    }
    throw new CameraProblem(
        CameraProblem.Kind.NOT_FOUND,
        (id.isEmpty() ? unavailable(seen) : "there is no camera " + id + "; " + found(seen))
            + obstacles().stream().map(why -> "; " + why).collect(Collectors.joining()));
  }

  /** Why none of the physical cameras can be opened, and the other cameras. */
  private String unavailable(List<FoundCamera> seen) {
    Map<Boolean, List<FoundCamera>> byKind =
        seen.stream().collect(Collectors.partitioningBy(camera -> camera.provider.isPhysical()));
    List<FoundCamera> physical = byKind.get(true);
    List<FoundCamera> others = byKind.get(false);
    String why =
        physical.isEmpty()
            ? "no camera is connected" + (providers.isEmpty() ? "; " + found(seen) : "")
            : "no connected camera can be opened: " + words(physical);
    return others.isEmpty() ? why : why + "; others are opened by name: " + words(others);
  }

  private String found(List<FoundCamera> seen) {
    return seen.isEmpty() ? none() : "there are " + words(seen);
  }

  private String none() {
    return providers.isEmpty()
        ? "no driver is found; those of USB cameras are in haltere-device"
        : "there is none";
  }

  private static String words(List<FoundCamera> seen) {
    return seen.stream()
        .map(FoundCamera::info)
        .map(info -> info.id() + (info.canOpen() ? "" : " (" + info.note() + ")"))
        .collect(Collectors.joining(", "));
  }

  private List<FoundCamera> seen() {
    List<FoundCamera> seen = new ArrayList<>();
    for (boolean physical : new boolean[] {true, false}) {
      for (CameraProvider provider : providers) {
        if (provider.isPhysical() == physical) {
          provider.list().forEach(info -> seen.add(new FoundCamera(provider, info)));
        }
      }
    }
    return seen;
  }

  private record FoundCamera(CameraProvider provider, CameraInfo info) {}
}
