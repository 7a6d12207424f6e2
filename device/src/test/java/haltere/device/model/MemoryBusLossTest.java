package haltere.device.model;

/** Loss, unplugging and closing without libusb, on every system. */
class MemoryBusLossTest extends LossScenarios {
  MemoryBusLossTest() {
    super(BusUnderTest.inMemory());
  }
}
