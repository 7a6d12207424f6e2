package haltere.device.model;

/** A DAVIS without libusb, on every system. */
class MemoryBusDavisTest extends DavisScenarios {
  MemoryBusDavisTest() {
    super(BusUnderTest.inMemory());
  }
}
