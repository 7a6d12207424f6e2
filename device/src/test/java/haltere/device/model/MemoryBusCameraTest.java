package haltere.device.model;

import haltere.testing.usb.MemoryBus;
import haltere.testing.usb.TestBus;

/** The driver's scenarios without libusb, on every system. */
class MemoryBusCameraTest extends CameraScenarios {
  private final MemoryBus bus = new MemoryBus();
  private int number = 1;

  @Override
  TestBus bus() {
    return bus;
  }

  @Override
  int nextNumber() {
    return ++number;
  }
}
