package haltere.device.model;

import haltere.testing.usb.MemoryBus;
import haltere.testing.usb.TestBus;
import java.util.function.IntSupplier;

/**
 * The bus of a test.
 *
 * @param bus devices are plugged into it
 * @param numbers gives addresses that no test has used lately
 */
record BusUnderTest(TestBus bus, IntSupplier numbers) {
  /** A new one in memory. */
  static BusUnderTest inMemory() {
    int[] last = {1};
    return new BusUnderTest(new MemoryBus(), () -> ++last[0]);
  }
}
