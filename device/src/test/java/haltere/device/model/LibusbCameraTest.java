package haltere.device.model;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/** The driver's scenarios through libusb, on emulated USB. */
@Tag("emulator")
@ExtendWith(EmulatedUsb.class)
class LibusbCameraTest extends CameraScenarios {
  LibusbCameraTest() {
    super(EmulatedUsb.BUS);
  }
}
