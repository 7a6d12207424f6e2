package haltere.device.usb;

/**
 * A device as it is seen on a bus before it is opened.
 *
 * @param vendorId number of its maker, 16 bits
 * @param productId the maker's number of the product, 16 bits
 * @param version its release, 16 bits (bcdDevice)
 * @param bus number of the bus
 * @param address on the bus; another one each time that it is plugged in
 */
public record UsbDevice(int vendorId, int productId, int version, int bus, int address) {
  /**
   * Where it is plugged in.
   *
   * @return such as {@code 1-5}, bus and address
   */
  public String place() {
    return bus + "-" + address;
  }
}
