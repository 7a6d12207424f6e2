package haltere.testing.usb;

/**
 * The firmware of an emulated device.
 *
 * <p>Thread rule: called by the thread of whoever uses the device.
 */
public interface Firmware {
  /**
   * The device descriptor.
   *
   * @return 18 bytes
   */
  byte[] deviceDescriptor();

  /**
   * The only configuration's descriptor, with its interfaces and endpoints.
   *
   * @return as long as it says
   */
  byte[] configurationDescriptor();

  /**
   * A string of the device.
   *
   * @param index 1 or more
   * @return the text, or null if there is none
   */
  String string(int index);

  /**
   * Handles a non-standard request.
   *
   * @param request the request
   * @return the answer of a request to the host, anything but null of one to the device; null
   *     stalls it
   */
  byte[] control(ControlRequest request);

  /**
   * Handles a system call of the driver that concerns the device: claim, release, reset.
   *
   * @param call number of the usbfs ioctl
   * @return 0, or minus an error number
   */
  default int systemCall(int call) {
    return 0;
  }

  /**
   * Receives data of a bulk endpoint.
   *
   * @param endpoint its address
   * @param data the data
   */
  default void written(int endpoint, byte[] data) {}

  /**
   * Called when it is plugged in.
   *
   * @param device sends its packets
   */
  default void attached(EmulatedDevice device) {}
}
