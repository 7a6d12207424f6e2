package haltere.testing.usb;

import haltere.device.usb.UsbBus;

/** A bus that a test plugs devices into. */
public interface TestBus extends AutoCloseable {
  /**
   * What a driver uses.
   *
   * @return the bus
   */
  UsbBus bus();

  /**
   * Plugs a device in.
   *
   * @param number its address, 2 to 127, not in use
   * @param firmware what it does
   * @return the device
   */
  EmulatedDevice plug(int number, Firmware firmware);

  @Override
  void close();
}
