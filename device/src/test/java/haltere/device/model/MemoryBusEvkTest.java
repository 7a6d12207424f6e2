package haltere.device.model;

/** An EVK4 without libusb, on every system. */
class MemoryBusEvkTest extends EvkScenarios {
  MemoryBusEvkTest() {
    super(BusUnderTest.inMemory());
  }
}
