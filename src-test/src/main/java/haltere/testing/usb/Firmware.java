package haltere.testing.usb;

/**
 * What a device's firmware does.
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
   * Obeys a request that no standard knows.
   *
   * @param request what is asked for
   * @return the answer of a request to the host, anything but null of one to the device; null
   *     stalls it
   */
  byte[] control(ControlRequest request);

  /**
   * Obeys a call of the driver to the system that the device hears of: claim, release, reset.
   *
   * @param call number of the usbfs ioctl
   * @return 0, or minus an error number
   */
  default int systemCall(int call) {
    return 0;
  }

  /**
   * Takes data of a bulk endpoint to the device.
   *
   * @param endpoint its address
   * @param data what came
   */
  default void written(int endpoint, byte[] data) {}

  /**
   * Is told where it is plugged in.
   *
   * @param device sends its packets
   */
  default void attached(EmulatedDevice device) {}
}
