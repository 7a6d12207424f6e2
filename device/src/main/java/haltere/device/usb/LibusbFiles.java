package haltere.device.usb;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;

/**
 * The file of libusb that usb4java writes into a temporary folder of its own. usb4java removes it
 * at a normal exit, but not if the program is stopped by Ctrl+C, as a recording is.
 */
final class LibusbFiles {
  private static final Path MAPS = Path.of("/proc/self/maps");

  private LibusbFiles() {}

  /** The files from which this process has loaded libusb; none if the system does not tell. */
  static List<Path> loaded() throws IOException {
    if (!Files.isReadable(MAPS)) {
      return List.of();
    }
    return Files.readAllLines(MAPS).stream()
        .filter(line -> line.matches(".* /.*/usb4java\\d+\\.tmp/libusb4java\\.so"))
        .map(line -> Path.of(line.substring(line.indexOf('/'))))
        .distinct()
        .toList();
  }

  /** Removes what is loaded: Linux keeps a mapped file until the process ends. */
  static void remove() {
    try {
      for (Path file : loaded()) {
        Files.deleteIfExists(file);
        Files.deleteIfExists(file.getParent());
      }
    } catch (IOException | InvalidPathException kept) {
      // usb4java removes it at a normal exit
    }
  }
}
