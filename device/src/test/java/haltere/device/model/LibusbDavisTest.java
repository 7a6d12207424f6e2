package haltere.device.model;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/** A DAVIS through libusb, on emulated USB. */
@Tag("emulator")
@ExtendWith(EmulatedUsb.class)
class LibusbDavisTest extends DavisScenarios {
  LibusbDavisTest() {
    super(EmulatedUsb.BUS);
  }
}
