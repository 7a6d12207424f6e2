package haltere.device.model;

import haltere.testing.usb.TestBus;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;

/** The driver's scenarios through libusb, on emulated USB. */
@Tag("emulator")
class LibusbCameraTest extends CameraScenarios {
  private static int openFilesBefore;

  @BeforeAll
  static void countOpenFiles() {
    openFilesBefore = EmulatedUsb.openFiles();
  }

  /** Libusb itself, and classes, keep a few open; a leak of one for each test or cycle is more. */
  @AfterAll
  static void noFileIsLeftOpen() {
    await(() -> EmulatedUsb.openFiles() < openFilesBefore + 20);
  }

  @Override
  TestBus bus() {
    return EmulatedUsb.EMULATOR;
  }

  @Override
  int nextNumber() {
    return EmulatedUsb.nextNumber();
  }
}
