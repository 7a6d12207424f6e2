package haltere.device.usb;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.usb4java.LibUsb;
import org.usb4java.Loader;

class LibusbFilesTest {
  @Test
  @EnabledOnOs(OS.LINUX)
  void libusbWorksAfterItsTemporaryFileIsRemoved() throws Exception {
    Loader.load();
    List<Path> files = LibusbFiles.loaded();
    LibusbFiles.remove();
    assertEquals(List.of(), LibusbFiles.loaded());
    for (Path file : files) {
      assertFalse(Files.exists(file.getParent()), file.toString());
    }
    assertTrue(Files.readString(Path.of("/proc/self/maps")).contains("/libusb4java.so (deleted)"));
    assertEquals(1, LibUsb.getVersion().major());
  }
}
