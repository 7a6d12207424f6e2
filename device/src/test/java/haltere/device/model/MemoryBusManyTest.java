package haltere.device.model;

/** Several cameras on a bus in memory. */
class MemoryBusManyTest extends ManyCameraScenarios {
  MemoryBusManyTest() {
    super(BusUnderTest.inMemory());
  }
}
