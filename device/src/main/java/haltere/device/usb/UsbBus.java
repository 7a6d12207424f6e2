package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import java.util.List;
import java.util.Optional;

/**
 * All devices that are plugged in.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public interface UsbBus {
  /** A subscription to arrivals and removals of devices. */
  interface Watch extends AutoCloseable {
    /** Ends the subscription. A second call has no effect. */
    @Override
    void close();
  }

  /**
   * Subscribes to arrivals and removals of devices.
   *
   * @param changed called on an event-handling thread; must return at once without calling the bus
   * @return a watch that the caller closes, or empty if unsupported, so that {@link #devices()}
   *     must be polled
   * @throws CameraProblem if USB cannot be used on this computer
   */
  default Optional<Watch> watch(Runnable changed) throws CameraProblem {
    return Optional.empty();
  }

  /**
   * The devices that are plugged in now. Cheap enough to be called several times a second.
   *
   * @return ordered by bus and address
   * @throws CameraProblem if USB cannot be used on this computer
   */
  List<UsbDevice> devices() throws CameraProblem;

  /**
   * Opens a device.
   *
   * @param device one of {@link #devices()}
   * @return a transport that the caller closes
   * @throws CameraProblem if that is impossible, with the reason and advice
   */
  UsbTransport open(UsbDevice device) throws CameraProblem;
}
