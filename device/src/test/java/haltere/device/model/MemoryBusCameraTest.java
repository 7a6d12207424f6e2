package haltere.device.model;

/** The driver's scenarios without libusb, on every system. */
class MemoryBusCameraTest extends CameraScenarios {
  MemoryBusCameraTest() {
    super(BusUnderTest.inMemory());
  }
}
