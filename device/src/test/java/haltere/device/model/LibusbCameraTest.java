package haltere.device.model;

import static org.junit.jupiter.api.Assertions.assertTrue;

import haltere.testing.usb.TestBus;
import haltere.testing.usb.UsbEmulator;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;

/** The driver's scenarios through libusb, on emulated USB. */
@Tag("emulator")
class LibusbCameraTest extends CameraScenarios {
  private static final AtomicInteger NUMBER = new AtomicInteger(1);
  private static final UsbEmulator EMULATOR = emulator();
  private static final int OPEN_FILES_BEFORE = openFiles();

  private static UsbEmulator emulator() {
    try {
      return new UsbEmulator(Path.of(System.getenv("USBEMU_DIR")));
    } catch (IOException problem) {
      throw new IllegalStateException("run by ./gradlew :device:emulatorTest", problem);
    }
  }

  private static int openFiles() {
    String[] files = new File("/proc/self/fd").list();
    return files == null ? 0 : files.length;
  }

  @BeforeAll
  static void theEmulatorIsThereBeforeLibusb() {
    assertTrue(OPEN_FILES_BEFORE > 0);
  }

  @AfterAll
  static void noFileIsLeftOpen() {
    CameraScenarios.await(() -> openFiles() < OPEN_FILES_BEFORE + 30);
  }

  @Override
  TestBus bus() {
    return EMULATOR;
  }

  @Override
  int nextNumber() {
    return NUMBER.updateAndGet(number -> number >= 120 ? 2 : number + 1);
  }
}
