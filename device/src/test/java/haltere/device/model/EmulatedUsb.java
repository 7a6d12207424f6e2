package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.testing.usb.UsbEmulator;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.extension.AfterAllCallback;
import org.junit.jupiter.api.extension.BeforeAllCallback;
import org.junit.jupiter.api.extension.ExtensionContext;

/**
 * The emulated USB of this program, which is there before libusb is. As an extension of a test it
 * looks whether files are left open.
 */
final class EmulatedUsb implements BeforeAllCallback, AfterAllCallback {
  private static final int LAST_NUMBER = 120;
  private static final AtomicInteger NUMBER = new AtomicInteger(1);

  /** Libusb itself, and classes, keep a few open; a leak of one for each test or cycle is more. */
  private static final int FILES_OF_LIBUSB = 20;

  static final BusUnderTest BUS = new BusUnderTest(emulator(), EmulatedUsb::nextNumber);

  private int openFilesBefore;

  private static UsbEmulator emulator() {
    try {
      return new UsbEmulator(Path.of(System.getenv("USBEMU_DIR")));
    } catch (IOException problem) {
      throw new IllegalStateException("run by ./gradlew :device:emulatorTest", problem);
    }
  }

  private static int nextNumber() {
    return NUMBER.updateAndGet(number -> number >= LAST_NUMBER ? 2 : number + 1);
  }

  private static int openFiles() {
    String[] files = new File("/proc/self/fd").list();
    assertTrue(files != null, "this is for Linux");
    return files.length;
  }

  @Override
  public void beforeAll(ExtensionContext test) {
    openFilesBefore = openFiles();
  }

  @Override
  public void afterAll(ExtensionContext test) {
    CameraBench.await(() -> openFiles() < openFilesBefore + FILES_OF_LIBUSB);
  }
}
