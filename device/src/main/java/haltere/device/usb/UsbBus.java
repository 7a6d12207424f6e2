package haltere.device.usb;

import haltere.core.camera.CameraProblem;
import java.util.List;

/**
 * All devices that are plugged in.
 *
 * <p>Thread rule: all methods may be called from any thread.
 */
public interface UsbBus {
  /**
   * The devices that are plugged in now. Cheap enough to be asked several times a second, which is
   * how a device that comes back is noticed.
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
   * @throws CameraProblem if that is impossible, with the reason and what to do
   */
  UsbTransport open(UsbDevice device) throws CameraProblem;
}
