package haltere.device.model;

import haltere.testing.usb.MemoryBus;
import haltere.testing.usb.TestBus;

/** Loss, unplugging and closing without libusb, on every system. */
class MemoryBusLossTest extends LossScenarios {
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
