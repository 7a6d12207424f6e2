package haltere.device.model;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/** An EVK4 through libusb, on emulated USB. */
@Tag("emulator")
@ExtendWith(EmulatedUsb.class)
class LibusbEvkTest extends EvkScenarios {
  LibusbEvkTest() {
    super(EmulatedUsb.BUS);
  }
}
