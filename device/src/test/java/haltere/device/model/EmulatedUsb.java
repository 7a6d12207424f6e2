package haltere.device.model;

import haltere.testing.usb.UsbEmulator;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;

/** The emulated USB of this program, which is there before libusb is. */
final class EmulatedUsb {
  static final UsbEmulator EMULATOR = emulator();
  private static final AtomicInteger NUMBER = new AtomicInteger(1);
  private static final int LAST_NUMBER = 120;

  private EmulatedUsb() {}

  private static UsbEmulator emulator() {
    try {
      return new UsbEmulator(Path.of(System.getenv("USBEMU_DIR")));
    } catch (IOException problem) {
      throw new IllegalStateException("run by ./gradlew :device:emulatorTest", problem);
    }
  }

  static int nextNumber() {
    return NUMBER.updateAndGet(number -> number >= LAST_NUMBER ? 2 : number + 1);
  }

  static int openFiles() {
    String[] files = new File("/proc/self/fd").list();
    return files == null ? 0 : files.length;
  }
}
