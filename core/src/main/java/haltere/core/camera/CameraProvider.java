package haltere.core.camera;

import java.util.List;
import java.util.Optional;

/**
 * Lists and opens cameras: over USB, simulated, over a network. Found as a service, so that another
 * jar can add one: list the class in {@code META-INF/services/haltere.core.camera.CameraProvider}
 * and give it a constructor without parameters.
 *
 * <p>Thread rule: all methods may be called from any thread.
 *
 * @since 0.1
 */
public interface CameraProvider {
  /**
   * The provider's name.
   *
   * @return such as {@code usb}
   */
  String name();

  /**
   * Whether its cameras are real devices. Only these are opened by default.
   *
   * @return false for simulated cameras
   */
  default boolean isPhysical() {
    return true;
  }

  /**
   * All cameras found now. One that cannot be opened is listed with the reason; empty if the
   * provider is unavailable.
   *
   * @return ordered by id
   */
  List<CameraInfo> list();

  /** A subscription to arrivals and removals of cameras. */
  interface Watch extends AutoCloseable {
    /** Ends the subscription. A second call has no effect. */
    @Override
    void close();
  }

  /**
   * Subscribes to arrivals and removals of cameras. A new camera may need a second until it can be
   * opened.
   *
   * @param changed called on any thread; must return at once without calling this provider
   * @return a subscription that the caller closes, or empty if this provider does not support it
   */
  default Optional<Watch> watch(Runnable changed) {
    return Optional.empty();
  }

  /**
   * Reason why no camera can be found, such as a missing library.
   *
   * @return a line for users, or empty
   */
  default Optional<String> obstacle() {
    return Optional.empty();
  }

  /**
   * Opens and prepares a camera; events flow from the first call of {@link Camera#next} on.
   *
   * @param info one of {@link #list()}
   * @param options options of its event stream
   * @return an open camera that the caller closes
   * @throws CameraProblem if that is impossible, with the reason and advice
   */
  Camera open(CameraInfo info, CameraOptions options) throws CameraProblem;
}
