package haltere.device.model;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/** Several cameras through libusb, on emulated USB. */
@Tag("emulator")
@ExtendWith(EmulatedUsb.class)
class LibusbManyTest extends ManyCameraScenarios {
  LibusbManyTest() {
    super(EmulatedUsb.BUS);
  }
}
