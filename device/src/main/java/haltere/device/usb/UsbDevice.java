package haltere.device.usb;

/**
 * A device on a bus, before it is opened.
 *
 * @param vendorId id of its manufacturer, 16 bits
 * @param productId the manufacturer's id of the product, 16 bits
 * @param version its release, 16 bits (bcdDevice)
 * @param bus number of the bus
 * @param address on the bus; changes each time that it is plugged in
 */
public record UsbDevice(int vendorId, int productId, int version, int bus, int address) {
  /**
   * Port of the device.
   *
   * @return such as {@code 1-5}, bus and address
   */
  public String place() {
    return bus + "-" + address;
  }
}
