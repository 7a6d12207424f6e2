package haltere.device.model;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.extension.ExtendWith;

/** Loss, unplugging and closing through libusb, on emulated USB. */
@Tag("emulator")
@ExtendWith(EmulatedUsb.class)
class LibusbLossTest extends LossScenarios {
  LibusbLossTest() {
    super(EmulatedUsb.BUS);
  }
}
